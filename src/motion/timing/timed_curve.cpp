// SPDX-License-Identifier: BSD-3-Clause
#include "motion/timing/timed_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr double shortest_chord = 0.02;  // of their mean; values nearer than that tell no direction

double length_of(const std::vector<JointVector>& values, const JointVector& limits) {
  double length = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) length += chord(values[i - 1], values[i], limits);
  return length;
}

JointCurve knots_of(const std::vector<JointVector>& values, const JointVector& limits) {
  JointCurve curve{{0.0}, {values.front()}, {}, {}};
  const double shortest = shortest_chord * length_of(values, limits) / static_cast<double>(values.size());
  for (std::size_t i = 1; i < values.size(); ++i) {
    const bool is_last = i + 1 == values.size();
    if (chord(curve.value.back(), values[i], limits) <= shortest) {
      if (!is_last) continue;
      if (curve.size() > 1) {
        curve.value.pop_back();
        curve.parameter.pop_back();
      }
    }
    const double length = chord(curve.value.back(), values[i], limits);
    if (!(length > 0.0)) continue;
    curve.parameter.push_back(curve.parameter.back() + length);
    curve.value.push_back(values[i]);
  }
  return curve;
}

/// Second derivatives at the knots by the usual tridiagonal system; constant in the first and last interval.
std::vector<JointVector> second_derivatives(const JointCurve& curve) {
  const std::size_t knots = curve.size();
  std::vector<JointVector> second(knots, JointVector::Zero(curve.value.front().size()));
  if (knots < 3) return second;
  std::vector<double> factor(knots, 0.0);
  factor[0] = 1.0;  // that of the first is that of the second, plus nothing
  for (std::size_t i = 1; i + 1 < knots; ++i) {
    const double before = curve.parameter[i] - curve.parameter[i - 1],
                 after = curve.parameter[i + 1] - curve.parameter[i];
    const JointVector bend = 6.0 * ((curve.value[i + 1] - curve.value[i]) / after -
                                    (curve.value[i] - curve.value[i - 1]) / before);
    const double pivot = 2.0 * (before + after) + before * factor[i - 1];
    // second[i] = held[i] + factor[i] second[i + 1]; held is kept in `second`.
    const JointVector held = (bend - before * second[i - 1]) / pivot;
    second[i] = held;
    factor[i] = -after / pivot;
  }
  second[knots - 1] = second[knots - 2] / (1.0 - factor[knots - 2]);
  for (std::size_t i = knots - 1; i-- > 0;) second[i] += factor[i] * second[i + 1];
  return second;
}

std::vector<JointVector> slopes(const JointCurve& curve) {
  const std::size_t knots = curve.size();
  std::vector<JointVector> slope(knots, JointVector::Zero(curve.value.front().size()));
  for (std::size_t i = 0; i + 1 < knots; ++i) {
    const double length = curve.parameter[i + 1] - curve.parameter[i];
    const JointVector rise = (curve.value[i + 1] - curve.value[i]) / length;
    slope[i] = rise - length / 6.0 * (2.0 * curve.second[i] + curve.second[i + 1]);
    slope[i + 1] = rise + length / 6.0 * (curve.second[i] + 2.0 * curve.second[i + 1]);
  }
  return slope;
}

}  // namespace

double chord(const JointVector& from, const JointVector& to, const JointVector& velocity_limits) {
  return (to - from).cwiseQuotient(velocity_limits).norm();
}

JointCurve spline_through(const std::vector<JointVector>& values, const JointVector& velocity_limits) {
  JointCurve curve = knots_of(values, velocity_limits);
  curve.second = second_derivatives(curve);
  curve.slope = slopes(curve);
  return curve;
}

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

/// The bound by the velocity limits alone.
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

namespace {

constexpr int passes = 8;
constexpr double rounding = 1e-6;  // of what keeps limits, far above that of numbers

double in_nanoseconds(double time) { return std::round(time * 1e9) / 1e9; }

/// A knot a moment later than it is passed: within half a nanosecond, so that the first order is enough.
JointWaypoint waypoint_at(const JointCurve& curve, const std::vector<double>& profile, std::size_t knot,
                          double later, double time) {
  const std::size_t next = std::min(knot + 1, curve.size() - 1), before = next - 1;
  const double acceleration =
      (profile[next] - profile[before]) / (2.0 * (curve.parameter[next] - curve.parameter[before]));
  const double speed = std::sqrt(profile[knot]);
  JointWaypoint waypoint;
  waypoint.time = time;
  waypoint.velocity = curve.slope[knot] * speed;
  waypoint.q = curve.value[knot] + later * waypoint.velocity;
  waypoint.velocity += later * (curve.slope[knot] * acceleration + curve.second[knot] * profile[knot]);
  return waypoint;
}

/// The largest |velocity| of a cubic from 0 to `duration`, whose acceleration is linear.
double fastest(double v0, double v1, double a0, double a1, double duration) {
  double most = std::max(std::abs(v0), std::abs(v1));
  const double share = a0 / (a0 - a1);
  if (a0 != a1 && share > 0.0 && share < 1.0)
    most = std::max(most, std::abs(v0 + 0.5 * a0 * share * duration));
  return most;
}

double excess_of_joint(const JointWaypoint& from, const JointWaypoint& to, const MotionLimits& limits,
                       Eigen::Index j) {
  const double duration = to.time - from.time, rise = (to.q[j] - from.q[j]) / duration;
  const double v0 = from.velocity[j], v1 = to.velocity[j];
  const double a0 = (6.0 * rise - 4.0 * v0 - 2.0 * v1) / duration,
               a1 = (2.0 * v0 + 4.0 * v1 - 6.0 * rise) / duration;
  return std::max(fastest(v0, v1, a0, a1, duration) / limits.velocity[j],
                  std::sqrt(std::max(std::abs(a0), std::abs(a1)) / limits.acceleration[j]));
}

/// What is this many times slower keeps the limits.
double excess(const JointWaypoint& from, const JointWaypoint& to, const MotionLimits& limits) {
  double most = 0.0;
  for (Eigen::Index j = 0; j < limits.velocity.size(); ++j)
    most = std::max(most, excess_of_joint(from, to, limits, j));
  return most;
}

std::vector<JointWaypoint> waypoints_of(const JointCurve& curve, const std::vector<double>& profile,
                                        double begin) {
  const JointVector still = JointVector::Zero(curve.value.front().size());
  std::vector<JointWaypoint> waypoints{{begin, curve.value.front(), still, {}}};
  double time = begin;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    time += 2.0 * (curve.parameter[i] - curve.parameter[i - 1]) /
            (std::sqrt(profile[i - 1]) + std::sqrt(profile[i]));
    const double shown = in_nanoseconds(time);
    waypoints.push_back(i + 1 < curve.size() ? waypoint_at(curve, profile, i, shown - time, shown)
                                             : JointWaypoint{shown, curve.value[i], still, {}});
  }
  return waypoints;
}

}  // namespace

TimedCurve timed_curve(const JointCurve& curve, const MotionLimits& limits, double begin) {
  std::vector<double> slower(curve.size() - 1, 1.0 + rounding);
  TimedCurve timed;
  for (int pass = 0; pass < passes; ++pass) {
    timed = {waypoints_of(curve, fastest_profile(curve, limits, slower), begin), true, 0.0};
    const bool is_even = pass + 2 >= passes;  // where nothing else does, all of it is slower
    double most = 1.0;
    for (std::size_t i = 0; i < slower.size(); ++i) {
      const JointWaypoint &from = timed.waypoints[i], &to = timed.waypoints[i + 1];
      const double more = excess(from, to, limits);
      timed.loss += (slower[i] - 1.0) * (to.time - from.time);
      timed.keeps_limits = timed.keeps_limits && more <= 1.0;
      most = std::max(most, more);
      if (more > 1.0) slower[i] *= more * (1.0 + rounding);
    }
    timed.loss /= std::max(timed.waypoints.back().time - begin, 1e-9);
    if (timed.keeps_limits) break;
    if (is_even)
      for (double& each : slower) each = std::max(each, most * (1.0 + rounding));
  }
  return timed;
}

}  // namespace parallel_aspects
