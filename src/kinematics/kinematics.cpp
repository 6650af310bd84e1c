// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"

#include "model/angles.h"
#include "model/linear_algebra.h"
#include "model/task_space_traits.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace parallel_aspects {
namespace {

bool allowed(const Manipulator& manipulator, const WorkingMode& mode) {
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    if (!manipulator.leg(j).has_branch(mode.sign(j))) return false;
  return true;
}

}  // namespace

WorkingMode WorkingMode::from_index(std::size_t leg_count, std::size_t index) noexcept {
  WorkingMode mode(leg_count);
  mode.negative_ = static_cast<std::uint8_t>(index);
  return mode;
}

std::optional<WorkingMode> WorkingMode::from_signs(const std::vector<int>& signs) {
  const bool all_signs = std::all_of(signs.begin(), signs.end(), [](int s) { return s == 1 || s == -1; });
  if (!all_signs || signs.empty() || signs.size() > static_cast<std::size_t>(max_legs)) return std::nullopt;
  WorkingMode mode(signs.size());
  for (std::size_t j = 0; j < signs.size(); ++j) mode.set_sign(j, signs[j]);
  return mode;
}

void WorkingMode::set_sign(std::size_t leg, int sign) noexcept {
  const auto bit = static_cast<std::uint8_t>(1U << leg);
  negative_ = static_cast<std::uint8_t>(sign < 0 ? negative_ | bit : negative_ & ~bit);
}

std::vector<int> WorkingMode::signs() const {
  std::vector<int> result(leg_count());
  for (std::size_t j = 0; j < result.size(); ++j) result[j] = sign(j);
  return result;
}

std::string to_string(const WorkingMode& mode) {
  std::string text = "(";
  for (std::size_t j = 0; j < mode.leg_count(); ++j) {
    text += j == 0 ? "" : ",";
    text += mode.sign(j) > 0 ? '+' : '-';
  }
  return text + ")";
}

std::vector<WorkingMode> working_modes(const Manipulator& manipulator) {
  std::vector<WorkingMode> modes;
  for (std::size_t index = 0; index < std::size_t{1} << manipulator.leg_count(); ++index) {
    const WorkingMode mode = WorkingMode::from_index(manipulator.leg_count(), index);
    if (allowed(manipulator, mode)) modes.push_back(mode);
  }
  return modes;
}

namespace {

double square(double x) { return x * x; }

// With r the crank, R the rod and n the axis: h^2 = ((r+R)^2 - |d|^2)(|d|^2 - (r-R)^2)/4 - r^2 (d.n)^2.
double squared_b_entry(const RevoluteActuation& actuation, const Leg& leg, const Eigen::Vector3d& d) {
  const double w = d.squaredNorm();
  return 0.25 * (square(actuation.radius + leg.rod_length) - w) *
             (w - square(actuation.radius - leg.rod_length)) -
         square(actuation.radius * actuation.axis.dot(d));
}

double squared_b_entry(const PrismaticActuation& actuation, const Leg& leg, const Eigen::Vector3d& d) {
  return square(leg.rod_length) - actuation.direction.cross(d).squaredNorm();
}

double squared_b_entry(const StrutActuation&, const Leg&, const Eigen::Vector3d& d) {
  return d.squaredNorm();
}

double squared_b_entry(const ElbowActuation& actuation, const Leg&, const Eigen::Vector3d& d) {
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
  return std::visit([&](const auto& actuation) { return squared_b_entry(actuation, leg, d); }, leg.actuation);
}

double joint_value(const Leg& leg, const Eigen::Vector3d& point, int sign) noexcept {
  const Eigen::Vector3d d = point - leg.base_point();
  return std::visit(
      [&](const auto& actuation) {
        const double entry = sign * std::sqrt(std::max(0.0, squared_b_entry(actuation, leg, d)));
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

TaskMatrix direct_matrix(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const auto n = static_cast<Eigen::Index>(manipulator.leg_count());
  TaskMatrix matrix(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const Eigen::Vector3d b = pose.orientation * leg.anchor;
    const Eigen::Vector3d u = pose.position + b - leg.proximal_point(q[j]);
    auto row = matrix.row(j);
    write_row(manipulator.task_space(), lever_at(pose, b), u, row);
  }
  return matrix;
}

TaskMatrix homogenised_matrix(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  TaskMatrix matrix = direct_matrix(manipulator, pose, q);
  matrix.leftCols(static_cast<Eigen::Index>(rotational_degrees_of_freedom(manipulator.task_space()))) /=
      manipulator.characteristic_length();
  for (Eigen::Index j = 0; j < matrix.rows(); ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const double rod = (pose.transform(leg.anchor) - leg.proximal_point(q[j])).norm();
    if (rod > 0.0) matrix.row(j) /= rod;
  }
  return matrix;
}

TaskVector inverse_diagonal(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const auto n = static_cast<Eigen::Index>(manipulator.leg_count());
  TaskVector diagonal(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const Eigen::Vector3d u = pose.transform(leg.anchor) - leg.proximal_point(q[j]);
    diagonal[j] = u.dot(leg.proximal_point_derivative(q[j])) + 0.5 * leg.squared_distance_derivative(q[j]);
  }
  return diagonal;
}

TaskVector residuals(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const auto n = static_cast<Eigen::Index>(manipulator.leg_count());
  TaskVector result(n);
  for (Eigen::Index j = 0; j < n; ++j)
    result[j] = manipulator.leg(static_cast<std::size_t>(j)).residual(pose, q[j]);
  return result;
}

double direct_determinant(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  return determinant(direct_matrix(manipulator, pose, q));
}

std::optional<WorkingMode> working_mode(const Manipulator& manipulator, const Pose& pose,
                                        const JointVector& q) {
  const TaskVector diagonal = inverse_diagonal(manipulator, pose, q);
  WorkingMode mode(manipulator.leg_count());
  for (Eigen::Index j = 0; j < diagonal.size(); ++j) {
    if (!(diagonal[j] < 0.0 || diagonal[j] > 0.0)) return std::nullopt;
    mode.set_sign(static_cast<std::size_t>(j), diagonal[j] > 0.0 ? 1 : -1);
  }
  return mode;
}

}  // namespace parallel_aspects
