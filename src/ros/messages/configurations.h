// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_CONFIGURATIONS_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_CONFIGURATIONS_H

#include "ros/messages/conversions.h"

#include <ros/time.h>

#include <cstdint>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The configurations that a request means.
struct ConfigurationAnswer {
  Status status;  ///< OK with at least one configuration, or why there is none
  ros::Time stamp;
  std::vector<SolvedPose> configurations;
};

/// Every configuration with this pose, in the given working mode or, where it is empty, in all.
ConfigurationAnswer configurations_at_pose(const Manipulator& manipulator, const Pose& pose,
                                           const std::vector<std::int8_t>& working_mode);

/// Every assembly mode at these actuated joints with this sign of det A, or, where it is 0, with any.
ConfigurationAnswer configurations_at_joints(const Manipulator& manipulator, const JointVector& q,
                                             int determinant_sign);

/// Why a robot with these actuated joints is not at a pose, for people: nothing reaches it, or how far the
/// nearest assembly mode is from it.
std::string why_not_at(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_CONFIGURATIONS_H
