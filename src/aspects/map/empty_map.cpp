// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/empty_map.h"

#include "aspects/map/map_contents.h"
#include "model/message_text.h"
#include "model/task_space_traits.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double parts = 32.0;  // along the longest edge of a coarse map

/// The positions that were searched; nothing where none is free.
std::optional<Box> positions_of(const AspectMap& map) {
  Box positions = map.region();
  positions.dimension =
      map.slice() ? map.slice()->free_positions() : directions(map.manipulator()->task_space());
  return positions.dimension > 0 ? std::optional<Box>(positions) : std::nullopt;
}

/// A map of the same region with these constraints alone, as coarse as shows whether anything is there.
MapResult coarse_map(const AspectMap& map, ConstraintKinds kinds, const MapControl& control) {
  MapOptions options;
  options.region = positions_of(map);
  options.slice = map.slice();
  options.modes = map.contents().modes;
  options.extra_levels = 0;
  double longest = 0.0;
  for (std::size_t i = 0; options.region && i < options.region->dimension; ++i)
    longest = std::max(longest, options.region->width(i));
  options.resolution = std::max(map.resolution(), longest / parts);
  return compute_aspect_map(map.manipulator()->with_constraints(kinds), options, {{}, control.cancelled});
}

bool has_aspect(const MapResult& result) { return result && !result.map->aspects().empty(); }

std::string names_of(const std::vector<ConstraintKind>& kinds) {
  std::vector<std::string> names;
  for (const ConstraintKind kind : kinds) names.emplace_back(name(kind));
  return enumerated(names);
}

bool is_apart(const Box& region, const Box& reach) {
  for (std::size_t i = 0; i < reach.dimension; ++i)
    if (region.upper[i] <= reach.lower[i] || reach.upper[i] <= region.lower[i]) return true;
  return false;
}

/// "x from -4 to 13 m and y from -13 to 13 m".
std::string ranges_text(const std::vector<std::string>& names, const Box& box) {
  std::vector<std::string> ranges;
  for (std::size_t i = 0; i < box.dimension; ++i)
    ranges.push_back(names[i] + " from " + number_text(box.lower[i], 4) + " to " +
                     number_text(box.upper[i], 4) + " m");
  return enumerated(ranges);
}

/// Where no constraint alone leaves nothing.
std::string beyond_reach(const AspectMap& map, const MapResult& without_constraints) {
  const bool proved_empty = map.manipulator()->constraint_kinds().none()
                                ? map.count_at_most() == std::size_t{0}
                                : without_constraints && without_constraints.map->measure_undecided() == 0.0;
  if (!proved_empty)
    return "No pose is proved to lie in an aspect at this resolution; map at a finer one, or where more room "
           "is.";
  const std::string where = map.slice() ? "the slice" : "the region";
  return "No pose of " + where + " is within reach of all legs and away from singularities; " +
         (map.slice() ? "hold other values." : "give another region, or check the lengths of the legs.");
}

std::string kept_out(const std::vector<ConstraintKind>& kinds, const std::string& where) {
  const bool one = kinds.size() == 1;
  return (one ? "Constraint " : "Constraints ") + names_of(kinds) + (one ? " leaves" : " together leave") +
         " nothing of what the legs reach in " + where + "; loosen " + (one ? "it" : "one") +
         ", or leave it out.";
}

}  // namespace

std::string why_out_of_reach(const Box& region, const std::optional<Box>& reach,
                             const std::vector<std::string>& names) {
  if (!reach || !is_apart(region, *reach)) return "";
  return "The region lies outside of what the legs can reach, which is within " + ranges_text(names, *reach) +
         "; give another region, or leave it out.";
}

std::string why_empty(const AspectMap& map, const MapControl& control) {
  if (!map.aspects().empty()) return "";
  const std::optional<Box> reach = map.contents().classifier->reachable_positions(),
                           region = positions_of(map);
  if (const std::string text = region ? why_out_of_reach(*region, reach, map.coordinates()) : "";
      !text.empty())
    return text;
  const ConstraintKinds all = map.manipulator()->constraint_kinds();
  std::vector<ConstraintKind> present, decisive;
  for (const ConstraintKind kind : all_constraint_kinds)
    if (all[index_of(kind)]) present.push_back(kind);
  for (const ConstraintKind kind : present)
    if (has_aspect(coarse_map(map, ConstraintKinds(all).reset(index_of(kind)), control)))
      decisive.push_back(kind);
  const MapResult free = decisive.empty() && !present.empty() ? coarse_map(map, {}, control) : MapResult();
  if (is_cancelled(control)) return "";
  if (decisive.empty() && !has_aspect(free)) return beyond_reach(map, free);
  return kept_out(decisive.empty() ? present : decisive, map.slice() ? "the slice" : "the region");
}

}  // namespace parallel_aspects
