// SPDX-License-Identifier: BSD-3-Clause
#include "legs/toleranced.h"

namespace parallel_aspects {
namespace {

Interval within(double value, double tolerance) noexcept {
  assert_rounding_upward();
  return Interval(value) + Interval(-tolerance, tolerance);
}

std::array<Interval, 3> within(const Eigen::Vector3d& point, double tolerance) noexcept {
  return {within(point.x(), tolerance), within(point.y(), tolerance), within(point.z(), tolerance)};
}

}  // namespace

Interval toleranced_length(double length, const Leg& leg) noexcept { return within(length, leg.tolerance); }

std::array<Interval, 3> toleranced_base(const Leg& leg) noexcept {
  return within(leg.base_point(), leg.tolerance);
}

std::array<Interval, 3> toleranced_anchor(const Leg& leg) noexcept {
  return within(leg.anchor, leg.tolerance);
}

// Of no kind of leg is the reach a sum of more than two lengths.
double toleranced_reach(const Leg& leg) noexcept {
  return (Interval(leg.longest_reach()) + Interval(2.0) * Interval(leg.tolerance)).upper();
}

}  // namespace parallel_aspects
