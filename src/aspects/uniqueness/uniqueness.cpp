// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/uniqueness.h"

#include "aspects/cusps/cusp_search.h"
#include "aspects/cusps/held_slice.h"
#include "aspects/uniqueness/cusp_aspect.h"
#include "aspects/uniqueness/mode_uniqueness.h"
#include "aspects/uniqueness/solution_numbers.h"
#include "aspects/uniqueness/strut_uniqueness.h"
#include "aspects/uniqueness/uniqueness_problem.h"
#include "model/angles.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

JointVector actuated_of(const Manipulator& manipulator, const HeldJoint& held, const Pose& pose,
                        const WorkingMode& mode) {
  JointVector q(static_cast<Eigen::Index>(manipulator.leg_count()));
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    const Eigen::Vector3d point = pose.position + pose.orientation * leg.anchor;
    q[static_cast<Eigen::Index>(j)] = joint_value(leg, point, mode.sign(j));  // by rounding just out of reach
  }
  q[static_cast<Eigen::Index>(held.leg)] = held.value;
  return q;
}

std::unique_ptr<const HeldSlice> held_slice_of(const Manipulator& manipulator, const HeldJoint& joint) {
  const RoundingUpward rounding;
  return make_held_slice(manipulator, joint);
}

class CuspsOfSlice {
 public:
  CuspsOfSlice(const Manipulator& manipulator, const HeldJoint& joint)
      : manipulator_(manipulator), held_(joint), slice_(held_slice_of(manipulator, held_)) {}

  CuspBoxes boxes(const MapControl& control) const {
    const RoundingUpward rounding;
    return find_cusp_boxes(*slice_, control);
  }

  /// Those within limits.
  CuspList list(const CuspBoxes& boxes) const {
    CuspList result;
    result.complete = !boxes.cancelled;
    result.leaves_curves = boxes.has_curves;
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
  Verdict within_limits(const CuspBox& cusp) const {
    const RoundingUpward rounding;
    return slice_->within_limits(cusp.posture, slice_->place(cusp.box));
  }

  /// Nothing where it is not known of the leg whose joint is held.
  std::optional<WorkingMode> mode_of(const CuspBox& cusp) const {
    const RoundingUpward rounding;
    return slice_->mode_of(cusp.posture, slice_->place(cusp.box));
  }

  void add(const CuspBox& box, CuspList& result) const {
    const Verdict verdict = within_limits(box);
    const auto mode = mode_of(box);
    if (verdict == Verdict::unknown || !mode) result.complete = false;
    if (verdict != Verdict::holds || !mode) return;
    const Pose pose = slice_->pose({box.box.center(0), box.box.center(1)});
    result.cusps.push_back({actuated_of(manipulator_, held_, pose, *mode), *mode, pose,
                            0.5 * pi * std::max(box.box.width(0), box.box.width(1))});
  }

  const Manipulator& manipulator_;
  HeldJoint held_;
  std::unique_ptr<const HeldSlice> slice_;
};

constexpr std::size_t default_most_cells = 250000;

/// What robots of SE2 have in place of the theorem.
void look_into(const Manipulator& manipulator, const UniquenessOptions& options, const MapControl& control,
               Uniqueness& result) {
  if (result.map->slice()) {
    const CuspsOfSlice slice(manipulator, *result.map->slice()->joint);
    const CuspBoxes boxes = slice.boxes(control);
    CuspList cusps = slice.list(boxes);
    result.cusps = std::move(cusps.cusps);
    result.cusps_complete = cusps.complete;
    for (Cusp& cusp : result.cusps) cusp.aspect = look_beside(*result.map, cusp).aspect;
    if (has_struts_alone(manipulator)) find_nodes(boxes.cusps, control, result);
  }
  const std::size_t most_cells = options.most_cells.value_or(default_most_cells);
  if (has_struts_alone(manipulator)) {
    find_regions_of_struts(most_cells, control, result);
  } else if (has_elbows(manipulator)) {
    result.domains_complete = false;
  } else if (result.map->slice()) {
    find_regions_of_slice(part_of(control, 0.3, 1.0), result);
  } else {
    find_regions_of_modes(most_cells, control, result);
  }
}

/// By the theorem.
void take_whole_aspects(Uniqueness& result) {
  result.at_most_one_a_sign = true;
  result.cusps_complete = result.nodes_complete = true;
  for (const Aspect& aspect : result.map->aspects()) result.domains.push_back({aspect.id, true, {}, 0.0});
}

}  // namespace

std::vector<std::size_t> Uniqueness::domains_of(std::size_t region) const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < domains.size(); ++i) {
    const auto& held = domains[i].basic_regions;
    if (std::find(held.begin(), held.end(), region) != held.end()) result.push_back(i);
  }
  return result;
}

DomainSharing Uniqueness::sharing(std::size_t region, std::size_t other) const {
  const BasicRegion &a = basic_regions[region], &b = basic_regions[other];
  for (const std::size_t domain : domains_of(region)) {
    const auto& held = domains[domain].basic_regions;
    if (std::find(held.begin(), held.end(), other) != held.end()) return DomainSharing::shared;
  }
  const bool other_aspect = a.aspect != b.aspect && a.aspect != 0 && b.aspect != 0;
  const bool is_apart = other_aspect || (region != other && a.over == b.over);
  return is_apart ? DomainSharing::apart : DomainSharing::unknown;
}

CuspList find_cusps(const Manipulator& manipulator, const HeldJoint& joint, const MapControl& control) {
  const CuspsOfSlice of(manipulator, joint);
  return of.list(of.boxes(control));
}

SolutionNumbers count_direct_solutions(const Manipulator& manipulator, const HeldJoint& joint,
                                       const MapControl& control) {
  if (has_elbows(manipulator)) return {};
  const RoundingUpward rounding;
  return find_solution_numbers(
      manipulator, std::make_shared<const SliceOfValues>(manipulator, joint), nullptr,
      [](const ValueStrip&) {}, control);
}

UniquenessResult compute_uniqueness(std::shared_ptr<const AspectMap> map, const UniquenessOptions& options,
                                    const MapControl& control) {
  const Manipulator& manipulator = *map->manipulator();
  UniquenessOptions of_map = options;
  of_map.slice = map->slice();
  const std::string problem = find_uniqueness_problem(manipulator, of_map);
  if (!problem.empty()) return {MapStatus::refused, problem, nullptr};
  Uniqueness result;
  result.map = std::move(map);
  if (has_one_solution_a_sign(manipulator.task_space()))
    take_whole_aspects(result);
  else
    look_into(manipulator, options, control, result);
  if (is_cancelled(control)) return {MapStatus::cancelled, "The computation was cancelled.", nullptr};
  return {MapStatus::complete, "", std::make_shared<const Uniqueness>(std::move(result))};
}

UniquenessResult compute_uniqueness(std::shared_ptr<const Manipulator> manipulator,
                                    const UniquenessOptions& options, const MapControl& control) {
  const std::string problem = find_uniqueness_problem(*manipulator, options);
  if (!problem.empty()) return {MapStatus::refused, problem, nullptr};
  MapOptions map_options;
  map_options.slice = options.slice;
  map_options.resolution = options.resolution;
  const double map_share = has_one_solution_a_sign(manipulator->task_space()) ? 1.0 : 0.1;
  const MapResult map = compute_aspect_map(manipulator, map_options, part_of(control, 0.0, map_share));
  if (!map) return {map.status, map.message, nullptr};
  return compute_uniqueness(map.map, options, part_of(control, map_share, 1.0));
}

}  // namespace parallel_aspects
