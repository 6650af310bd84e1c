// SPDX-License-Identifier: BSD-3-Clause
#include "legs/held_point.h"

#include "interval/half_turns.h"
#include "legs/determinant.h"

#include <cassert>
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

}  // namespace parallel_aspects
