// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/spherical_held_slice.h"

#include "legs/determinant.h"
#include "legs/held_point.h"

#include <variant>

namespace parallel_aspects {
namespace {

using Number = Dual<2, Interval>;

Spatial<Interval> difference(const Spatial<Interval>& a, const Spatial<Interval>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// What the value in the middle and the slopes over the box leave of it.
Interval narrowed(const Number& over, const Interval& center, const SliceCenter& middle) noexcept {
  return intersection(over.value,
                      center + over.gradient[0] * middle.offset(0) + over.gradient[1] * middle.offset(1));
}

Spatial<Interval> opposite(const Spatial<Interval>& v) { return {-v[0], -v[1], -v[2]}; }

}  // namespace

SphericalHeldSlice::SphericalHeldSlice(const Manipulator& manipulator, const HeldJoint& joint)
    : HeldSlice(manipulator, joint.leg, SliceSums::yes),
      orientations_(manipulator.leg(joint.leg), joint.value),
      held_entry_(orientations_.held_entry()),
      legs_{MovingLeg(manipulator.leg(leg(0)), orientations_),
            MovingLeg(manipulator.leg(leg(1)), orientations_)} {}

SphericalHeldSlice::MovingLeg::MovingLeg(const Leg& moving, const HeldOrientations& orientations)
    : leg(moving), anchor(enclosed(moving.anchor)) {
  std::visit([this](const auto& actuation) { set(actuation); }, moving.actuation);
  for (std::size_t k = 0; k < 3; ++k) {
    Spatial<Interval> axis{0.0, 0.0, 0.0};
    axis[k] = 1.0;
    displacement[k] = orientations.along(axis, anchor);
    displacement[k].constant = displacement[k].constant - leg.base()[k];
  }
}

void SphericalHeldSlice::MovingLeg::set(const RevoluteActuation& crank) {
  crank_axis = enclosed(crank.axis);
  moves = true;
}

void SphericalHeldSlice::MovingLeg::set(const PrismaticActuation& slide) {
  rail = enclosed(slide.direction);
  moves = true;
}

void SphericalHeldSlice::MovingLeg::set(const StrutActuation&) {}

void SphericalHeldSlice::MovingLeg::set(const ElbowActuation&) {}

SphericalHeldSlice::Reach SphericalHeldSlice::MovingLeg::reach(const SlicePlace& at) const noexcept {
  Reach result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Jet<1> jet = displacement[k].jet<1>(at.over());
    Number& over = result.displacement[k];
    over = jet.value();
    over.gradient = {jet.at(1, 0), jet.at(0, 1)};
    result.center[k] = displacement[k].jet<0>(at.center()).value();
    over.value = result.range[k] = narrowed(over, result.center[k], at.middle());
  }
  result.squared_center = leg.form(result.center).squared_entry;
  result.squared_entry =
      narrowed(leg.form(result.displacement).squared_entry, result.squared_center, at.middle());
  return result;
}

std::optional<Spatial<Interval>> SphericalHeldSlice::MovingLeg::proximal_point(
    const Reach& reach, int sign, const SliceCenter& middle) const noexcept {
  const Interval root = root_of(reach.squared_entry);
  const auto points = leg.link_points(reach.range, root, sign);
  if (!points) return std::nullopt;
  Spatial<Interval> c = points->joint;
  if (!moves || !reach.squared_entry.positive()) return c;
  const auto center = leg.link_points(reach.center, root_of(reach.squared_center), sign);
  if (!center) return c;
  const Spatial<Interval> slope = joint_slope(c);
  const Number along = dot(c, reach.displacement);  // -g but for a constant
  const Interval inverse = reciprocal(sign > 0 ? -root : root);
  for (std::size_t k = 0; k < 3; ++k) {
    Number component(c[k]);
    for (std::size_t n = 0; n < 2; ++n) component.gradient[n] = slope[k] * (inverse * along.gradient[n]);
    c[k] = narrowed(component, center->joint[k], middle);
  }
  return c;
}

Spatial<Interval> SphericalHeldSlice::MovingLeg::joint_slope(const Spatial<Interval>& c) const noexcept {
  const Spatial<Interval> turning = cross(crank_axis, difference(c, leg.base()));
  return {turning[0] + rail[0], turning[1] + rail[1], turning[2] + rail[2]};
}

std::optional<HeldSlice::LegOver> SphericalHeldSlice::leg_over(std::size_t i, int sign,
                                                               const SlicePlace& at) const noexcept {
  const MovingLeg& moving = legs_[i];
  const Reach reach = moving.reach(at);
  LegOver result;
  result.reaches = is_positive(reach.squared_entry);
  if (reach.squared_entry.upper() < 0.0) return result;
  const auto c = moving.proximal_point(reach, sign, at.middle());
  if (!c) return std::nullopt;
  result.equation = orientations_.along(opposite(*c), moving.anchor);
  if (!moving.moves) return result;
  const Spatial<Interval> slope = moving.joint_slope(*c);
  result.slope = orientations_.along(opposite(slope), moving.anchor);
  result.slope.constant += dot(*c, slope);
  const Interval root = root_of(reach.squared_entry);
  result.entry = sign > 0 ? root : -root;
  return result;
}

HeldSlice::LegAt SphericalHeldSlice::leg_at(std::size_t i, const Interval& q) const noexcept {
  const MovingLeg& moving = legs_[i];
  const HeldPoint at(moving_leg(i), q);
  LegAt result{orientations_.along(opposite(at.c), moving.anchor),
               orientations_.along(opposite(at.slope), moving.anchor)};
  result.equation.constant +=
      Interval(0.5) * (squared_norm(moving.anchor) + squared_norm(at.c) - at.squared_rod);
  result.slope.constant += dot(at.c, at.slope) - at.rod_slope;
  return result;
}

std::optional<HeldSlice::RodOver> SphericalHeldSlice::rod_over(std::size_t i, int sign,
                                                               const SlicePlace& at) const noexcept {
  const Reach reach = legs_[i].reach(at);
  const Interval entry = sign == 0 ? Interval(0.0) : root_of(reach.squared_entry);
  const auto points = legs_[i].leg.link_points(reach.range, entry, sign);
  if (!points) return std::nullopt;
  return RodOver{points->joint, points->length};
}

Verdict SphericalHeldSlice::leg_within_limits(std::size_t i, int sign, const SlicePlace& at) const noexcept {
  const Reach reach = legs_[i].reach(at);
  return verdict(legs_[i].leg.limits(reach.range, root_of(reach.squared_entry), sign));
}

Interval SphericalHeldSlice::held_entry(const SlicePlace& at) const noexcept {
  return held_entry_.jet<0>(at.over()).value();
}

}  // namespace parallel_aspects
