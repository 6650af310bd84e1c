// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_FIVE_BAR_SETUP_H
#define PARALLEL_ASPECTS_TEST_ROS_FIVE_BAR_SETUP_H

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/urdf/mechanism.h"

#include <ros/time.h>

#include "support/robots/shipped.h"
#include <memory>
#include <sensor_msgs/JointState.h>
#include <string>
#include <vector>
#include <xmlrpcpp/XmlRpcValue.h>

namespace parallel_aspects::test {

inline std::shared_ptr<const Mechanism> five_bar_mechanism() { return shipped("five_bar"); }

/// The parameter `mechanism` that closes its loop.
inline XmlRpc::XmlRpcValue five_bar_mechanism_parameter() {
  XmlRpc::XmlRpcValue mechanism;
  mechanism["operational_point"] = "tool";
  mechanism["base_link"] = "base_link";
  mechanism["actuated_joints"][0] = "crank_1_joint";
  mechanism["actuated_joints"][1] = "crank_2_joint";
  mechanism["closures"][0]["type"] = "revolute";
  mechanism["closures"][0]["frames"][0] = "tool";
  mechanism["closures"][0]["frames"][1] = "closing_2";
  return mechanism;
}

inline Pose pose_at(double x, double y) {
  Pose pose;
  pose.position << x, y, 0.0;
  return pose;
}

/// joint_states of the actuated joints at a pose, in the working mode with these signs.
inline sensor_msgs::JointState joints_at(const Manipulator& manipulator, const Pose& pose,
                                         const std::vector<int>& signs, const ros::Time& stamp) {
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  for (const Leg& leg : manipulator.legs()) message.name.push_back(leg.actuated_joint);
  const JointVector q = inverse(manipulator, pose, *WorkingMode::from_signs(signs)).q;
  message.position.assign(q.data(), q.data() + q.size());
  return message;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_FIVE_BAR_SETUP_H
