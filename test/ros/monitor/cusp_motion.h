// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_CUSP_MOTION_H
#define PARALLEL_ASPECTS_TEST_ROS_CUSP_MOTION_H

#include "motion/choose/cusp_paths.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>
#include <ros/time.h>

#include "support/slices.h"
#include <cmath>
#include <cstddef>
#include <memory>
#include <sensor_msgs/JointState.h>
#include <vector>

namespace parallel_aspects::test {

/// Actuated values of the shipped 3-RPR where all six direct solutions are within its aspects.
inline JointVector values_with_six_solutions() { return Eigen::Vector3d(14.98, 15.38, 12.0); }

/// Where its platform is there, the first strut held: one of the six.
inline Pose pose_with_six_solutions(const Manipulator& robot, const AspectMap& slice, std::size_t solution) {
  const auto found = direct(robot, values_with_six_solutions()).solutions;
  return circle_of_anchor(robot, *slice.slice()->joint).nearest(found.at(solution).pose);
}

/// Around no cusp.
inline std::vector<JointVector> values_on_circle(int steps) {
  std::vector<JointVector> values;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 2.0 * EIGEN_PI * i / steps;
    values.push_back(values_with_six_solutions() +
                     0.3 * Eigen::Vector3d(0.0, std::cos(angle) - 1.0, std::sin(angle)));
  }
  return values;
}

inline sensor_msgs::JointState joint_states_of(const Manipulator& robot, const JointVector& q,
                                               const ros::Time& stamp) {
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  for (const Leg& leg : robot.legs()) message.name.push_back(leg.actuated_joint);
  message.position.assign(q.data(), q.data() + q.size());
  return message;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_CUSP_MOTION_H
