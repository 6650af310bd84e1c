// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"

#include "aspects/uniqueness/actuated_plane.h"
#include "aspects/uniqueness/basic_regions.h"
#include "aspects/uniqueness/cusp_search.h"
#include "aspects/uniqueness/singular_images.h"
#include "aspects/uniqueness/solution_regions.h"
#include "aspects/uniqueness/uniqueness_domains.h"
#include "aspects/uniqueness/uniqueness_problem.h"
#include "model/angles.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/working_mode.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace parallel_aspects {
namespace {

class SliceOfStruts {
 public:
  SliceOfStruts(const Manipulator& manipulator, const MapSlice& slice)
      : manipulator_(manipulator),
        held_(*slice.joint),
        struts_(made_under_upward_rounding<StrutSlice>(manipulator, slice)) {}

  /// Fills what is known of cusps; not where it is cancelled.
  void find_cusps(const MapControl& control, Uniqueness& result) const {
    const CuspBoxes boxes = cusp_boxes(control);
    result.cusps_complete = boxes.undecided.empty() && !boxes.cancelled;
    for (const Box& box : boxes.cusps) add_cusp(box, result);
    for (const Box& box : boxes.undecided)
      if (within_limits(box) != Verdict::fails) result.cusps_complete = false;
    std::sort(result.cusps.begin(), result.cusps.end(), [](const Cusp& a, const Cusp& b) {
      return std::lexicographical_compare(a.actuated.data(), a.actuated.data() + a.actuated.size(),
                                          b.actuated.data(), b.actuated.data() + b.actuated.size());
    });
  }

  /// Fills what is known of numbers of solutions.
  void find_regions(const MapControl& control, Uniqueness& result) const {
    double unknown = 0.0;
    for (const SolutionSet& set : solution_sets(control, unknown)) {
      if (set.solutions)
        add_component(set, result);
      else
        unknown += set.area;
    }
    result.measure_unknown = unknown * rounded_up;
    for (SolutionRegion& region : result.regions)
      region.measure_upper = (region.measure_lower + unknown) * rounded_up;
    std::sort(result.regions.begin(), result.regions.end(),
              [](const SolutionRegion& a, const SolutionRegion& b) { return a.solutions < b.solutions; });
  }

  /// Fills basic regions and uniqueness domains.
  void find_domains(const MapControl& control, Uniqueness& result) const {
    const auto aspect_of = [&](const Box& box) { return aspect_at(*result.map, box); };
    std::vector<SolutionSet> sets;
    const FoundRegions found = basic_regions(aspect_of, control, sets);
    for (const FoundRegion& region : found.regions) {
      const Pose pose = pose_of((*sets[region.set].solutions)[region.solution]);
      result.basic_regions.push_back({region.aspect, pose, actuated_of(pose), region.area * rounded_down});
    }
    const FoundDomains domains = find_uniqueness_domains(found);
    result.domains_complete = domains.complete;
    for (const auto& regions : domains.domains) {
      UniquenessDomain domain{found.regions[regions.front()].aspect, false, regions, 0.0};
      for (const std::size_t region : regions)
        domain.measure_lower += result.basic_regions[region].measure_lower * rounded_down;
      result.domains.push_back(std::move(domain));
    }
  }

 private:
  // Of the plane of lengths, for areas and for basic regions, which take more time a cell.
  static constexpr double unknown_share = 1e-4, unknown_share_of_regions = 2e-3;

  // Basic regions over sets that are a smaller share of the plane are left out: beside strips there are many.
  static constexpr double least_set_share = 1e-4;

  // Sums of many areas are off by less.
  static constexpr double rounded_up = 1.0 + 1e-9, rounded_down = 1.0 - 1e-9;

  std::vector<SolutionSet> solution_sets(const MapControl& control, double& unknown) const {
    const RoundingUpward rounding;
    SingularImages images(struts_);
    ActuatedPlane plane(struts_, images, unknown_share, control);
    unknown = plane.unknown();
    return find_solution_sets(struts_, plane, control);
  }

  FoundRegions basic_regions(const std::function<int(const Box&)>& aspect_of, const MapControl& control,
                             std::vector<SolutionSet>& sets) const {
    const RoundingUpward rounding;
    SingularImages images(struts_);
    ActuatedPlane plane(struts_, images, unknown_share_of_regions, control);
    sets = find_solution_sets(struts_, plane, control);
    const double least = least_set_share * plane.cells()[0].box.measure();
    for (SolutionSet& set : sets)
      if (set.area < least) set.solutions.reset();
    return find_basic_regions(struts_, plane, sets, aspect_of, control);
  }

  int aspect_at(const AspectMap& map, const Box& box) const {
    return map.locate(pose_of(box), working_modes(manipulator_).front()).aspect;
  }

  Pose pose_of(const Box& box) const {
    return circle_of_anchor(manipulator_, held_).pose(pi * box.center(0), pi * box.center(1));
  }

  JointVector actuated_of(const Pose& pose) const {
    JointVector q = inverse(manipulator_, pose, working_modes(manipulator_).front()).q;
    q[static_cast<Eigen::Index>(held_.leg)] = held_.value;
    return q;
  }

  void add_component(const SolutionSet& set, Uniqueness& result) const {
    const std::size_t solutions = set.solutions->size();
    if (solutions == 0) return;
    BasicComponent component;
    for (const Box& box : *set.solutions) {
      component.solutions.push_back(pose_of(box));
      component.aspects.push_back(aspect_at(*result.map, box));
    }
    component.inside = actuated_of(component.solutions.front());
    component.measure = set.estimate;
    component.measure_lower = set.area * rounded_down;
    auto region = std::find_if(result.regions.begin(), result.regions.end(),
                               [&](const SolutionRegion& each) { return each.solutions == solutions; });
    if (region == result.regions.end()) region = result.regions.insert(region, {solutions, 0.0, 0.0, 0.0});
    region->measure += component.measure;
    region->measure_lower += component.measure_lower;
    result.basic_components.push_back(std::move(component));
  }

  CuspBoxes cusp_boxes(const MapControl& control) const {
    const RoundingUpward rounding;
    return find_cusp_boxes(struts_, control);
  }

  Verdict within_limits(const Box& box) const {
    const RoundingUpward rounding;
    const SliceTurns turns(ranges_of(box));
    return both(struts_.within_limits(0, struts_.half_square<0>(0, turns).value()),
                struts_.within_limits(1, struts_.half_square<0>(1, turns).value()));
  }

  void add_cusp(const Box& box, Uniqueness& result) const {
    const Verdict verdict = within_limits(box);
    if (verdict == Verdict::unknown) result.cusps_complete = false;
    if (verdict != Verdict::holds) return;
    Cusp cusp;
    cusp.pose = pose_of(box);
    cusp.actuated = actuated_of(cusp.pose);
    cusp.accuracy = 0.5 * pi * std::max(box.width(0), box.width(1));
    result.cusps.push_back(cusp);
  }

  const Manipulator& manipulator_;
  HeldJoint held_;
  StrutSlice struts_;
};

/// What the slice has in place of the theorem.
void look_into_slice(const Manipulator& manipulator, const MapSlice& slice, const MapControl& control,
                     Uniqueness& result) {
  const SliceOfStruts struts(manipulator, slice);
  struts.find_cusps(control, result);
  struts.find_regions(control, result);
  if (!is_cancelled(control)) struts.find_domains(control, result);
}

/// By the theorem.
void take_whole_aspects(Uniqueness& result) {
  result.at_most_one_a_sign = true;
  result.cusps_complete = true;
  for (const Aspect& aspect : result.map->aspects()) result.domains.push_back({aspect.id, true, {}, 0.0});
}

}  // namespace

UniquenessResult compute_uniqueness(std::shared_ptr<const Manipulator> manipulator,
                                    const UniquenessOptions& options, const MapControl& control) {
  const std::string problem = find_uniqueness_problem(*manipulator, options);
  if (!problem.empty()) return {MapStatus::refused, problem, nullptr};
  MapOptions map_options;
  map_options.slice = options.slice;
  map_options.resolution = options.resolution;
  const MapResult map = compute_aspect_map(manipulator, map_options, control);
  if (!map) return {map.status, map.message, nullptr};
  Uniqueness result;
  result.map = map.map;
  if (has_one_solution_a_sign(manipulator->task_space()))
    take_whole_aspects(result);
  else
    look_into_slice(*manipulator, *options.slice, control, result);
  if (is_cancelled(control)) return {MapStatus::cancelled, "The computation was cancelled.", nullptr};
  return {MapStatus::complete, "", std::make_shared<const Uniqueness>(std::move(result))};
}

}  // namespace parallel_aspects
