// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_TIME_PATH_H
#define PARALLEL_ASPECTS_MOTION_TIME_PATH_H

#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/aspects/segment_certifier.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "parallel_aspects/motion/plan_path.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The pose at t, 0 to 1, between two points of a path: `pose_between`, or that of the planner.
using PoseBetween = std::function<Pose(const Pose& from, const Pose& to, double t)>;

/// A planned path in time.
struct TimedPath {
  /// Positions and velocities of the actuated joints, from rest to rest, and no accelerations: between them
  /// the joints run as cubics. Times are whole nanoseconds. Empty where there is none that is proved.
  std::vector<JointWaypoint> waypoints;

  double seconds = 0.0;     ///< of all of it
  std::size_t rounded = 0;  ///< corners of the path that are rounded
  std::size_t stops = 0;    ///< corners at which it stops
  TrajectoryCheck check;    ///< what is proved of the waypoints
  std::string message;      ///< what was done, or why there is none; a sentence

  explicit operator bool() const noexcept { return !waypoints.empty(); }  ///< whether there is one
};

/// Every reason why paths of this robot cannot be timed, a message each: actuated joints without a velocity
/// limit, accelerations that are not one a leg, positive and finite, or a tolerance.
Problems problems_of(const Manipulator& manipulator, const JointVector& acceleration);

/// Times a path that was found: in the least time along it that the velocity limits of the joints and these
/// acceleration limits allow [rad/s^2 or m/s^2], which the cubics between the waypoints keep at every time.
/// The corners are rounded where that is proved. All of it is proved again by `check_trajectory`, and sampled
/// more densely until it is. There must be no `problems_of`.
TimedPath time_path(const SegmentCertifier& certifier, const PlannedPath& path, const PoseBetween& between,
                    const JointVector& acceleration, const MapControl& control = {});

/// How long a path takes as `time_path` times it, for `PathWish`. The certifier outlives it.
PathTime path_timer(const SegmentCertifier& certifier, PoseBetween between, const JointVector& acceleration,
                    const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_TIME_PATH_H
