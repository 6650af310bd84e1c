// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/uniqueness/strut_uniqueness.h"

#include "aspects/cusps/cusp_search.h"
#include "aspects/cusps/planar_held_slice.h"
#include "aspects/enclosures/strut_images.h"
#include "aspects/regions/basic_regions.h"
#include "aspects/regions/found_regions.h"
#include "aspects/solutions/actuated_space.h"
#include "aspects/solutions/solution_regions.h"
#include "aspects/solutions/strut_solutions.h"
#include "aspects/uniqueness/node_search.h"
#include "aspects/uniqueness/path_in_regions.h"
#include "aspects/uniqueness/solution_numbers.h"
#include "interval/interval.h"
#include "model/angles.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

/// How far lengths are divided, and which sets are examined, as shares of all lengths.
struct Division {
  double unknown_share, least_set_share;
  std::size_t most_cells;
};

// Beside strips there are many sets that are tiny.
Division division_for_numbers(const AspectMap& map, std::size_t most_cells) {
  if (map.slice()) return {1e-4, 0.0, most_cells};
  return {2e-3, 1e-6, most_cells};
}

// Basic regions take more time a cell.
Division division_for_regions(const AspectMap& map, std::size_t most_cells) {
  return {map.slice() ? 2e-3 : 1e-2, 1e-4, most_cells / 4};
}

StrutSlice struts_of(const AspectMap& map) {
  return map.slice() ? StrutSlice(*map.manipulator(), *map.slice()) : StrutSlice(*map.manipulator(), 0);
}

/// Lengths, divided, with the sets that the pieces form. Made under a live `RoundingUpward`.
struct DividedStruts {
  StrutSlice struts;
  StrutPoses poses;
  StrutEquations equations;
  StrutImages images;
  ActuatedSpace space;
  std::vector<SolutionSet> sets;

  DividedStruts(const AspectMap& map, const Division& division, const MapControl& control)
      : struts(struts_of(map)),
        poses(*map.manipulator(), struts, map.slice() ? map.slice()->joint->value : 0.0),
        equations(struts),
        images(struts),
        space(images, division.unknown_share, control, division.most_cells),
        sets(find_solution_sets(solver(), space, control, division.least_set_share)) {}

  SolveAt solver() const {
    return [this](const Lengths& lengths) { return find_all_solutions(struts, lengths); };
  }
};

/// With the basic component of each piece.
struct DividedNumbers : DividedStruts {
  std::shared_ptr<const AspectMap> map;  // whose robot the poses are of
  std::vector<std::optional<std::size_t>> component_of;

  DividedNumbers(std::shared_ptr<const AspectMap> made, std::size_t most_cells, const MapControl& control)
      : DividedStruts(*made, division_for_numbers(*made, most_cells), control),
        map(std::move(made)),
        component_of(space.pieces().size()) {}

  std::optional<std::size_t> component_at(const JointVector& actuated) const {
    const RoundingUpward rounding;
    const auto piece = space.find(poses.lengths(actuated));
    return piece ? component_of[*piece] : std::nullopt;
  }
};

/// Of struts, which have one working mode.
int aspect_at(const AspectMap& map, const Pose& pose) {
  return aspect_at(map, pose, working_modes(*map.manipulator()).front());
}

/// With the basic regions.
struct DividedRegions : DividedStruts {
  std::shared_ptr<const AspectMap> map;
  RegionAtlas atlas;

  DividedRegions(std::shared_ptr<const AspectMap> made, std::size_t most_cells, const MapControl& control)
      : DividedStruts(*made, division_for_regions(*made, most_cells), part_of(control, 0.0, 0.3)),
        map(std::move(made)),
        atlas(
            equations, solver(), space, sets,
            [this](const Box& box, const Lengths& at) { return aspect_at(*map, poses.pose(box, at)); },
            part_of(control, 0.3, 1.0)) {}

  std::optional<std::size_t> region_at(const Pose& pose) const {
    const JointVector actuated = poses.actuated(pose);
    if (actuated.size() == 0 || !actuated.allFinite()) return std::nullopt;
    const RoundingUpward rounding;
    return atlas.locate(poses.box_about(pose), poses.lengths(actuated));
  }
};

/// Of all poses, not of a slice.
std::optional<std::vector<std::size_t>> regions_along(const DividedRegions& divided,
                                                      const std::vector<Pose>& path) {
  const PathInRegions::Locate locate = [&](const Pose& pose) { return divided.region_at(pose); };
  const RoundingUpward rounding;
  PathInRegions proof(divided.space, locate);
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    if (!proof.add({*divided.map->manipulator(), divided.struts, path[i], path[i + 1]})) return std::nullopt;
  std::set<std::size_t> sets;
  for (const std::size_t region : proof.regions()) {
    const FoundRegion& found = divided.atlas.found().regions[region];
    if (!found.is_unique || !sets.insert(found.set).second) return std::nullopt;
    if (found.aspect != divided.atlas.found().regions[*proof.regions().begin()].aspect) return std::nullopt;
  }
  if (!proof.crosses_apart()) return std::nullopt;
  return std::vector<std::size_t>(proof.regions().begin(), proof.regions().end());
}

template <class Divided>
std::shared_ptr<Divided> divided(const std::shared_ptr<const AspectMap>& map, std::size_t most_cells,
                                 const MapControl& control) {
  const RoundingUpward rounding;
  return std::make_shared<Divided>(map, most_cells, control);
}

BasicComponent component_of_set(const DividedNumbers& numbers, const SolutionSet& set) {
  BasicComponent component;
  for (const Box& box : *set.solutions) {
    component.solutions.push_back(numbers.poses.pose(box, set.inside));
    component.aspects.push_back(aspect_at(*numbers.map, component.solutions.back()));
  }
  component.inside = numbers.poses.actuated(component.solutions.front());
  component.measure = set.estimate;
  component.measure_lower = set.measure * rounded_down;
  return component;
}

void find_numbers(std::size_t most_cells, const MapControl& control, Uniqueness& result) {
  const auto numbers = divided<DividedNumbers>(result.map, most_cells, control);
  for (const SolutionSet& set : numbers->sets) {
    if (!set.solutions || set.solutions->empty()) continue;
    for (const PieceIndex piece : set.pieces) numbers->component_of[piece] = result.basic_components.size();
    add_component(component_of_set(*numbers, set), result);
  }
  result.component_of = [numbers](const JointVector& q, const WorkingMode& /*the only one*/) {
    return numbers->component_at(q);
  };
  set_unknown(measure_without_number(numbers->space, numbers->sets), result);
}

BasicRegion region_of(const DividedRegions& divided, const FoundRegion& found) {
  const SolutionSet& set = divided.sets[found.set];
  const Pose pose = divided.poses.pose((*set.solutions)[found.solution], set.inside);
  return {found.aspect,   found.set, pose, divided.poses.actuated(pose), found.measure * rounded_down,
          found.is_unique};
}

void find_domains(std::size_t most_cells, const MapControl& control, Uniqueness& result) {
  const auto regions = divided<DividedRegions>(result.map, most_cells, control);
  for (const FoundRegion& region : regions->atlas.found().regions)
    result.basic_regions.push_back(region_of(*regions, region));
  result.region_of = [regions](const Pose& pose, const WorkingMode& /*the only one*/) {
    return regions->region_at(pose);
  };
  if (!result.map->slice())
    result.regions_along = [regions](const std::vector<Pose>& path) { return regions_along(*regions, path); };
  add_domains(find_uniqueness_domains(regions->atlas.found()), result);
}

}  // namespace

void find_nodes(const std::vector<CuspBox>& cusps, const MapControl& control, Uniqueness& result) {
  const RoundingUpward rounding;
  const Manipulator& robot = *result.map->manipulator();
  const MapSlice& of_map = *result.map->slice();
  const StrutSlice slice(robot, of_map);
  const PlanarHeldSlice held(robot, *of_map.joint);
  const StrutPoses poses(robot, slice, of_map.joint->value);
  const auto within_limits = [&held](const Box& box) {
    return held.within_limits(held.postures().front(), held.place(box));
  };
  std::vector<Box> about_cusps;
  for (const CuspBox& cusp : cusps) about_cusps.push_back(cusp.box);
  const NodeBoxes found = find_node_boxes(slice, about_cusps, control);
  result.has_nodes = true;
  result.nodes_complete = !found.cancelled;
  for (const auto& [first, second] : found.undecided)
    if (within_limits(first) != Verdict::fails && within_limits(second) != Verdict::fails)
      result.nodes_complete = false;
  for (const auto& [first, second] : found.nodes) {
    const Verdict verdict = within_limits(first);
    if (verdict == Verdict::unknown) result.nodes_complete = false;
    if (verdict != Verdict::holds) continue;
    const Pose pose = poses.pose(first, {});
    const double width = std::max({first.width(0), first.width(1), second.width(0), second.width(1)});
    result.nodes.push_back({poses.actuated(pose), {pose, poses.pose(second, {})}, 0.5 * pi * width});
  }
  std::sort(result.nodes.begin(), result.nodes.end(), [](const SolutionNode& a, const SolutionNode& b) {
    return std::lexicographical_compare(a.actuated.data(), a.actuated.data() + a.actuated.size(),
                                        b.actuated.data(), b.actuated.data() + b.actuated.size());
  });
}

void find_regions_of_struts(std::size_t most_cells, const MapControl& control, Uniqueness& result) {
  result.has_regions = result.has_domains = true;
  result.region_unit = result.map->slice() ? "m^2" : "m^3";
  find_numbers(most_cells, part_of(control, 0.0, 0.4), result);
  if (!is_cancelled(control)) find_domains(most_cells, part_of(control, 0.4, 1.0), result);
}

}  // namespace parallel_aspects
