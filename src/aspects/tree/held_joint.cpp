// SPDX-License-Identifier: BSD-3-Clause
#include "model/angles.h"
#include "model/message_text.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

bool is_coordinate(TaskSpace space, const std::string& name) {
  const std::vector<std::string> names = coordinate_names(space);
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string joints_of(const Manipulator& manipulator) {
  std::string text;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    text += (j == 0                             ? ""
             : j + 1 == manipulator.leg_count() ? " or "
                                                : ", ") +
            manipulator.leg(j).actuated_joint;
  return text;
}

/// What is held in SE2 and no pose coordinate: actuated joints, and names that nothing has.
std::vector<HeldCoordinate> others_of(const Manipulator& manipulator,
                                      const std::vector<HeldCoordinate>& held) {
  std::vector<HeldCoordinate> result;
  for (const HeldCoordinate& each : held)
    if (!is_coordinate(manipulator.task_space(), each.name)) result.push_back(each);
  return result;
}

/// Whether the anchor of a leg of SO3 moves on a circle about the center while the joint is held.
bool has_cone(const Leg& leg, double value) {
  constexpr double least_sine = 1e-6;  // of the angle between the anchor and the proximal point
  const Eigen::Vector3d c = leg.proximal_point(value);
  const double product = c.norm() * leg.anchor.norm();
  const double cosine =
      0.5 * (c.squaredNorm() + leg.anchor.squaredNorm() - leg.squared_distance(value)) / product;
  return leg.can_have(value) && product > held_joint_tolerance * held_joint_tolerance &&
         1.0 - cosine * cosine > least_sine * least_sine;
}

/// The value to hold instead: the same angle, some turns away, where that is within the limits, also as it is
/// written; else nothing.
std::string inside_by_turns(const Leg& leg, double value) {
  if (!leg.actuated_by_angle()) return "";
  constexpr int digits = 12;
  const JointLimits& limits = leg.limits;
  const double turns = std::isfinite(limits.lower) ? std::ceil((limits.lower - value) / full_turn)
                                                   : std::floor((limits.upper - value) / full_turn);
  const double inside = value + turns * full_turn, written = 1e-11 * std::max(1.0, std::abs(inside));
  return limits.contain(inside - written) && limits.contain(inside + written)
             ? ", as at " + number_text(inside, digits) + ", the same angle"
             : "";
}

}  // namespace

std::optional<std::size_t> leg_of_joint(const Manipulator& manipulator, const std::string& joint) {
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    if (manipulator.leg(j).actuated_joint == joint) return j;
  return std::nullopt;
}

Eigen::Vector2d AnchorCircle::rod(const Pose& pose) const noexcept {
  return pose.transform({anchor.x(), anchor.y(), 0.0}).head<2>() - center;
}

double AnchorCircle::distance(const Pose& pose) const noexcept { return rod(pose).norm() - radius; }

Pose AnchorCircle::pose(double direction, double phi) const noexcept {
  const Eigen::Vector2d at = center + radius * Eigen::Vector2d(std::cos(direction), std::sin(direction)) -
                             Eigen::Rotation2Dd(phi) * anchor;
  return Pose::planar(at.x(), at.y(), phi);
}

Pose AnchorCircle::nearest(const Pose& pose) const noexcept {
  const Eigen::Vector2d from_center = rod(pose);
  return this->pose(std::atan2(from_center.y(), from_center.x()),
                    2.0 * std::atan2(pose.orientation.z(), pose.orientation.w()));
}

AnchorCircle circle_of_anchor(const Manipulator& manipulator, const HeldJoint& joint) noexcept {
  const Leg& leg = manipulator.leg(joint.leg);
  const Eigen::Vector3d center = leg.proximal_point(joint.value);
  const double height = leg.anchor.z() - center.z();
  const double squared_radius = leg.squared_distance(joint.value) - height * height;
  return {center.head<2>(), std::sqrt(std::max(0.0, squared_radius)), leg.anchor.head<2>()};
}

std::string find_held_joint_problem(const Manipulator& manipulator, const HeldJoint& joint) {
  if (manipulator.task_space() != TaskSpace::SE2)
    return "A slice of " + std::string(name(manipulator.task_space())) +
           " can hold pose coordinates only; joints can be held in SE2.";
  return find_held_value_problem(manipulator, joint);
}

std::string find_held_value_problem(const Manipulator& manipulator, const HeldJoint& joint,
                                    const std::string& holder) {
  if (joint.leg >= manipulator.leg_count())
    return holder + " holds the joint of a leg that '" + manipulator.name() + "' does not have.";
  if (manipulator.tolerance() > 0.0)
    return "A slice that holds a joint has other poses for each robot within a tolerance; leave the "
           "tolerance "
           "out, or hold pose coordinates.";
  const Leg& leg = manipulator.leg(joint.leg);
  const std::string start =
      holder + " holds '" + leg.actuated_joint + "' at " + number_text(joint.value) + ", ";
  if (leg.kind().type == LegType::elbow)
    return holder + " holds '" + leg.actuated_joint +
           "', which is an actuated elbow; hold the joint of a crank, slide or strut.";
  if (!std::isfinite(joint.value))
    return holder + " holds '" + leg.actuated_joint + "' at no finite number; give one.";
  if (!leg.limits.contain(joint.value))
    return start + "outside of its limits, " + number_text(leg.limits.lower) + " to " +
           number_text(leg.limits.upper) + "; hold it inside" + inside_by_turns(leg, joint.value) + ".";
  if (manipulator.task_space() == TaskSpace::SO3)
    return has_cone(leg, joint.value)
               ? ""
               : start +
                     "where its leg lets the platform turn about one axis at most; hold another joint or "
                     "value.";
  if (!leg.can_have(joint.value) || !(circle_of_anchor(manipulator, joint).radius > held_joint_tolerance))
    return start + "where its leg has no length in the plane; give another value.";
  return "";
}

MapSlice make_slice(const Manipulator& manipulator, const std::vector<HeldCoordinate>& held,
                    Problems& problems) {
  const TaskSpace space = manipulator.task_space();
  const std::vector<HeldCoordinate> others = others_of(manipulator, held);
  if (others.empty() || (space != TaskSpace::SE2 && !leg_of_joint(manipulator, others.front().name)))
    return make_slice(space, held, problems);
  const HeldCoordinate& first = others.front();
  const std::optional<std::size_t> leg = leg_of_joint(manipulator, first.name);
  MapSlice slice;
  if (!leg)
    problems.push_back("'" + manipulator.name() + "' has no pose coordinate or actuated joint '" +
                       first.name + "'; hold some of x, y and phi, or one of " + joints_of(manipulator) +
                       ".");
  else if (held.size() > 1)
    problems.push_back("The slice holds the joint '" + first.name +
                       "' and more; hold that joint alone, or pose coordinates.");
  if (!leg || held.size() > 1) return slice;
  slice.joint = HeldJoint{*leg, first.value, manipulator.leg(*leg).actuated_by_angle()};
  slice.rotation = MapSlice::Rotation::about_axis;
  slice.held_coordinates = held;
  const std::string problem = find_held_joint_problem(manipulator, *slice.joint);
  if (problem.empty())
    slice.held = circle_of_anchor(manipulator, *slice.joint).pose(0.0, 0.0);
  else
    problems.push_back(problem);
  return slice;
}

}  // namespace parallel_aspects
