// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/continuation.h"

#include "parallel_aspects/kinematics/jacobians.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double shortest_step = 0x1p-24;
constexpr int most_newton_steps = 20;
constexpr double converged = 1e-13;

// Kantorovich's theorem asks for 1/2; the gap takes up the rounding of its terms.
constexpr double certified_product = 0.499;

Eigen::Index rotational_columns(TaskSpace space) {
  return static_cast<Eigen::Index>(rotational_freedoms(space));
}

/// What one leg adds to the bounds while its drive moves by `change`.
struct LegBounds {
  double point_motion;  // of its proximal point
  double row_change;    // of its row of A
  double residual;      // |f_j| / 2 at the old pose and any drive value of the step
  double lever;         // |dp| over |(L w, v)|
  double arm;           // |d^2 p| over |(L w, v)|^2
  double rod;           // |u|
};

// How far the proximal point may move, and half the change of rho^2.
std::pair<double, double> drive_motion(const Leg& leg, double q, double change) {
  if (const auto* revolute = std::get_if<RevoluteDrive>(&leg.drive)) return {revolute->radius * change, 0.0};
  if (std::holds_alternative<PrismaticDrive>(leg.drive)) return {change, 0.0};
  if (const auto* elbow = std::get_if<ElbowDrive>(&leg.drive))
    return {0.0, elbow->inner_length * elbow->outer_length * change};
  return {0.0, std::sqrt(leg.squared_distance(q)) * change + 0.5 * change * change};
}

LegBounds leg_bounds(const Manipulator& manipulator, std::size_t j, const PathPoint& at, double change) {
  const Leg& leg = manipulator.leg(j);
  const double q = at.q[static_cast<Eigen::Index>(j)];
  const Eigen::Vector3d u = at.pose.transform(leg.anchor) - leg.proximal_point(q);
  const bool turns = has_rotation(manipulator.task_space());
  const double length = manipulator.characteristic_length();
  const double arm = turns ? leg.anchor.norm() / length : 0.0;
  const double lever = has_translation(manipulator.task_space()) ? std::hypot(1.0, arm) : arm;
  const auto [point_motion, length_motion] = drive_motion(leg, q, change);
  const double rod = u.norm();
  return {point_motion,
          lever * point_motion,
          0.5 * std::abs(u.squaredNorm() - leg.squared_distance(q)) + rod * point_motion +
              0.5 * point_motion * point_motion + length_motion,
          lever,
          arm / length,
          rod};
}

TaskMatrix scaled_direct_matrix(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  TaskMatrix matrix = direct_matrix(manipulator, pose, q);
  matrix.leftCols(rotational_columns(manipulator.task_space())) /= manipulator.characteristic_length();
  return matrix;
}

}  // namespace

bool refine_pose(const Manipulator& manipulator, const JointVector& q, Pose& pose) noexcept {
  const double length = manipulator.characteristic_length();
  const Eigen::Index rotational = rotational_columns(manipulator.task_space());
  for (int i = 0; i < most_newton_steps; ++i) {
    const TaskMatrix matrix = scaled_direct_matrix(manipulator, pose, q);
    TaskVector step = matrix.partialPivLu().solve(-0.5 * residuals(manipulator, pose, q));
    if (!step.allFinite()) return false;
    const double size = step.norm();
    step.head(rotational) /= length;
    pose = displaced(manipulator.task_space(), pose, step);
    if (size <= converged * manipulator.size()) return true;
  }
  return false;
}

Continuation::Continuation(const Manipulator& manipulator, const Pose& pose, const JointVector& q0,
                           const JointVector& q1) noexcept
    : manipulator_(manipulator), q0_(q0), q1_(q1), at_{0.0, q0, pose} {}

// Kantorovich for F(xi) = f(X + xi, q) / 2 in exponential coordinates xi = (L w, v) about the pose, for all q
// of the step at once. As exp of a skew matrix is orthogonal, |D exp| <= 1 and |D^2 exp| <= 1, so that |D^2
// F_j| <= lever^2 + (|u_j| + |change of u_j|) arm, everywhere in the ball.
bool Continuation::step_is_certified(double inverse_norm, double length) const noexcept {
  std::array<LegBounds, max_legs> legs;
  const std::size_t n = manipulator_.leg_count();
  double squared_row_change = 0.0, squared_residual = 0.0, squared_curvature = 0.0;
  for (std::size_t j = 0; j < n; ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    legs[j] = leg_bounds(manipulator_, j, at_, std::abs(q1_[i] - q0_[i]) * length);
    squared_row_change += legs[j].row_change * legs[j].row_change;
    squared_residual += legs[j].residual * legs[j].residual;
  }
  const double shrink = 1.0 - inverse_norm * std::sqrt(squared_row_change);
  if (!(shrink > 0.0)) return false;
  const double inverse_bound = inverse_norm / shrink;  // over the whole step
  const double newton_step = inverse_bound * std::sqrt(squared_residual);
  for (std::size_t j = 0; j < n; ++j) {
    const double rod = legs[j].rod + legs[j].point_motion + 2.0 * legs[j].lever * newton_step;
    const double curvature = legs[j].lever * legs[j].lever + rod * legs[j].arm;
    squared_curvature += curvature * curvature;
  }
  return inverse_bound * newton_step * std::sqrt(squared_curvature) <= certified_product;
}

bool Continuation::correct(PathPoint& point) const noexcept {
  point.q = point.t >= 1.0 ? q1_ : JointVector(q0_ + point.t * (q1_ - q0_));
  return refine_pose(manipulator_, point.q, point.pose);
}

bool Continuation::advance() noexcept {
  length_ = std::min(length_, 1.0 - at_.t);
  const double inverse_norm = scaled_direct_matrix(manipulator_, at_.pose, at_.q).inverse().norm();
  while (!step_is_certified(inverse_norm, length_)) {
    length_ *= 0.5;
    if (length_ < shortest_step) return false;
  }
  PathPoint next = at_;
  next.t = at_.t + length_ >= 1.0 ? 1.0 : at_.t + length_;
  if (!correct(next)) return false;
  at_ = next;
  length_ *= 2.0;
  return true;
}

}  // namespace parallel_aspects
