// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHECK_JOINT_TRAJECTORY_H
#define PARALLEL_ASPECTS_MOTION_CHECK_JOINT_TRAJECTORY_H

#include "parallel_aspects/motion/check_trajectory.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A point of trajectory_msgs/JointTrajectory: one entry a leg, in the order of the legs.
struct JointWaypoint {
  double time = 0.0;         ///< [s]
  JointVector q;             ///< [rad or m]
  JointVector velocity;      ///< [rad/s or m/s]; empty where not given
  JointVector acceleration;  ///< [rad/s^2 or m/s^2]; empty where not given
};

/// In which assembly mode a trajectory of the actuated joints starts. With neither, in the only one there is.
struct TrajectoryStart {
  std::optional<Pose> pose;  ///< about that of the first waypoint
  int determinant_sign = 0;  ///< of det A, +1 or -1; 0 where it is not stated
};

/// How far actuated joints may be off those that a stated start asks for: this angle, or this share of the
/// robot's size.
inline constexpr double start_tolerance = 0.01;

/// Whether a joint of that leg that is `off` its start [rad or m] is within the tolerance; not so where it is
/// not a number.
bool is_near_start(const Manipulator& manipulator, std::size_t leg, double off) noexcept;

/// The sign of det A that alone tells one of several starts from the others; 0 where there is none.
int telling_sign(const std::vector<PossibleStart>& starts, std::size_t which) noexcept;

/// Every reason why actuated joints cannot be checked, a message each: no waypoint, numbers that are not
/// finite, beyond 10^12 or not one a leg, times that do not rise by a nanosecond, accelerations without
/// velocities, a start pose that is off the first waypoint by more than `start_tolerance`.
Problems problems_of(const Manipulator& manipulator, const std::vector<JointWaypoint>& waypoints,
                     const TrajectoryStart& start);

/// Checks a trajectory of the actuated joints, between waypoints as the joint_trajectory_controller of
/// ros_controllers runs: a quintic where both have velocities and accelerations, a cubic where both have
/// velocities, else straight. The platform is followed from the start by certified continuation. A leg that
/// passes through B_jj = 0 is a violation. Refused, with the reason, where there are `problems_of`, where the
/// assembly mode at the start is not known, and where it is below a margin.
TrajectoryCheck check_trajectory(const SegmentCertifier& certifier,
                                 const std::vector<JointWaypoint>& waypoints, const TrajectoryStart& start,
                                 const TrajectoryCheckOptions& options = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHECK_JOINT_TRAJECTORY_H
