// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_POSE_READING_H
#define PARALLEL_ASPECTS_ROS_NODE_POSE_READING_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <parallel_aspects/Status.h>

#include <functional>
#include <geometry_msgs/PoseStamped.h>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Brings a pose into the base frame; nothing, and a message, where tf cannot.
using PoseTransformer = std::function<std::optional<geometry_msgs::Pose>(const geometry_msgs::PoseStamped&,
                                                                         std::string& message)>;

/// The pose of a message in the task frame; `which` begins the sentence of a status. With OK, and a message,
/// where the platform does not have all of its motion: then its projection.
Status read_pose(const Manipulator& manipulator, const PoseTransformer& to_base,
                 const geometry_msgs::PoseStamped& message, const std::string& which, Pose& pose);

/// Likewise of several with their times, which are as many.
Status read_waypoints(const Manipulator& manipulator, const PoseTransformer& to_base,
                      const std::vector<geometry_msgs::PoseStamped>& poses, const std::vector<double>& times,
                      std::vector<PoseWaypoint>& waypoints);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_POSE_READING_H
