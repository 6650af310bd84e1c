// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/joint_ranges.h"

#include "model/angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <variant>

namespace parallel_aspects {
namespace {

// More than 2 pi, by a rounding, so that no angle is left out.
constexpr double full_turn = 2.0 * pi * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());

/// Values that a joint can have where the anchor is at most this far from the base point of its leg.
class ReachableRange {
 public:
  ReachableRange(const Leg& leg, double reach) : leg_(leg), reach_(reach) {
    std::visit([this](const auto& actuation) { set(actuation); }, leg.actuation);
  }

  bool has_all_angles() const {
    return leg_.actuated_by_angle() && !(leg_.limits.upper - leg_.limits.lower < full_turn);
  }

  std::pair<double, double> within_limits() const {
    if (has_all_angles()) return {-0.5 * full_turn, 0.5 * full_turn};
    return {std::max(leg_.limits.lower, least_), std::max(least_, std::min(leg_.limits.upper, greatest_))};
  }

 private:
  void set(const RevoluteActuation&) {}
  void set(const ElbowActuation&) {}

  void set(const PrismaticActuation&) {
    least_ = -(reach_ + leg_.rod_length);
    greatest_ = reach_ + leg_.rod_length;
  }

  void set(const StrutActuation& strut) {
    const double shortest = -strut.sense * strut.length_at_zero;
    least_ = strut.sense > 0.0 ? shortest : shortest - reach_;
    greatest_ = strut.sense > 0.0 ? shortest + reach_ : shortest;
  }

  const Leg& leg_;
  double reach_, least_ = -HUGE_VAL, greatest_ = HUGE_VAL;
};

}  // namespace

JointRanges::JointRanges(const Manipulator& manipulator, const HeldJoint& held) : held_(held) {
  const Leg& fixed = manipulator.leg(held.leg);
  const Eigen::Vector3d c = fixed.proximal_point(held.value);
  const double rod = std::sqrt(fixed.squared_distance(held.value));
  for (std::size_t i = 0, j = 0; j < manipulator.leg_count(); ++j) {
    if (j == held.leg) continue;
    const Leg& leg = manipulator.leg(j);
    const double reach = (leg.anchor - fixed.anchor).norm() + rod + (c - leg.base_point()).norm();
    legs_[i] = j;
    are_angles_[i] = leg.actuated_by_angle();
    const ReachableRange range(leg, (1.0 + 1e-9) * reach);
    std::tie(values_.lower[i], values_.upper[i]) = range.within_limits();
    are_periodic_[i] = range.has_all_angles();
    ++i;
  }
}

std::string JointRanges::unit() const {
  if (are_angles_[0] != are_angles_[1]) return "m rad";
  return are_angles_[0] ? "rad^2" : "m^2";
}

std::array<double, 2> JointRanges::values_of(const JointVector& actuated) const noexcept {
  std::array<double, 2> result{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double value = actuated[static_cast<Eigen::Index>(legs_[i])], middle = values_.center(i);
    result[i] = are_angles_[i] ? middle + std::remainder(value - middle, 2.0 * pi) : value;
  }
  return result;
}

JointVector JointRanges::actuated(const std::array<double, 2>& values) const {
  JointVector q(3);
  q[static_cast<Eigen::Index>(held_.leg)] = held_.value;
  for (std::size_t i = 0; i < 2; ++i) q[static_cast<Eigen::Index>(legs_[i])] = values[i];
  return q;
}

}  // namespace parallel_aspects
