// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_PATHS_TRAJECTORY_TEXT_H
#define PARALLEL_ASPECTS_TOOLS_PATHS_TRAJECTORY_TEXT_H

#include "parallel_aspects/motion/check_trajectory.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// Waypoints, with velocities if all have some, as CSV that `read_joint_waypoints` takes.
std::string trajectory_csv(const Manipulator& manipulator, const std::vector<JointWaypoint>& waypoints);

/// The same as a trajectory_msgs/JointTrajectory, as rostopic prints and publishes it. Times are rounded to
/// nanoseconds.
std::string trajectory_yaml(const Manipulator& manipulator, const std::vector<JointWaypoint>& waypoints);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_PATHS_TRAJECTORY_TEXT_H
