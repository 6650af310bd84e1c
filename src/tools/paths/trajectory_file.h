// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_PATHS_TRAJECTORY_FILE_H
#define PARALLEL_ASPECTS_TOOLS_PATHS_TRAJECTORY_FILE_H

#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "tools/subcommands.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// The waypoints of a trajectory_msgs/JointTrajectory as rostopic prints it; of several messages the first.
/// `file` is for messages, which are added to `problems`; the waypoints are of no meaning then.
std::vector<JointWaypoint> waypoints_of_message(const Manipulator& manipulator, const std::string& file,
                                                const std::string& text, Problems& problems);

/// `--path FILE`, which fills `file`.
Option path_option(std::string& file);

/// The poses of a CSV file: a header with `t` or `time` [s] and the coordinates of the task space [m or rad]
/// in any order, then a line for each waypoint. Throws `InvalidDescription` with every problem.
std::vector<PoseWaypoint> read_pose_waypoints(const Motions& motions, const std::string& file);

/// The values of the actuated joints in a file: a trajectory_msgs/JointTrajectory as rostopic prints it, or
/// CSV: a header with `t` or `time` [s] and their names in any order [rad or m]; with NAME/velocity for each
/// of them, and NAME/acceleration besides, where those are given. Throws `InvalidDescription` with every
/// problem.
std::vector<JointWaypoint> read_joint_waypoints(const Manipulator& manipulator, const std::string& file);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_PATHS_TRAJECTORY_FILE_H
