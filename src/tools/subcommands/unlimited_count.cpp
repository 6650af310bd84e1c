// SPDX-License-Identifier: BSD-3-Clause
#include "tools/subcommands/unlimited_count.h"

#include "tools/computation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

// Of the smallest ones in the region, all of which the second map could take at most: 256 by 256.
constexpr double max_boxes_to_count = 65536.0;

// With six legs a box takes some twenty times as long.
constexpr double max_boxes_with_six_legs = 4096.0;

// Of unit quaternions: four charts, each from -1 to 1 in three coordinates.
constexpr double charts = 4.0, width_of_chart = 2.0;

double smallest_boxes(const AspectMap& map) {
  const Box region = map.region();
  if (region.dimension == 0) return charts * std::pow(width_of_chart / map.resolution(), 3.0);
  double count = 1.0;
  for (std::size_t k = 0; k < region.dimension; ++k)
    count *= std::max(1.0, (region.upper[k] - region.lower[k]) / map.resolution());
  return count;
}

// By the region alone: how many leaves a map has within limits, or what time it took, tells little of that
// without them.
bool is_cheap(const AspectMap& map) {
  const bool six_legs = map.manipulator()->leg_count() == max_legs;
  return smallest_boxes(map) <= (six_legs ? max_boxes_with_six_legs : max_boxes_to_count);
}

ConstraintKinds limits_of_joints(const Manipulator& manipulator) {
  ConstraintKinds kinds;
  kinds[index_of(ConstraintKind::actuated_limits)] = kinds[index_of(ConstraintKind::passive_limits)] = true;
  return kinds & manipulator.constraint_kinds();
}

// Nothing where no position is free.
std::optional<Box> searched_positions(const AspectMap& map) {
  Box positions = map.region();
  positions.dimension =
      map.slice() ? map.slice()->free_positions() : directions(map.manipulator()->task_space());
  return positions.dimension > 0 ? std::optional<Box>(positions) : std::nullopt;
}

// "A" or "A,B" and the like.
std::string listed(ConstraintKinds kinds, const std::string& between, const std::string& after) {
  std::string text;
  for (const ConstraintKind kind : all_constraint_kinds)
    if (kinds[index_of(kind)]) text += (text.empty() ? "" : between) + std::string(name(kind)) + after;
  return text;
}

}  // namespace

void add_count_without_limits(const AspectMap& map, MapOptions options, bool asked_for,
                              const Surroundings& surroundings, Report& report) {
  const Manipulator& manipulator = *map.manipulator();
  const ConstraintKinds limits = limits_of_joints(manipulator);
  if (limits.none() || !(asked_for || is_cheap(map))) return;
  options.region = searched_positions(map);
  options.complete = false;
  const auto free = manipulator.with_constraints(manipulator.constraint_kinds() & ~limits);
  const auto result = completed(
      surroundings, [&](const MapControl& control) { return compute_aspect_map(free, options, control); });
  const std::size_t count = result.map->aspects().size();
  report.json["without_limits"] = {{"components", count}, {"left_out", json::array()}};
  for (const ConstraintKind kind : all_constraint_kinds)
    if (limits[index_of(kind)]) report.json["without_limits"]["left_out"].push_back(name(kind));
  if (count == map.aspects().size()) return;
  report.text += "\nwithout limits of joints there are " + std::to_string(count) + " in place of " +
                 counted(map.aspects().size(), "component") + " here; --no-constraint " +
                 listed(limits, ",", "") + " leaves them out, and so does constraints: {" +
                 listed(limits, ", ", ": false") + "} in the YAML\n";
}

}  // namespace parallel_aspects::tools
