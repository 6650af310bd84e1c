// SPDX-License-Identifier: BSD-3-Clause
#include "tools/subcommands/unlimited_count.h"

#include "tools/computation.h"

#include <optional>
#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

constexpr double not_long = 1.0;  // [s]

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

void add_count_without_limits(const AspectMap& map, MapOptions options, const Surroundings& surroundings,
                              Report& report) {
  const Manipulator& manipulator = *map.manipulator();
  const ConstraintKinds limits = limits_of_joints(manipulator);
  if (limits.none() || (map.region().dimension > 2 && map.seconds() > not_long)) return;
  options.region = searched_positions(map);
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
