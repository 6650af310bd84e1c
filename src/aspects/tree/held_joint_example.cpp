// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/held_joint_example.h"

#include "model/message_text.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

struct Range {
  double lower, upper;
};

/// Within the limits, and of the size of the robot where these do not end.
Range range_of(const Manipulator& manipulator, const Leg& leg) {
  const double size = leg.actuated_by_angle() ? 1.0 : manipulator.characteristic_length();
  const JointLimits& limits = leg.limits;
  if (std::isfinite(limits.lower))
    return {limits.lower, std::isfinite(limits.upper) ? limits.upper : limits.lower + size};
  return std::isfinite(limits.upper) ? Range{limits.upper - size, limits.upper} : Range{size, 2.0 * size};
}

/// Of the second digit of the width of the range; 1 where it has no width.
double unit_of(const Range& range) {
  const double unit = std::pow(10.0, std::floor(std::log10(range.upper - range.lower)) - 1.0);
  return unit > 0.0 && std::isfinite(unit) ? unit : 1.0;
}

}  // namespace

// The middle of the limits is often where a robot is symmetric, which no other slice is like.
std::string example_of_held_joint(const Manipulator& manipulator, std::size_t leg) {
  const std::string& joint = manipulator.leg(leg).actuated_joint;
  const Range range = range_of(manipulator, manipulator.leg(leg));
  const double unit = unit_of(range);
  for (const double share : {0.4, 0.7, 0.5, 0.1}) {
    const double value = unit * std::round((range.lower + share * (range.upper - range.lower)) / unit);
    if (find_held_value_problem(manipulator, {leg, value, false}).empty())
      return "\"" + joint + "=" + number_text(value) + "\"";
  }
  return "";
}

std::string example_of_held_joint(const Manipulator& manipulator) {
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    if (std::string example = example_of_held_joint(manipulator, j); !example.empty()) return example;
  return "";
}

std::string example_of_held_range(const Manipulator& manipulator, std::size_t leg) {
  constexpr double widest_angle = 6.0;  // [rad], less than a turn
  const bool is_angle = manipulator.leg(leg).actuated_by_angle();
  const Range range = range_of(manipulator, manipulator.leg(leg));
  const double unit = unit_of(range);
  const double lower = unit * std::ceil(range.lower / unit), upper = unit * std::floor(range.upper / unit);
  return "\"" + manipulator.leg(leg).actuated_joint + "=" + number_text(lower) + ":" +
         number_text(is_angle ? std::min(upper, lower + widest_angle) : upper) + "\"";
}

}  // namespace parallel_aspects
