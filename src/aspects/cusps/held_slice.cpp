// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/held_slice.h"

#include "aspects/cusps/planar_held_slice.h"
#include "aspects/cusps/spherical_held_slice.h"
#include "interval/scalar_range.h"
#include "legs/determinant.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace parallel_aspects {
namespace {

std::vector<int> signs_of(const Leg& leg) {
  std::vector<int> signs;
  for (const int sign : {1, -1})
    if (leg.has_branch(sign)) signs.push_back(sign);
  return signs;
}

Spatial<Interval> difference(const Spatial<Interval>& a, const Eigen::Vector3d& b) noexcept {
  return {a[0] - b.x(), a[1] - b.y(), a[2] - b.z()};
}

/// Angles of the points of a rectangle; nothing where it holds the origin. They span less than half a turn,
/// and the corners have the least and the greatest.
std::optional<Interval> angle_over(const Interval& x, const Interval& y) noexcept {
  if (may_vanish(x) && may_vanish(y)) return std::nullopt;
  const double x0 = middle_of(x), y0 = middle_of(y);
  double least = 0.0, greatest = 0.0;
  for (const double at : {x.lower(), x.upper()})
    for (const double up : {y.lower(), y.upper()}) {
      const double angle = std::atan2(x0 * up - y0 * at, x0 * at + y0 * up);
      least = std::min(least, angle);
      greatest = std::max(greatest, angle);
    }
  constexpr double error = 16.0 * few_units;
  return Interval(least - error, greatest + error) + Interval(std::atan2(y0, x0));
}

// Joint values of a leg whose rod begins at c.

std::optional<Interval> value_of(const RevoluteActuation& crank, const Spatial<Interval>& c,
                                 const Interval&) noexcept {
  const Spatial<Interval> arm = difference(c, crank.center);
  return angle_over(dot(enclosed(crank.zero_direction), arm),
                    dot(cross(enclosed(crank.axis), enclosed(crank.zero_direction)), arm));
}

std::optional<Interval> value_of(const PrismaticActuation& slide, const Spatial<Interval>& c,
                                 const Interval&) noexcept {
  return dot(enclosed(slide.direction), difference(c, slide.origin));
}

std::optional<Interval> value_of(const StrutActuation& strut, const Spatial<Interval>&,
                                 const Interval& length) noexcept {
  return Interval(strut.sense) * (length - Interval(strut.length_at_zero));
}

std::optional<Interval> value_of(const ElbowActuation&, const Spatial<Interval>&, const Interval&) noexcept {
  return std::nullopt;
}

}  // namespace

SlicePlace::SlicePlace(const std::array<double, 2>& at, const SliceTurns& turns) noexcept
    : over_(turns), middle_(Box{2, {at[0], at[1], 0.0}, {at[0], at[1], 0.0}}), center_(turns) {}

const SliceTurns& SlicePlace::center() const noexcept {
  if (!center_) center_.emplace(middle_.at);
  return *center_;
}

HeldSlice::Fixed::Fixed(const Manipulator& manipulator, std::size_t of_leg)
    : held(of_leg), held_signs(signs_of(manipulator.leg(held))) {
  for (std::size_t i = 0, j = 0; j < manipulator.leg_count(); ++j)
    if (j != held) legs[i++] = j;
  for (const std::size_t j : legs) moving_legs.push_back(manipulator.leg(j));
  for (const int first : signs_of(manipulator.leg(legs[0])))
    for (const int second : signs_of(manipulator.leg(legs[1]))) postures.push_back({first, second});
}

HeldSlice::HeldSlice(const Manipulator& manipulator, std::size_t held, SliceSums sums)
    : sums_(sums), fixed_(std::make_shared<const Fixed>(manipulator, held)) {
  assert_rounding_upward();
}

Verdict HeldSlice::within_limits(const SlicePosture& posture, const SlicePlace& at) const noexcept {
  return both(leg_within_limits(0, posture[0], at), leg_within_limits(1, posture[1], at));
}

std::optional<Interval> HeldSlice::joint_value(std::size_t i, int sign, const SlicePlace& at) const noexcept {
  const auto rod = rod_over(i, sign, at);
  if (!rod) return std::nullopt;
  return std::visit([&](const auto& actuation) { return value_of(actuation, rod->from, rod->length); },
                    moving_leg(i).actuation);
}

Interval HeldSlice::joint_entry(std::size_t i, const LegOver& leg, const SlicePlace& at) const noexcept {
  if (moving_leg(i).kind().type != LegType::strut) return leg.entry;
  const double sense = moving_leg(i).has_branch(1) ? 1.0 : -1.0;
  return Interval(sense) * rod_over(i, 1, at)->length;
}

int HeldSlice::held_sign(const SlicePlace& at) const noexcept {
  if (fixed_->held_signs.size() == 1) return fixed_->held_signs.front();
  const Interval entry = held_entry(at);
  return entry.positive() ? 1 : entry.negative() ? -1 : 0;
}

std::optional<WorkingMode> HeldSlice::mode_of(const SlicePosture& posture,
                                              const SlicePlace& at) const noexcept {
  const int held = held_sign(at);
  if (held == 0 || posture[0] == 0 || posture[1] == 0) return std::nullopt;
  WorkingMode mode(3);
  mode.set_sign(fixed_->held, held);
  for (std::size_t i = 0; i < 2; ++i) mode.set_sign(leg(i), posture[i]);
  return mode;
}

std::unique_ptr<const HeldSlice> make_held_slice(const Manipulator& manipulator, const HeldJoint& joint) {
  if (manipulator.task_space() == TaskSpace::SO3)
    return std::make_unique<const SphericalHeldSlice>(manipulator, joint);
  return std::make_unique<const PlanarHeldSlice>(manipulator, joint);
}

}  // namespace parallel_aspects
