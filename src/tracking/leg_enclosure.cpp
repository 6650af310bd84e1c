// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/leg_enclosure.h"

#include "interval/half_turns.h"
#include "legs/hinges.h"

#include <cmath>

namespace parallel_aspects {
namespace {

// Of sine and cosine from the C library: its manual states one unit in the last place, 2^-53 near 1.
constexpr double trigonometric_error = 0x1p-52;

// `Manipulator` accepts directions whose length is 1 to within 1e-9.
constexpr double longest_direction = 1.0 + 2e-9;

struct Trigonometry {
  Interval cosine, sine;
};

// `error` of the angle itself [rad].
Trigonometry enclosed(double angle, double error = 0.0) {
  const double all = trigonometric_error + error;
  const Interval margin(-all, all);
  return {Interval(std::cos(angle)) + margin, Interval(std::sin(angle)) + margin};
}

IntervalVector scaled(double factor, const Eigen::Vector3d& v) {
  return {Interval(factor) * v.x(), Interval(factor) * v.y(), Interval(factor) * v.z()};
}

IntervalVector cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double factor) {
  const Interval ax = a.x(), ay = a.y(), az = a.z(), scale = factor;
  return {scale * (ay * b.z() - az * b.y()), scale * (az * b.x() - ax * b.z()),
          scale * (ax * b.y() - ay * b.x())};
}

Interval dot(const IntervalVector& a, const IntervalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Interval squared_norm(const IntervalVector& a) { return square(a[0]) + square(a[1]) + square(a[2]); }

IntervalVector turned(const EnclosedPose& pose, const Eigen::Vector3d& v) {
  const IntervalVector w{v.x(), v.y(), v.z()};
  if (!pose.turns) return w;
  return {dot(pose.turn[0], w), dot(pose.turn[1], w), dot(pose.turn[2], w)};
}

}  // namespace

// With r = |b| and d the offset, |p| <= |d| + r =: s is the largest distance from the first axis. In R2
//   dp = a1 x p dt1 + a2 x b dt2  and  d^2 p = a1 x (a1 x p) dt1^2 + 2 a1 x (a2 x b) dt1 dt2 + a2 x (a2 x b)
//   dt2^2,  so that  |dp|^2 <= (s^2 + r^2) |dt|^2  and  |d^2 p| <= s (|dt1| + |dt2|)^2 <= 2 s |dt|^2.
AnchorBounds anchor_bounds(const Manipulator& manipulator) noexcept {
  assert_rounding_upward();
  const TaskSpace space = manipulator.task_space();
  const double length = manipulator.characteristic_length(),
               offset = std::abs(manipulator.motions().hinges.offset);
  AnchorBounds bounds;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Eigen::Vector3d& a = manipulator.leg(j).anchor;
    const double arm =
        has_rotation(space) ? std::sqrt(a.x() * a.x() + a.y() * a.y() + a.z() * a.z()) / length : 0.0;
    if (space == TaskSpace::R2) {
      const double far = arm + offset / length;
      bounds.lever[j] = std::sqrt(far * far + arm * arm);
      bounds.bend[j] = 2.0 * far / length;
    } else {
      bounds.lever[j] = has_translation(space) ? std::sqrt(1.0 + arm * arm) : arm;
      bounds.bend[j] = arm / length;
    }
  }
  return bounds;
}

EnclosedPose enclosed_pose(const Motions& motions, const Pose& pose) noexcept {
  if (motions.space == TaskSpace::R2) {
    const PoseCoordinates angles = pose_coordinates(motions.space, pose);
    const auto placed =
        EnclosedHinges(motions.hinges).placed(enclosed_turn(angles[0]), enclosed_turn(angles[1]));
    return {placed.position, placed.rotation, true};
  }
  EnclosedPose result{
      {pose.position.x(), pose.position.y(), pose.position.z()}, {}, has_rotation(motions.space)};
  if (result.turns) result.turn = enclosed_rotation(pose.orientation);
  return result;
}

LegForm::LegForm(const Leg& leg) noexcept : type_(leg.kind().type), anchor_(leg.anchor) {
  assert_rounding_upward();
  first_.setZero();
  second_.setZero();
  std::visit([&](const auto& actuation) { prepare(leg, actuation); }, leg.actuation);
}

void LegForm::prepare(const Leg& leg, const RevoluteActuation& actuation) noexcept {
  fixed_ = actuation.center;
  first_ = actuation.radius * actuation.zero_direction;
  second_ = actuation.radius * actuation.axis.cross(actuation.zero_direction);
  exact_first_ = scaled(actuation.radius, actuation.zero_direction);
  exact_second_ = cross(actuation.axis, actuation.zero_direction, actuation.radius);
  squared_rod_ = square(Interval(leg.rod_length));
  // The second direction is a product of two.
  point_speed_ = actuation.radius * longest_direction * longest_direction;
  point_curvature_ = point_speed_;
  curvature_ = point_speed_ * point_speed_;
}

void LegForm::prepare(const Leg& leg, const PrismaticActuation& actuation) noexcept {
  fixed_ = actuation.origin;
  first_ = actuation.direction;
  exact_first_ = scaled(1.0, actuation.direction);
  squared_rod_ = square(Interval(leg.rod_length));
  point_speed_ = longest_direction;
  curvature_ = longest_direction * longest_direction;
}

void LegForm::prepare(const Leg&, const StrutActuation& actuation) noexcept {
  fixed_ = actuation.base;
  offset_ = actuation.length_at_zero;
  sense_ = actuation.sense;
  curvature_ = 1.0;
}

void LegForm::prepare(const Leg&, const ElbowActuation& actuation) noexcept {
  fixed_ = actuation.base;
  offset_ = actuation.angle_at_zero;
  sense_ = actuation.sense;
  squared_rod_ = square(Interval(actuation.inner_length)) + square(Interval(actuation.outer_length));
  product_ = Interval(actuation.inner_length) * actuation.outer_length;
  curvature_ = product_.upper();
}

Eigen::Vector3d LegForm::proximal_point(double q) const noexcept {
  switch (type_) {
    case LegType::revolute:
      return fixed_ + std::cos(q) * first_ + std::sin(q) * second_;
    case LegType::prismatic:
      return fixed_ + q * first_;
    case LegType::strut:
    case LegType::elbow:
      break;
  }
  return fixed_;
}

double LegForm::squared_distance(double q) const noexcept {
  const double moved = offset_ + sense_ * q;
  switch (type_) {
    case LegType::revolute:
    case LegType::prismatic:
      break;
    case LegType::strut:
      return moved * moved;
    case LegType::elbow:
      return squared_rod_.upper() + 2.0 * product_.upper() * std::cos(moved);
  }
  return squared_rod_.upper();
}

double LegForm::largest_inverse_entry(double rod) const noexcept {
  switch (type_) {
    case LegType::revolute:
    case LegType::prismatic:
      break;
    case LegType::strut:
      return rod;
    case LegType::elbow:
      return product_.upper();
  }
  return rod * point_speed_;
}

LegEnclosure LegForm::enclose(const EnclosedPose& pose, double q) const noexcept {
  LegEnclosure leg;
  leg.lever.arm = turned(pose, anchor_);
  for (std::size_t i = 0; i < 3; ++i) {
    leg.lever.point[i] = leg.lever.arm[i] + pose.position[i];
    leg.lever.axis[i] = pose.turn[i][2];
    leg.u[i] = leg.lever.point[i] - fixed_[static_cast<Eigen::Index>(i)];
  }
  const Interval squared_length = complete(q, leg);
  leg.half_residual = Interval(0.5) * (squared_norm(leg.u) - squared_length);
  return leg;
}

Interval LegForm::complete(double q, LegEnclosure& leg) const noexcept {
  switch (type_) {
    case LegType::revolute:
      break;
    case LegType::prismatic:
      return complete_slide(q, leg);
    case LegType::strut:
      return complete_strut(q, leg);
    case LegType::elbow:
      return complete_elbow(q, leg);
  }
  return complete_crank(q, leg);
}

Interval LegForm::complete_crank(double q, LegEnclosure& leg) const noexcept {
  const Trigonometry at = enclosed(q);
  IntervalVector speed;
  for (std::size_t i = 0; i < 3; ++i) {
    leg.u[i] = leg.u[i] - (at.cosine * exact_first_[i] + at.sine * exact_second_[i]);
    speed[i] = at.cosine * exact_second_[i] - at.sine * exact_first_[i];
  }
  leg.inverse_diagonal = dot(leg.u, speed);
  return squared_rod_;
}

Interval LegForm::complete_slide(double q, LegEnclosure& leg) const noexcept {
  for (std::size_t i = 0; i < 3; ++i) leg.u[i] = leg.u[i] - exact_first_[i] * q;
  leg.inverse_diagonal = dot(leg.u, exact_first_);
  return squared_rod_;
}

Interval LegForm::complete_strut(double q, LegEnclosure& leg) const noexcept {
  const Interval moved = Interval(offset_) + Interval(sense_) * q;
  leg.inverse_diagonal = moved * sense_;
  return square(moved);
}

Interval LegForm::complete_elbow(double q, LegEnclosure& leg) const noexcept {
  const Interval moved = Interval(offset_) + Interval(sense_) * q;
  const Trigonometry at = enclosed(moved.upper(), moved.upper() - moved.lower());
  leg.inverse_diagonal = -(Interval(sense_) * (product_ * at.sine));
  return squared_rod_ + Interval(2.0) * (product_ * at.cosine);
}

}  // namespace parallel_aspects
