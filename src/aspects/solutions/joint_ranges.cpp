// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/joint_ranges.h"

#include "model/angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace parallel_aspects {
namespace {

// More than 2 pi, by a rounding, so that no angle is left out.
constexpr double full_turn = 2.0 * pi * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());

bool has_all_angles(const Leg& leg) {
  return leg.actuated_by_angle() && !(leg.limits.upper - leg.limits.lower < full_turn);
}

/// All lengths of a joint in the slice, by boxes that are small enough for ranges to be little larger.
Interval lengths_over(const HeldSlice& slice, std::size_t i, const Leg& leg) {
  constexpr int boxes = 32;
  constexpr double width = 2.0 / boxes;
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (int n = 0; n < boxes * boxes; ++n) {
    const double a = -1.0 + width * (n / boxes), phi = -1.0 + width * (n % boxes);
    const SlicePlace place = slice.place({2, {a, phi, 0.0}, {a + width, phi + width, 0.0}});
    for (const int sign : {-1, 1}) {
      const auto value = leg.has_branch(sign) ? slice.joint_value(i, sign, place) : std::nullopt;
      if (!value) continue;
      least = std::min(least, value->lower());
      greatest = std::max(greatest, value->upper());
    }
  }
  return {least, greatest};
}

/// Within limits.
Interval range_of_limits(const Leg& leg) {
  if (has_all_angles(leg)) return {-0.5 * full_turn, 0.5 * full_turn};
  return {leg.limits.lower, leg.limits.upper};
}

Interval range_of_joint(const HeldSlice& slice, std::size_t i, const Leg& leg) {
  if (leg.actuated_by_angle()) return range_of_limits(leg);
  const Interval lengths = lengths_over(slice, i, leg);
  const double least = std::max(leg.limits.lower, lengths.lower());
  return {least, std::max(least, std::min(leg.limits.upper, lengths.upper()))};
}

double in_turn_about(double middle, double angle) noexcept {
  return middle + std::remainder(angle - middle, 2.0 * pi);
}

}  // namespace

JointRanges::JointRanges(const Manipulator& manipulator, const HeldJoint& held, const HeldSlice& slice)
    : held_(held), legs_{slice.leg(0), slice.leg(1)} {
  for (std::size_t i = 0; i < 2; ++i) {
    const Leg& leg = manipulator.leg(legs_[i]);
    const Interval range = range_of_joint(slice, i, leg);
    values_.lower[i] = range.lower();
    values_.upper[i] = range.upper();
    are_angles_[i] = leg.actuated_by_angle();
    are_periodic_[i] = has_all_angles(leg);
  }
}

bool JointRanges::may_hold(std::size_t i, const Interval& values) const noexcept {
  if (are_periodic_[i]) return true;
  const double middle = 0.5 * (values.lower() + values.upper()), from = values_.center(i) - middle;
  const double distance = std::abs(are_angles_[i] ? std::remainder(from, 2.0 * pi) : from);
  const double reach = 0.5 * (values.upper() - values.lower() + values_.width(i));
  return !(distance > (1.0 + 1e-9) * reach + 1e-9);
}

std::string JointRanges::unit() const {
  if (are_angles_[0] != are_angles_[1]) return "m rad";
  return are_angles_[0] ? "rad^2" : "m^2";
}

std::array<double, 2> JointRanges::values_of(const JointVector& actuated) const noexcept {
  std::array<double, 2> result{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double value = actuated[static_cast<Eigen::Index>(legs_[i])];
    result[i] = are_angles_[i] ? in_turn_about(values_.center(i), value) : value;
  }
  return result;
}

JointVector JointRanges::actuated(const std::array<double, 2>& values) const {
  JointVector q(3);
  q[static_cast<Eigen::Index>(held_.leg)] = held_.value;
  for (std::size_t i = 0; i < 2; ++i) q[static_cast<Eigen::Index>(legs_[i])] = values[i];
  return q;
}

ValueSpace value_space_of(const Manipulator& manipulator) {
  ValueSpace space{{3, {}, {}}, {}, {}, false};
  for (std::size_t i = 0; i < 3; ++i) {
    const Leg& leg = manipulator.leg(i);
    const Interval range = range_of_limits(leg);
    space.values.lower[i] = range.lower();
    space.values.upper[i] = range.upper();
    space.are_angles[i] = leg.actuated_by_angle();
    space.are_periodic[i] = has_all_angles(leg);
  }
  return space;
}

std::array<double, 3> values_in(const ValueSpace& space, const JointVector& actuated) noexcept {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = actuated[static_cast<Eigen::Index>(i)];
    result[i] = space.are_angles[i] ? in_turn_about(space.values.center(i), value) : value;
  }
  return result;
}

std::string unit_of(const ValueSpace& space) {
  switch (std::count(space.are_angles.begin(), space.are_angles.end(), true)) {
    case 0:
      return "m^3";
    case 1:
      return "m^2 rad";
    case 2:
      return "m rad^2";
    default:
      return "rad^3";
  }
}

}  // namespace parallel_aspects
