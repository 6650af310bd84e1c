// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"

#include "aspects/uniqueness/actuated_plane.h"
#include "aspects/uniqueness/basic_regions.h"
#include "aspects/uniqueness/cusp_search.h"
#include "aspects/uniqueness/held_slice.h"
#include "aspects/uniqueness/singular_images.h"
#include "aspects/uniqueness/solution_regions.h"
#include "aspects/uniqueness/uniqueness_domains.h"
#include "aspects/uniqueness/uniqueness_problem.h"
#include "model/angles.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/working_mode.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

/// The plane of lengths, divided, with the basic component of each piece.
struct DividedPlane {
  StrutSlice struts;
  SingularImages images;
  ActuatedPlane plane;
  std::vector<SolutionSet> sets;
  std::vector<std::optional<std::size_t>> component_of;  // by piece

  DividedPlane(const StrutSlice& slice, double unknown_share, const MapControl& control)
      : struts(slice),
        images(struts),
        plane(struts, images, unknown_share, control),
        sets(find_solution_sets(struts, plane, control)),
        component_of(plane.pieces().size()) {}

  std::optional<std::size_t> component_at(const JointVector& actuated) const {
    const RoundingUpward rounding;
    const auto length = [&](std::size_t i) { return actuated[static_cast<Eigen::Index>(struts.leg(i))]; };
    const auto piece = plane.find({length(0), length(1)});
    return piece ? component_of[*piece] : std::nullopt;
  }
};

/// A pose of a slice, in the middle of a box.
Pose pose_of(const AnchorCircle& circle, const Box& box) {
  return circle.pose(pi * box.center(0), pi * box.center(1));
}

JointVector actuated_of(const Manipulator& manipulator, const HeldJoint& held, const Pose& pose,
                        const WorkingMode& mode) {
  JointVector q = inverse(manipulator, pose, mode).q;
  q[static_cast<Eigen::Index>(held.leg)] = held.value;
  return q;
}

class CuspsOfSlice {
 public:
  CuspsOfSlice(const Manipulator& manipulator, const MapSlice& slice)
      : manipulator_(manipulator),
        held_(*slice.joint),
        circle_(circle_of_anchor(manipulator, held_)),
        slice_(made_under_upward_rounding<HeldSlice>(manipulator, slice)) {}

  CuspList find(const MapControl& control) const {
    CuspList result;
    const CuspBoxes boxes = cusp_boxes(control);
    result.complete = !boxes.cancelled;
    for (const CuspBox& box : boxes.cusps) add(box, result);
    for (const CuspBox& box : boxes.undecided)
      if (within_limits(box) != Verdict::fails) result.complete = false;
    std::sort(result.cusps.begin(), result.cusps.end(), [](const Cusp& a, const Cusp& b) {
      return std::lexicographical_compare(a.actuated.data(), a.actuated.data() + a.actuated.size(),
                                          b.actuated.data(), b.actuated.data() + b.actuated.size());
    });
    return result;
  }

 private:
  CuspBoxes cusp_boxes(const MapControl& control) const {
    const RoundingUpward rounding;
    return find_cusp_boxes(slice_, control);
  }

  Verdict within_limits(const CuspBox& cusp) const {
    const RoundingUpward rounding;
    return slice_.within_limits(cusp.posture, SliceTurns(ranges_of(cusp.box)));
  }

  /// Nothing where it is not known of the leg whose joint is held.
  std::optional<WorkingMode> mode_of(const CuspBox& cusp) const {
    const RoundingUpward rounding;
    const int held_sign = slice_.held_sign(SliceTurns(ranges_of(cusp.box)));
    if (held_sign == 0) return std::nullopt;
    WorkingMode mode(manipulator_.leg_count());
    mode.set_sign(held_.leg, held_sign);
    for (std::size_t i = 0; i < 2; ++i) mode.set_sign(slice_.leg(i), cusp.posture[i]);
    return mode;
  }

  void add(const CuspBox& box, CuspList& result) const {
    const Verdict verdict = within_limits(box);
    const auto mode = mode_of(box);
    if (verdict == Verdict::unknown || !mode) result.complete = false;
    if (verdict != Verdict::holds || !mode) return;
    const Pose pose = pose_of(circle_, box.box);
    result.cusps.push_back({actuated_of(manipulator_, held_, pose, *mode), *mode, pose,
                            0.5 * pi * std::max(box.box.width(0), box.box.width(1))});
  }

  const Manipulator& manipulator_;
  HeldJoint held_;
  AnchorCircle circle_;
  HeldSlice slice_;
};

class SliceOfStruts {
 public:
  SliceOfStruts(const Manipulator& manipulator, const MapSlice& slice)
      : manipulator_(manipulator),
        held_(*slice.joint),
        circle_(circle_of_anchor(manipulator, held_)),
        struts_(made_under_upward_rounding<StrutSlice>(manipulator, slice)) {}

  /// Fills what is known of numbers of solutions.
  void find_regions(const MapControl& control, Uniqueness& result) const {
    const auto divided = divided_plane(control);
    double unknown = divided->plane.unknown();
    for (const SolutionSet& set : divided->sets) {
      if (!set.solutions) unknown += set.area;
      if (!set.solutions || set.solutions->empty()) continue;
      for (const PieceIndex piece : set.pieces) divided->component_of[piece] = result.basic_components.size();
      add_component(set, result);
    }
    result.component_of = [divided](const JointVector& q) { return divided->component_at(q); };
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

  std::shared_ptr<DividedPlane> divided_plane(const MapControl& control) const {
    const RoundingUpward rounding;
    return std::make_shared<DividedPlane>(struts_, unknown_share, control);
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

  Pose pose_of(const Box& box) const { return parallel_aspects::pose_of(circle_, box); }

  JointVector actuated_of(const Pose& pose) const {
    return parallel_aspects::actuated_of(manipulator_, held_, pose, working_modes(manipulator_).front());
  }

  void add_component(const SolutionSet& set, Uniqueness& result) const {
    const std::size_t solutions = set.solutions->size();
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

  const Manipulator& manipulator_;
  HeldJoint held_;
  AnchorCircle circle_;
  StrutSlice struts_;
};

/// What the slice has in place of the theorem.
void look_into_slice(const Manipulator& manipulator, const MapSlice& slice, const MapControl& control,
                     Uniqueness& result) {
  CuspList cusps = find_cusps(manipulator, slice, control);
  result.cusps = std::move(cusps.cusps);
  result.cusps_complete = cusps.complete;
  result.has_regions = has_struts_alone(manipulator);
  result.domains_complete = result.has_regions;
  if (!result.has_regions) return;
  const SliceOfStruts struts(manipulator, slice);
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

CuspList find_cusps(const Manipulator& manipulator, const MapSlice& slice, const MapControl& control) {
  return CuspsOfSlice(manipulator, slice).find(control);
}

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
