// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_MONITOR_ROBOT_MONITOR_FIXTURE_H
#define PARALLEL_ASPECTS_TEST_ROS_MONITOR_ROBOT_MONITOR_FIXTURE_H

#include "ros/messages/hazard_messages.h"
#include "ros/monitor/five_bar_setup.h"
#include "ros/monitor/robot_monitor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace parallel_aspects::test {

constexpr double timeout = 0.5;  // of joint_states [s]

inline NodeOptions start_at_pose(double x, double y) {
  NodeOptions options;
  options.start.pose = std::vector<double>{x, y};
  options.joint_states_timeout = timeout;
  return options;
}

/// A monitor of the five-bar that starts at (4.5, 8).
class RobotMonitorTest : public testing::Test {
 protected:
  static ros::Time at(double seconds) { return ros::Time(100.0 + seconds); }

  sensor_msgs::JointState joint_values(double x, double y, const std::vector<int>& signs,
                                       double seconds) const {
    return joints_at(*mechanism_->manipulator(), pose_at(x, y), signs, at(seconds));
  }

  MonitorUpdate update(const sensor_msgs::JointState& message, double seconds) {
    return monitor_.update(message, at(seconds));
  }

  // Both clocks go alike.
  std::optional<AspectState> expire(double seconds) {
    return monitor_.expire(at(seconds), ros::SteadyTime(100.0 + seconds));
  }

  std::uint8_t code(double seconds) const { return monitor_.current(at(seconds)).status.code; }

  std::shared_ptr<const Mechanism> mechanism_ = five_bar_mechanism();
  RobotMonitor monitor_{mechanism_, start_at_pose(4.5, 8.0)};
};

inline void expect_says_nothing(const AspectState& state) {
  EXPECT_NE(state.status.code, Status::OK);
  EXPECT_FALSE(state.status.message.empty());
  EXPECT_TRUE(std::isnan(state.pose.position.x));
  EXPECT_TRUE(std::isnan(state.determinant));
  EXPECT_TRUE(state.working_mode.empty());
  EXPECT_EQ(state.determinant_sign, 0);
  EXPECT_EQ(state.aspect, 0U);
  EXPECT_GE(state.level, AspectState::STOP);
  EXPECT_EQ(state.level, AspectState::UNKNOWN);
  EXPECT_TRUE(std::isnan(state.parallel_distance.lower));
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_MONITOR_ROBOT_MONITOR_FIXTURE_H
