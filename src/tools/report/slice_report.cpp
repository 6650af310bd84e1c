// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/slice_report.h"

#include "tools/report/report.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {

nlohmann::json json_slice(const std::optional<MapSlice>& slice) {
  using nlohmann::json;
  if (!slice) return nullptr;
  json held = json::object();
  for (const HeldCoordinate& each : slice->held_coordinates) held[each.name] = json_number(each.value);
  json axis = nullptr;
  if (slice->rotation == MapSlice::Rotation::about_axis)
    axis = {slice->axis.x(), slice->axis.y(), slice->axis.z()};
  const bool freely = slice->rotation == MapSlice::Rotation::freely;
  return {{"held", held},
          {"axis", axis},
          {"free", freely ? std::vector<std::string>{"roll", "pitch", "yaw"} : coordinate_names(*slice)}};
}

}  // namespace parallel_aspects::tools
