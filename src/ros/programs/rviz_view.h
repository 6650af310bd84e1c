// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PROGRAMS_RVIZ_VIEW_H
#define PARALLEL_ASPECTS_ROS_PROGRAMS_RVIZ_VIEW_H

#include "ros/parameters/load_options.h"

#include <string>

namespace parallel_aspects {

/// The text of an rviz configuration with its view set so that the robot and its gallery fill the window:
/// from above for planar robots, slightly from above in front of others. Throws `YAML::Exception` where
/// `config` is not such a text.
std::string with_view_of(const std::string& config, const NodeSetup& setup);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PROGRAMS_RVIZ_VIEW_H
