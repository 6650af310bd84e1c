// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_RVIZ_STANDING_ROBOT_H
#define PARALLEL_ASPECTS_TEST_RVIZ_STANDING_ROBOT_H

#include "ros/monitor/five_bar_setup.h"

#include <ros/ros.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace parallel_aspects::test {

/// joint_states of a robot at one pose, a hundred times a second, until the object ends.
class StandingRobot {
 public:
  StandingRobot(const std::string& space, const Manipulator& robot, const Pose& pose,
                const std::vector<int>& signs)
      : publisher_(ros::NodeHandle().advertise<sensor_msgs::JointState>(space + "/joint_states", 100)),
        message_(joints_at(robot, pose, signs, ros::Time())),
        thread_([this] { publish(); }) {}
  ~StandingRobot() {
    stopping_ = true;
    thread_.join();
  }
  StandingRobot(const StandingRobot&) = delete;
  StandingRobot& operator=(const StandingRobot&) = delete;

 private:
  void publish() {
    while (!stopping_) {
      message_.header.stamp = ros::Time::now();
      publisher_.publish(message_);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  ros::Publisher publisher_;
  sensor_msgs::JointState message_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_RVIZ_STANDING_ROBOT_H
