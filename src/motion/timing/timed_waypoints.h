// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_TIMING_TIMED_WAYPOINTS_H
#define PARALLEL_ASPECTS_MOTION_TIMING_TIMED_WAYPOINTS_H

#include "motion/timing/joint_curve.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <vector>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_MOTION_TIMING_TIMED_WAYPOINTS_H
