// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_CONFIGURATIONS_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_CONFIGURATIONS_H

#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "ros/messages/conversions.h"

#include <parallel_aspects/Configuration.h>

#include <cstdint>
#include <functional>
#include <geometry_msgs/PoseStamped.h>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The working mode of these signs; none for empty ones or zeros, which mean any, and for what is none.
std::optional<WorkingMode> stated_mode(const std::vector<std::int8_t>& signs);

/// Whether they are those of a working mode of the robot, or mean any.
bool is_mode_of(const Manipulator& manipulator, const std::vector<std::int8_t>& signs);

/// What is stated of a configuration besides its pose or joint values.
struct StatedSigns {
  std::optional<WorkingMode> mode{};  ///< none for any
  int determinant_sign = 0;           ///< of det A; 0 for any
};
StatedSigns stated_signs(const Configuration& configuration);

/// What cannot be meant by a question: a kind or signs that there are not, or fields that its kind does not
/// look at. Empty where there is nothing.
std::string fault_of(const Manipulator& manipulator, const Configuration& configuration);

/// That an actuated joint is beyond its limits; empty where none is.
std::string beyond_limits(const Manipulator& manipulator, const JointVector& q);

/// Which margins from singularities the configurations do not keep; empty where all keep them.
std::string beyond_margins(const std::vector<ask::LocatedConfiguration>& configurations);

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

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_CONFIGURATIONS_H
