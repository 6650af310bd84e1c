// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_PATHS_TRAJECTORY_YAML_H
#define PARALLEL_ASPECTS_TOOLS_PATHS_TRAJECTORY_YAML_H

#include "parallel_aspects/motion/check_trajectory.h"

#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// The waypoints of a trajectory_msgs/JointTrajectory as rostopic prints it; of several messages the first.
/// `file` is for messages, which are added to `problems`; the waypoints are of no meaning then.
std::vector<JointWaypoint> waypoints_of_message(const Manipulator& manipulator, const std::string& file,
                                                const std::string& text, Problems& problems);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_PATHS_TRAJECTORY_YAML_H
