// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/planar_leg.h"

#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

// The angle is a rounded sum of a rounded arc tangent and a limit; its error and that of cos and sin are a
// few units in the last place each, in every rounding direction. Together they stay below this.
Interval widened(double value, double angle) {
  const double error = 0x1p-48 * (1.0 + std::abs(angle));
  return {value - error, value + error};
}

Planar<Interval> direction_of(double angle) {
  return {widened(std::cos(angle), angle), widened(std::sin(angle), angle)};
}

LimitDirections limit_directions(double lower, double upper) {
  return {direction_of(lower), direction_of(upper), upper - lower < EIGEN_PI};
}

// A range of a full turn or more leaves every direction free.
bool restricts_an_angle(const JointLimits& limits) {
  return limits.limited() && std::isfinite(limits.lower) && std::isfinite(limits.upper) &&
         limits.upper - limits.lower < 2.0 * EIGEN_PI;
}

Verdict both(Verdict a, Verdict b) {
  if (a == Verdict::fails || b == Verdict::fails) return Verdict::fails;
  return a == Verdict::holds && b == Verdict::holds ? Verdict::holds : Verdict::unsure;
}

Verdict opposite(Verdict a) {
  if (a == Verdict::unsure) return a;
  return a == Verdict::holds ? Verdict::fails : Verdict::holds;
}

Verdict is_positive(const Interval& value) {
  if (value.positive()) return Verdict::holds;
  return value.negative() ? Verdict::fails : Verdict::unsure;
}

}  // namespace

PlanarLeg::PlanarLeg(const Leg& leg) : limits_(leg.limits) {
  set_base(leg.base_point(), leg);
  std::visit([this, &leg](const auto& drive) { set(drive, leg); }, leg.drive);
}

void PlanarLeg::set_base(const Eigen::Vector3d& base, const Leg& leg) {
  base_ = {base.x(), base.y()};
  squared_height_ = square(Interval(leg.anchor.z()) - Interval(base.z()));
  reach_ = leg.longest_reach();
}

void PlanarLeg::set_two_links(const Interval& squared_first, const Interval& squared_second) {
  const Interval twice_product = Interval(2.0) * square_root(squared_first * squared_second);
  squared_longest_ = squared_first + squared_second + twice_product;
  squared_shortest_ = squared_first + squared_second - twice_product;
}

void PlanarLeg::set(const RevoluteDrive& drive, const Leg& leg) {
  kind_ = Kind::revolute;
  const Interval squared_crank = square(Interval(drive.radius));
  // Anchor and crank tip move in parallel planes; what is left of the rod in the plane.
  squared_rod_ = square(Interval(leg.rod_length)) - squared_height_;
  set_two_links(squared_crank, not_negative_part(squared_rod_));
  half_difference_ = Interval(0.5) * (squared_rod_ - squared_crank);
  sense_ = drive.axis.z() > 0.0 ? 1.0 : -1.0;
  limited_ = restricts_an_angle(leg.limits);
  const double zero_angle = sense_ * std::atan2(drive.zero_direction.y(), drive.zero_direction.x());
  limit_directions_ = limit_directions(zero_angle + leg.limits.lower, zero_angle + leg.limits.upper);
}

void PlanarLeg::set(const PrismaticDrive& drive, const Leg& leg) {
  kind_ = Kind::prismatic;
  squared_rod_ = square(Interval(leg.rod_length)) - squared_height_;
  direction_ = {drive.direction.x(), drive.direction.y()};
  limited_ = leg.limits.limited();
}

void PlanarLeg::set(const StrutDrive& drive, const Leg& leg) {
  kind_ = Kind::strut;
  sense_ = drive.sense;
  branch_ = drive.sense > 0.0 ? 1 : -1;
  length_at_zero_ = drive.length_at_zero;
  limited_ = leg.limits.limited();
}

void PlanarLeg::set(const ElbowDrive& drive, const Leg& leg) {
  kind_ = Kind::elbow;
  const Interval squared_inner = square(Interval(drive.inner_length));
  const Interval squared_outer = square(Interval(drive.outer_length));
  set_two_links(squared_inner, squared_outer);
  half_sum_ = Interval(0.5) * (squared_inner + squared_outer);
  sense_ = drive.sense;
  limited_ = restricts_an_angle(leg.limits);
  const double one_end = drive.angle_at_zero + drive.sense * leg.limits.lower;
  const double other_end = drive.angle_at_zero + drive.sense * leg.limits.upper;
  limit_directions_ = limit_directions(std::min(one_end, other_end), std::max(one_end, other_end));
}

Verdict PlanarLeg::within_limits(const Planar<Interval>& d, const Interval& entry, int sign) const {
  if (!limited_) return Verdict::holds;
  const Interval signed_entry = sign > 0 ? entry : -entry;
  const Interval squared_distance = square(d.x) + square(d.y);
  switch (kind_) {
    case Kind::prismatic:
      return length_within_limits(direction_.x * d.x + direction_.y * d.y - signed_entry);
    case Kind::strut:
      return length_within_limits(Interval(sense_) *
                                  (square_root(squared_distance + squared_height_) - length_at_zero_));
    case Kind::elbow:
      return angle_within_limits({Interval(0.5) * (squared_distance + squared_height_) - half_sum_,
                                  Interval(-sense_) * signed_entry});
    case Kind::revolute:
      break;
  }
  // The crank points along a d - B_jj (axis x d), mirrored where the axis points down so that angles grow
  // with q.
  const Planar<Interval> mirrored{d.x, Interval(sense_) * d.y};
  const Interval along = Interval(0.5) * squared_distance - half_difference_;
  return angle_within_limits(
      {along * mirrored.x + signed_entry * mirrored.y, along * mirrored.y - signed_entry * mirrored.x});
}

Verdict PlanarLeg::angle_within_limits(const Planar<Interval>& direction) const {
  const LimitDirections& limit = limit_directions_;
  if (limit.less_than_half_turn)
    return both(is_positive(cross(limit.lower, direction)), is_positive(cross(direction, limit.upper)));
  return opposite(
      both(is_positive(cross(limit.upper, direction)), is_positive(cross(direction, limit.lower))));
}

Verdict PlanarLeg::length_within_limits(const Interval& length) const {
  Verdict verdict = Verdict::holds;
  if (std::isfinite(limits_.lower)) verdict = is_positive(length - Interval(limits_.lower));
  if (std::isfinite(limits_.upper)) verdict = both(verdict, is_positive(Interval(limits_.upper) - length));
  return verdict;
}

}  // namespace parallel_aspects
