// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_TIMING_TIMED_CURVE_H
#define PARALLEL_ASPECTS_MOTION_TIMING_TIMED_CURVE_H

#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// How fast actuated joints may move; one entry a leg, positive.
struct MotionLimits {
  JointVector velocity;      ///< [rad/s or m/s]
  JointVector acceleration;  ///< [rad/s^2 or m/s^2]
};

/// A curve of the actuated joints, at its knots: twice continuously differentiable in its parameter.
struct JointCurve {
  std::vector<double> parameter;    ///< rising; about the time that it takes at the velocity limits [s]
  std::vector<JointVector> value;   ///< [rad or m]
  std::vector<JointVector> slope;   ///< by the parameter
  std::vector<JointVector> second;  ///< derivative, likewise

  std::size_t size() const noexcept { return parameter.size(); }  ///< of knots
};

/// The time from one to the other at velocity limits, as the root of the sum of squares over the joints [s].
double chord(const JointVector& from, const JointVector& to, const JointVector& velocity_limits);

/// The cubic spline through values, at least one. Its parameter is the sum of chords. So it is regular
/// wherever the joints move, at a serial singularity too, where the pose is not. Values that are so near to
/// the one before that they give no direction are left out, but never the first and last.
JointCurve spline_through(const std::vector<JointVector>& values, const JointVector& velocity_limits);

/// The squared speeds of the parameter at the knots of a curve [1/s^2 over the parameter's] with which it is
/// passed in the least time from rest to rest; the acceleration of the parameter is constant between two
/// knots.
///
/// By reachability analysis: H. Pham and Q.-C. Pham, "A new approach to time-optimal path parameterization
/// based on reachability analysis", IEEE Transactions on Robotics 34(3), 2018. Limits are kept at both ends
/// of each interval, each of which is to be `slower` than they say by a factor of its own, 1 or more.
std::vector<double> fastest_profile(const JointCurve& curve, const MotionLimits& limits,
                                    const std::vector<double>& slower);

/// A curve of the joints in time, from rest to rest.
struct TimedCurve {
  std::vector<JointWaypoint> waypoints;  ///< its knots, with velocities
  bool keeps_limits = false;             ///< whether the cubics between them do
  double loss = 0.0;  ///< about the share of the time by which it is slower since its knots are not denser
};

/// Passes the curve in the least time such that the cubics between its knots keep the limits; where they
/// would not, it is slower. It starts at `begin` [s]. Times are whole nanoseconds, as messages have them.
TimedCurve timed_curve(const JointCurve& curve, const MotionLimits& limits, double begin);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_TIMING_TIMED_CURVE_H
