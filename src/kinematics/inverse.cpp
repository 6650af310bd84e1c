// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/inverse.h"

#include "model/angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace parallel_aspects {
namespace {

double square(double x) { return x * x; }

// With r the crank, R the rod and n the axis: h^2 = ((r+R)^2 - |d|^2)(|d|^2 - (r-R)^2)/4 - r^2 (d.n)^2.
double squared_entry(const RevoluteActuation& actuation, const Leg& leg, const Eigen::Vector3d& d) {
  const double w = d.squaredNorm();
  return 0.25 * (square(actuation.radius + leg.rod_length) - w) *
             (w - square(actuation.radius - leg.rod_length)) -
         square(actuation.radius * actuation.axis.dot(d));
}

double squared_entry(const PrismaticActuation& actuation, const Leg& leg, const Eigen::Vector3d& d) {
  return square(leg.rod_length) - actuation.direction.cross(d).squaredNorm();
}

double squared_entry(const StrutActuation&, const Leg&, const Eigen::Vector3d& d) { return d.squaredNorm(); }

double squared_entry(const ElbowActuation& actuation, const Leg&, const Eigen::Vector3d& d) {
  const double w = d.squaredNorm();
  return 0.25 * (square(actuation.inner_length + actuation.outer_length) - w) *
         (w - square(actuation.inner_length - actuation.outer_length));
}

double value(const RevoluteActuation& actuation, const Leg& leg, const Eigen::Vector3d& d, double entry) {
  const double d1 = actuation.zero_direction.dot(d);
  const double d2 = actuation.axis.cross(actuation.zero_direction).dot(d);
  const double a = 0.5 * (d.squaredNorm() + square(actuation.radius) - square(leg.rod_length));
  return std::atan2(a * d2 - entry * d1, a * d1 + entry * d2);
}

double value(const PrismaticActuation& actuation, const Leg&, const Eigen::Vector3d& d, double entry) {
  return actuation.direction.dot(d) - entry;
}

double value(const StrutActuation& actuation, const Leg&, const Eigen::Vector3d& d, double) {
  return actuation.sense * (d.norm() - actuation.length_at_zero);
}

double value(const ElbowActuation& actuation, const Leg&, const Eigen::Vector3d& d, double entry) {
  const double cosine =
      0.5 * (d.squaredNorm() - square(actuation.inner_length) - square(actuation.outer_length));
  const double angle = std::atan2(-actuation.sense * entry, cosine);
  return std::remainder(actuation.sense * (angle - actuation.angle_at_zero), full_turn);
}

// The turn of `angle` that is inside the limits, or else the angle itself.
double turned_into(const JointLimits& limits, double angle) {
  if (limits.contain(angle) || !limits.limited()) return angle;
  const double candidate = std::isfinite(limits.lower)
                               ? angle + full_turn * std::ceil((limits.lower - angle) / full_turn)
                               : angle + full_turn * std::floor((limits.upper - angle) / full_turn);
  return limits.contain(candidate) ? candidate : angle;
}

// One leg on one branch.
struct LegSolution {
  InverseStatus status = InverseStatus::out_of_reach;
  double q = 0.0;
};

LegSolution leg_solution(const Leg& leg, const Pose& pose, int sign) {
  const Eigen::Vector3d point = pose.transform(leg.anchor);
  if (!(squared_inverse_entry(leg, point) >= 0.0)) return {};
  const double q = joint_value(leg, point, sign);
  return {leg.limits.contain(q) ? InverseStatus::solved : InverseStatus::outside_limits, q};
}

// `solve(j, sign)` gives leg j on that branch. A leg out of reach outweighs one outside its limits.
template <class Solve>
InverseSolution combined(const WorkingMode& mode, const Solve& solve) {
  const std::size_t legs = mode.leg_count();
  InverseSolution solution{InverseStatus::solved, mode, JointVector(static_cast<Eigen::Index>(legs)), 0};
  for (std::size_t j = 0; j < legs; ++j) {
    const LegSolution leg = solve(j, mode.sign(j));
    if (leg.status == InverseStatus::out_of_reach) return {leg.status, mode, {}, j};
    solution.q[static_cast<Eigen::Index>(j)] = leg.q;
    if (leg.status == InverseStatus::solved || solution.status != InverseStatus::solved) continue;
    solution.status = leg.status;
    solution.leg = j;
  }
  return solution;
}

}  // namespace

double squared_inverse_entry(const Leg& leg, const Eigen::Vector3d& point) noexcept {
  const Eigen::Vector3d d = point - leg.base_point();
  return std::visit([&](const auto& actuation) { return squared_entry(actuation, leg, d); }, leg.actuation);
}

double joint_value(const Leg& leg, const Eigen::Vector3d& point, int sign) noexcept {
  const Eigen::Vector3d d = point - leg.base_point();
  return std::visit(
      [&](const auto& actuation) {
        const double entry = sign * std::sqrt(std::max(0.0, squared_entry(actuation, leg, d)));
        const double q = value(actuation, leg, d, entry);
        return leg.actuated_by_angle() ? turned_into(leg.limits, q) : q;
      },
      leg.actuation);
}

InverseSolution inverse(const Manipulator& manipulator, const Pose& pose, const WorkingMode& mode) noexcept {
  return combined(mode,
                  [&](std::size_t j, int sign) { return leg_solution(manipulator.leg(j), pose, sign); });
}

std::vector<InverseSolution> inverse_in_all_modes(const Manipulator& manipulator, const Pose& pose) {
  std::array<std::array<LegSolution, 2>, max_legs> legs;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    legs[j] = {leg_solution(manipulator.leg(j), pose, -1), leg_solution(manipulator.leg(j), pose, 1)};
  const std::vector<WorkingMode> modes = working_modes(manipulator);
  std::vector<InverseSolution> solutions;
  solutions.reserve(modes.size());
  for (const WorkingMode& mode : modes)
    solutions.push_back(
        combined(mode, [&legs](std::size_t j, int sign) { return legs[j][sign > 0 ? 1 : 0]; }));
  return solutions;
}

const char* name(InverseStatus status) noexcept {
  switch (status) {
    case InverseStatus::solved:
      return "solved";
    case InverseStatus::out_of_reach:
      return "out of reach";
    case InverseStatus::outside_limits:
      return "outside joint limits";
  }
  return "unknown";
}

}  // namespace parallel_aspects
