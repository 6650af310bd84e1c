// SPDX-License-Identifier: BSD-3-Clause
#include "legs/held_leg.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <variant>

namespace parallel_aspects {
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
