// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/leg_enclosure.h"

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

IntervalVector turned(const RotationRows<Interval>* turn, const Eigen::Vector3d& v) {
  if (turn == nullptr) return {v.x(), v.y(), v.z()};
  const IntervalVector w{v.x(), v.y(), v.z()};
  return {dot((*turn)[0], w), dot((*turn)[1], w), dot((*turn)[2], w)};
}

}  // namespace

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

LegEnclosure LegForm::enclose(const Pose& pose, const RotationRows<Interval>* turn, double q) const noexcept {
  LegEnclosure leg;
  leg.b = turned(turn, anchor_);
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    leg.u[i] = leg.b[i] + pose.position[k] - fixed_[k];
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
