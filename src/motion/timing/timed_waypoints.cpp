// SPDX-License-Identifier: BSD-3-Clause
#include "motion/timing/timed_waypoints.h"

#include "motion/timing/fastest_profile.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
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
