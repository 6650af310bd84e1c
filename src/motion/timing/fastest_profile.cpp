// SPDX-License-Identifier: BSD-3-Clause
#include "motion/timing/fastest_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A bound of the acceleration u of the parameter that is linear in its squared speed x.
struct Bound {
  double value = 0.0;
  double slope = 0.0;  // by x
};

/// What limits u at x, from below and from above.
struct Range {
  Bound least{-infinite, 0.0}, most{infinite, 0.0};

  void add(const Bound& lower, const Bound& upper) {
    if (lower.value > least.value) least = lower;
    if (upper.value < most.value) most = upper;
  }
};

/// One interval between two knots, with all that limits (u, x) at its first.
class Stretch {
 public:
  Stretch(const JointCurve& curve, const MotionLimits& limits, double slower, std::size_t first)
      : curve_(curve),
        most_(limits.acceleration / (slower * slower)),
        first_(first),
        length_(curve.parameter[first + 1] - curve.parameter[first]) {}

  /// The range of u at x such that x behind it is from 0 to `reachable`.
  Range range(double x, double reachable) const {
    Range range;
    for (std::size_t end = 0; end < 2; ++end)
      for (Eigen::Index j = 0; j < most_.size(); ++j) add_joint(j, end, x, range);
    const double twice = 2.0 * length_;
    range.add({-x / twice, -1.0 / twice}, {(reachable - x) / twice, -1.0 / twice});
    return range;
  }

  /// The largest x, at most `highest`, for which there is such a u: the least x where two bounds meet is come
  /// upon from above by Newton's method, in few steps, since the width of the range is concave.
  double highest(double highest, double reachable) const {
    constexpr int steps = 200;
    constexpr double rounding = 0x1p-40;
    double x = highest;
    for (int step = 0; step < steps && x > 0.0; ++step) {
      const Range at = range(x, reachable);
      const double width = at.most.value - at.least.value, slope = at.most.slope - at.least.slope;
      if (width >= 0.0) return x;
      if (!(slope < 0.0)) return 0.0;
      const double less = width / slope;
      x = std::max(0.0, x - less);
      if (less <= rounding * x) return x;
    }
    return x;
  }

 private:
  /// |q' u + q'' x| at one of its ends, where x is 2 u length more at the second.
  void add_joint(Eigen::Index j, std::size_t end, double x, Range& range) const {
    const double second = curve_.second[first_ + end][j];
    const double factor = curve_.slope[first_ + end][j] + (end == 1 ? 2.0 * length_ * second : 0.0);
    const double most = most_[j];
    if (std::abs(factor) < 1e-9) return add_without_acceleration(second, most, x, range);
    const Bound one{(-most - second * x) / factor, -second / factor},
        other{(most - second * x) / factor, -second / factor};
    if (factor > 0.0)
      range.add(one, other);
    else
      range.add(other, one);
  }

  /// Only x can be too large, and is brought down by bounds of u that cross there.
  static void add_without_acceleration(double second, double most, double x, Range& range) {
    if (std::abs(second) * x > most) range.add({std::abs(second) * x, std::abs(second)}, {most, 0.0});
  }

  const JointCurve& curve_;
  JointVector most_;  // acceleration
  std::size_t first_;
  double length_;
};

/// By the velocity limits alone.
double highest_at(const JointVector& slope, const JointVector& velocity) {
  double highest = infinite;
  for (Eigen::Index j = 0; j < slope.size(); ++j) {
    const double speed = velocity[j] / std::max(std::abs(slope[j]), 1e-12);
    highest = std::min(highest, speed * speed);
  }
  return highest;
}

}  // namespace

std::vector<double> fastest_profile(const JointCurve& curve, const MotionLimits& limits,
                                    const std::vector<double>& slower) {
  const std::size_t knots = curve.size();
  std::vector<double> reachable(knots, 0.0);  // from which the end can be reached
  for (std::size_t i = knots - 1; i-- > 1;)
    reachable[i] =
        Stretch(curve, limits, slower[i], i)
            .highest(highest_at(curve.slope[i], limits.velocity / std::max(slower[i - 1], slower[i])),
                     reachable[i + 1]);
  std::vector<double> profile(knots, 0.0);
  for (std::size_t i = 0; i + 2 < knots; ++i) {
    const double most = Stretch(curve, limits, slower[i], i).range(profile[i], reachable[i + 1]).most.value;
    const double next = profile[i] + 2.0 * (curve.parameter[i + 1] - curve.parameter[i]) * most;
    profile[i + 1] = std::clamp(next, 0.0, reachable[i + 1]);
  }
  return profile;
}

}  // namespace parallel_aspects
