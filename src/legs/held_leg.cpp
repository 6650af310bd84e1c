// SPDX-License-Identifier: BSD-3-Clause
#include "legs/held_leg.h"

#include "interval/half_turns.h"
#include "legs/determinant.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <variant>

namespace parallel_aspects {

Spatial<Interval> scaled(const Interval& factor, const Spatial<Interval>& v) noexcept {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

Spatial<Interval> sum_of(const Spatial<Interval>& a, const Spatial<Interval>& b) noexcept {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

HeldPoint::HeldPoint(const Leg& leg, const Interval& q)
    : squared_rod(square(Interval(leg.rod_length))), q_(q) {
  assert_rounding_upward();
  std::visit([this](const auto& actuation) { set(actuation); }, leg.actuation);
}

void HeldPoint::set(const RevoluteActuation& crank) {
  const Turn<Interval> turn = enclosed_turn(0.0, 1.0, q_);
  const Spatial<Interval> zero = scaled(crank.radius, enclosed(crank.zero_direction)),
                          side = cross(enclosed(crank.axis), zero);
  c = sum_of(enclosed(crank.center), sum_of(scaled(turn.cosine, zero), scaled(turn.sine, side)));
  slope = sum_of(scaled(-turn.sine, zero), scaled(turn.cosine, side));
}

void HeldPoint::set(const PrismaticActuation& rail) {
  slope = enclosed(rail.direction);
  c = sum_of(enclosed(rail.origin), scaled(q_, slope));
}

void HeldPoint::set(const StrutActuation& strut) {
  c = enclosed(strut.base);
  const Interval rod = Interval(strut.length_at_zero) + Interval(strut.sense) * q_;
  squared_rod = square(rod);
  rod_slope = Interval(strut.sense) * rod;
}

void HeldPoint::set(const ElbowActuation&) { assert(!"an actuated elbow is not held"); }

namespace {

/// Of the anchor over the plane of a point of the leg [m].
Interval height(const Leg& leg, const Eigen::Vector3d& point) {
  return Interval(leg.anchor.z()) - Interval(point.z());
}

}  // namespace

HeldLeg::HeldLeg(const Leg& leg, const Interval& q, double serial_margin) {
  assert_rounding_upward();
  const Eigen::Vector3d base = leg.base_point();
  base_ = {base.x(), base.y()};
  std::visit([&](const auto& actuation) { set(actuation, leg, q); }, leg.actuation);
  largest_square_ = square(largest_);
  least_entry_ = Interval(serial_margin) * largest_;
}

// The crank turns by q about z, or about -z.
void HeldLeg::set(const RevoluteActuation& crank, const Leg& leg, const Interval& q) {
  const double sense = crank.axis.z() > 0.0 ? 1.0 : -1.0;
  const Interval radius(crank.radius);
  turns_ = true;
  const Turn<Interval> turn =
      enclosed_turn(std::atan2(crank.zero_direction.y(), crank.zero_direction.x()), sense, q);
  const Planar<Interval> arm{radius * turn.cosine, radius * turn.sine};
  center_ = {Interval(crank.center.x()) + arm.x, Interval(crank.center.y()) + arm.y};
  lever_ = {Interval(-sense) * arm.y, Interval(sense) * arm.x};
  set_rod(Interval(leg.rod_length), height(leg, crank.center));
  largest_ = radius * rod_;
}

void HeldLeg::set(const PrismaticActuation& rail, const Leg& leg, const Interval& q) {
  lever_ = {rail.direction.x(), rail.direction.y()};
  center_ = {Interval(rail.origin.x()) + q * lever_.x, Interval(rail.origin.y()) + q * lever_.y};
  set_rod(Interval(leg.rod_length), height(leg, rail.origin));
  largest_ = rod_;
}

void HeldLeg::set(const StrutActuation& strut, const Leg& leg, const Interval& q) {
  has_lever_ = false;
  center_ = base_;
  rod_slope_ = strut.sense;
  set_rod(Interval(strut.length_at_zero) + Interval(strut.sense) * q, height(leg, strut.base));
  largest_ = rod_;
}

void HeldLeg::set(const ElbowActuation&, const Leg&, const Interval&) {
  assert(!"slices that hold an actuated elbow are refused");
}

void HeldLeg::set_rod(const Interval& rod, const Interval& height) {
  rod_ = rod;
  length_ = square_root(not_negative_part(square(rod) - square(height)));
}

}  // namespace parallel_aspects
