// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/strut_slice.h"

#include "legs/held_leg.h"
#include "model/angles.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

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

}  // namespace parallel_aspects
