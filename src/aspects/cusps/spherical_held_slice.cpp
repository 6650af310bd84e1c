// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/spherical_held_slice.h"

#include "interval/dual.h"
#include "legs/determinant.h"

#include <variant>

namespace parallel_aspects {
namespace {

using Number = Dual<2, Interval>;

Spatial<Interval> enclosed(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

Spatial<Interval> difference(const Spatial<Interval>& a, const Spatial<Interval>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// What the value in the middle and the slopes over the box leave of it.
Interval narrowed(const Number& over, const Interval& center, const SliceCenter& middle) noexcept {
  return intersection(over.value,
                      center + over.gradient[0] * middle.offset(0) + over.gradient[1] * middle.offset(1));
}

/// A leg over a box, from the displacement of its anchor there and in the middle.
struct Displacement {
  Spatial<Number> over;
  Spatial<Interval> range, center;

  Displacement(const std::array<CosineSum, 3>& sums, const SlicePlace& at) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Jet<1> jet = sums[k].jet<1>(at.over());
      over[k] = Number(jet.value());
      over[k].gradient = {jet.at(1, 0), jet.at(0, 1)};
      center[k] = sums[k].jet<0>(at.center()).value();
      over[k].value = range[k] = narrowed(over[k], center[k], at.middle());
    }
  }

  /// p.m but for a constant.
  Number along(const Spatial<Interval>& m) const {
    return m[0] * over[0] + m[1] * over[1] + m[2] * over[2];
  }
};

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

/// c', of this c.
Spatial<Interval> SphericalHeldSlice::MovingLeg::joint_slope(const Spatial<Interval>& c) const {
  const Spatial<Interval> turning = cross(crank_axis, difference(c, leg.base()));
  return {turning[0] + rail[0], turning[1] + rail[1], turning[2] + rail[2]};
}

std::optional<HeldSlice::LegOver> SphericalHeldSlice::leg_over(std::size_t i, int sign,
                                                               const SlicePlace& at) const noexcept {
  const MovingLeg& moving = legs_[i];
  const Displacement d(moving.displacement, at);
  const Interval center_square = moving.leg.form(d.center).squared_entry;
  const Interval squared_entry = narrowed(moving.leg.form(d.over).squared_entry, center_square, at.middle());
  LegOver result;
  result.reaches = is_positive(squared_entry);
  if (squared_entry.upper() < 0.0) return result;
  const Interval root = square_root(not_negative_part(squared_entry));
  const auto points = moving.leg.link_points(d.range, root, sign);
  if (!points) return std::nullopt;
  Spatial<Interval> c = points->joint;
  if (moving.moves) {
    result.entry = sign > 0 ? root : -root;
    if (result.reaches == Verdict::holds) {
      const auto center = moving.leg.link_points(d.center, square_root(center_square), sign);
      if (center) {
        const Number along = d.along(c);
        const Spatial<Interval> slope = moving.joint_slope(c);
        const Interval inverse = reciprocal(result.entry);
        for (std::size_t k = 0; k < 3; ++k) {
          Number component(c[k]);
          for (std::size_t n = 0; n < 2; ++n)
            component.gradient[n] = -(inverse * along.gradient[n] * slope[k]);
          c[k] = narrowed(component, center->joint[k], at.middle());
        }
      }
    }
    const Spatial<Interval> slope = moving.joint_slope(c);
    result.slope = orientations_.along({-slope[0], -slope[1], -slope[2]}, moving.anchor);
    result.slope.constant += dot(c, slope);
  }
  result.equation = orientations_.along({-c[0], -c[1], -c[2]}, moving.anchor);
  return result;
}

Verdict SphericalHeldSlice::leg_within_limits(std::size_t i, int sign, const SlicePlace& at) const noexcept {
  const SpatialLeg& leg = legs_[i].leg;
  const Spatial<Interval> d = Displacement(legs_[i].displacement, at).range;
  return verdict(leg.limits(d, square_root(not_negative_part(leg.form(d).squared_entry)), sign));
}

Interval SphericalHeldSlice::held_entry(const SlicePlace& at) const noexcept {
  return held_entry_.jet<0>(at.over()).value();
}

}  // namespace parallel_aspects
