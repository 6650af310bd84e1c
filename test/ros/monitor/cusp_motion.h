// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_CUSP_MOTION_H
#define PARALLEL_ASPECTS_TEST_ROS_CUSP_MOTION_H

#include "motion/choose/plan_around_cusp.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/kinematics/direct.h"
#include "parallel_aspects/kinematics/inverse.h"

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

/// Actuated values along a path, which stop at each of its points without a jerk: a step that differs from
/// the last one counts as a bend.
inline std::vector<JointVector> values_along(const Manipulator& robot, const CuspPlanner& planner,
                                             const PlannedPath& path, int steps) {
  std::vector<JointVector> values;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int k = 0; k <= steps; ++k) {
      const double share = 0.5 - 0.5 * std::cos(EIGEN_PI * k / steps);
      const Pose pose = planner.between(path.points[i].pose, path.points[i + 1].pose, share);
      values.push_back(inverse(robot, pose, path.points[i].mode).q);
    }
  return values;
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
