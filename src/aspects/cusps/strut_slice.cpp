// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/strut_slice.h"

#include "legs/held_leg.h"
#include "model/angles.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

// Within a full turn of zero, for `turn_of_half_turns`.
Interval without_turns(const Interval& angle) noexcept {
  const double middle = 0.5 * (angle.lower() + angle.upper());
  if (middle > 1.0) return angle - Interval(2.0);
  return middle < -1.0 ? angle + Interval(2.0) : angle;
}

Planar<Interval> anchor_of(const Leg& leg) noexcept { return {leg.anchor.x(), leg.anchor.y()}; }

Planar<Interval> base_of(const Leg& leg) noexcept { return {leg.base_point().x(), leg.base_point().y()}; }

Planar<Interval> difference(const Planar<Interval>& a, const Planar<Interval>& b) noexcept {
  return {a.x - b.x, a.y - b.y};
}

/// Of the anchor over the plane of the base point [m].
Interval height_of(const Leg& leg) noexcept {
  return Interval(leg.anchor.z()) - Interval(leg.base_point().z());
}

/// rho^2 / 2 of a strut that has this joint value; 0 where its length would be negative.
Interval half_square_at(const Leg& leg, double q) {
  if (!leg.can_have(q)) return 0.0;
  const Interval in_plane = HeldLeg(leg, q, 0.0).rod(Turn<Interval>{1.0, 0.0}).x;
  return Interval(0.5) * (square(in_plane) + square(height_of(leg)));
}

/// The same at the shortest and at the longest length within limits.
std::array<Interval, 2> limits_of(const Leg& leg) {
  const bool rises = leg.has_branch(1);
  const double shortest = rises ? leg.limits.lower : leg.limits.upper;
  const double longest = rises ? leg.limits.upper : leg.limits.lower;
  return {std::isfinite(shortest) ? half_square_at(leg, shortest) : Interval(0.0),
          std::isfinite(longest) ? half_square_at(leg, longest) : Interval(HUGE_VAL)};
}

}  // namespace

SliceTurns::SliceTurns(const SliceRanges& at) noexcept
    : direction(turn_of_half_turns(at[0])),
      phi(turn_of_half_turns(at[1])),
      difference(turn_of_half_turns(without_turns(at[1] - at[0]))) {}

SliceTurns::SliceTurns(const std::array<double, 2>& at) noexcept
    : direction(enclosed_turn(pi * at[0])),
      phi(enclosed_turn(pi * at[1])),
      difference{phi.cosine * direction.cosine + phi.sine * direction.sine,
                 phi.sine * direction.cosine - phi.cosine * direction.sine} {}

// |r + v + o|^2 = |r|^2 + |v|^2 + |o|^2 + 2 (r.v + r.o + v.o).
CosineSum CosineSum::half_square(const Interval& length, const Planar<Interval>& m, const Planar<Interval>& o,
                                 const Interval& squared_height) noexcept {
  const Interval squares = square(length) + squared_norm(m) + squared_norm(o);
  return {Interval(0.5) * (squares + squared_height),
          {length * m.x, -(length * m.y)},
          {length * o.x, length * o.y},
          {m.x * o.x + m.y * o.y, m.x * o.y - m.y * o.x}};
}

CosineSum CosineSum::half_square_slope(const Interval& length, const Planar<Interval>& m,
                                       const Planar<Interval>& o) noexcept {
  return {length, {m.x, -m.y}, {o.x, o.y}, {0.0, 0.0}};
}

CosineSum CosineSum::along(const Planar<Interval>& n, const Interval& length, const Planar<Interval>& m,
                           const Planar<Interval>& o) noexcept {
  return {n.x * o.x + n.y * o.y,
          {0.0, 0.0},
          {length * n.x, length * n.y},
          {m.x * n.x + m.y * n.y, m.x * n.y - m.y * n.x}};
}

StrutSlice::StrutSlice(const Manipulator& manipulator, const MapSlice& slice) : held_(slice.joint->leg) {
  assert_rounding_upward();
  add_legs(manipulator);
  const HeldLeg rod(manipulator.leg(held_), slice.joint->value, 0.0);
  set_rod(rod.rod(Turn<Interval>{1.0, 0.0}).x);
}

StrutSlice::StrutSlice(const Manipulator& manipulator, std::size_t held) : dimension_(3), held_(held) {
  assert_rounding_upward();
  add_legs(manipulator);
  set_rod(with_half_square({held_limits_[0].lower(), held_limits_[1].upper()}).rod_);
}

void StrutSlice::add_legs(const Manipulator& manipulator) {
  held_squared_height_ = square(height_of(manipulator.leg(held_)));
  held_limits_ = limits_of(manipulator.leg(held_));
  for (std::size_t i = 0, j = 0; j < manipulator.leg_count(); ++j)
    if (j != held_) legs_[i++] = MovingLeg(manipulator, held_, j);
}

void StrutSlice::set_rod(const Interval& rod) noexcept {
  rod_ = rod;
  for (MovingLeg& leg : legs_) leg.set_rod(rod);
}

Box StrutSlice::whole() const noexcept {
  Box box = whole_slice();
  if (dimension_ == 2) return box;
  box.dimension = 3;
  box.lower[2] = rod_.lower();
  box.upper[2] = rod_.upper();
  return box;
}

StrutSlice StrutSlice::with_rod(const Interval& rod) const noexcept {
  StrutSlice result = *this;
  result.dimension_ = 2;
  result.set_rod(rod);
  return result;
}

StrutSlice StrutSlice::with_half_square(const Interval& value) const noexcept {
  return with_rod(square_root(not_negative_part(Interval(2.0) * value - held_squared_height_)));
}

StrutSlice StrutSlice::at(const Lengths& lengths) const noexcept {
  return dimension_ == 2 ? *this : with_half_square(Interval(0.5) * square(Interval(lengths[2])));
}

StrutSlice StrutSlice::over(const Box& box) const noexcept {
  return dimension_ == 2 ? *this : with_rod({box.lower[2], box.upper[2]});
}

Interval StrutSlice::held_half_square() const noexcept {
  return Interval(0.5) * (square(rod_) + held_squared_height_);
}

StrutSlice::MovingLeg::MovingLeg(const Manipulator& manipulator, std::size_t held, std::size_t j) : index(j) {
  const Leg &leg = manipulator.leg(j), &other = manipulator.leg(held);
  between_anchors = difference(anchor_of(leg), anchor_of(other));
  between_bases = difference(base_of(other), base_of(leg));
  squared_height = square(height_of(leg));
  limits = limits_of(leg);
}

void StrutSlice::MovingLeg::set_rod(const Interval& rod) noexcept {
  half_square = CosineSum::half_square(rod, between_anchors, between_bases, squared_height);
  const Interval sum =
      rod + square_root(squared_norm(between_anchors)) + square_root(squared_norm(between_bases));
  largest = (Interval(0.5) * (square(sum) + squared_height)).upper();
}

SliceCenter::SliceCenter(const Box& box) noexcept {
  for (std::size_t i = 0; i < 2; ++i) {
    at[i] = box.center(i);
    const double half = std::max(box.upper[i] - box.center(i), box.center(i) - box.lower[i]);
    half_widths[i] = (pi_enclosure() * Interval(half)).upper();
  }
  if (box.dimension < 3) return;
  rod = box.center(2);
  half_widths[2] = std::max(box.upper[2] - rod, rod - box.lower[2]);
}

SliceRanges ranges_of(const Box& box) noexcept {
  return {Interval(box.lower[0], box.upper[0]), Interval(box.lower[1], box.upper[1])};
}

std::array<Box, 2> halves_of(const Box& box) noexcept {
  const std::size_t axis = box.width(0) >= box.width(1) ? 0 : 1;
  std::array<Box, 2> halves{box, box};
  halves[0].upper[axis] = halves[1].lower[axis] = box.center(axis);
  return halves;
}

}  // namespace parallel_aspects
