// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/aspect_map.h"
#include "ros/monitor/robot_monitor_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::expect_says_nothing;
using test::RobotMonitorTest;
using test::start_at_pose;
using test::timeout;

TEST_F(RobotMonitorTest, KnowsNothingBeforeTheFirstSample) { EXPECT_EQ(code(0.0), Status::NO_JOINT_STATES); }

TEST_F(RobotMonitorTest, TracksFromTheConfiguredPose) {
  const MonitorUpdate first = update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  ASSERT_TRUE(first.state);
  EXPECT_EQ(first.state->status.code, Status::OK) << first.state->status.message;
  EXPECT_EQ(first.state->header.stamp, at(1.0));
  EXPECT_EQ(first.state->header.frame_id, "base_link");
  EXPECT_NEAR(first.state->pose.position.x, 4.5, 1e-9);
  EXPECT_NEAR(first.state->pose.position.y, 8.0, 1e-9);
  EXPECT_EQ(first.state->working_mode, (std::vector<std::int8_t>{1, -1}));
  ASSERT_TRUE(first.tracked);
  EXPECT_NEAR(first.tracked->pose.position.y(), 8.0, 1e-9);
  const auto completed = monitor_.complete(*first.tracked, at(1.0));
  ASSERT_TRUE(completed);
  EXPECT_EQ(completed->name, mechanism_->joint_names());
}

TEST_F(RobotMonitorTest, ABadMessageMakesTheStateUnknownUntilTheNextGoodOne) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  sensor_msgs::JointState bad = joint_values(4.5, 8.0, {1, -1}, 1.1);
  bad.position[0] = std::numeric_limits<double>::quiet_NaN();
  const MonitorUpdate refused = update(bad, 1.1);
  ASSERT_TRUE(refused.state);
  EXPECT_EQ(refused.state->status.code, Status::INVALID_JOINT_STATES);
  EXPECT_NE(refused.warning.find("crank_1_joint"), std::string::npos);
  expect_says_nothing(*refused.state);
  EXPECT_FALSE(refused.tracked);
  EXPECT_EQ(code(1.1), Status::INVALID_JOINT_STATES);
  EXPECT_EQ(update(joint_values(4.5, 8.01, {1, -1}, 1.2), 1.2).state->status.code, Status::OK);
}

TEST_F(RobotMonitorTest, RefusesStampsThatDoNotIncrease) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  EXPECT_EQ(update(joint_values(4.5, 8.01, {1, -1}, 1.0), 1.1).state->status.code,
            Status::INVALID_JOINT_STATES);
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 0.9), 1.2).state->status.code,
            Status::INVALID_JOINT_STATES);
  sensor_msgs::JointState zero = joint_values(4.5, 8.0, {1, -1}, 0.0);
  zero.header.stamp = ros::Time();
  EXPECT_EQ(update(zero, 1.3).state->status.code, Status::INVALID_JOINT_STATES);
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 1.4), 1.4).state->status.code, Status::OK);
  EXPECT_EQ(monitor_.counts().invalid, 3U);
  EXPECT_EQ(monitor_.counts().usable, 2U);
}

TEST_F(RobotMonitorTest, AnUnknownJointIsSaidWhileTheRobotIsTracked) {
  sensor_msgs::JointState message = joint_values(4.5, 8.0, {1, -1}, 1.0);
  message.name.push_back("gripper_joint");
  message.position.push_back(0.0);
  const MonitorUpdate update_ = update(message, 1.0);
  EXPECT_EQ(update_.state->status.code, Status::OK);
  EXPECT_NE(update_.state->status.message.find("gripper_joint"), std::string::npos);
  EXPECT_NE(update_.warning.find("gripper_joint"), std::string::npos);
}

TEST_F(RobotMonitorTest, MessagesOfOtherRobotsChangeNothing) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  sensor_msgs::JointState foreign;
  foreign.name = {"gripper_joint"};
  foreign.position = {0.0};
  EXPECT_FALSE(update(foreign, 1.1).state);
  EXPECT_EQ(code(1.1), Status::OK);
}

// However often work is done until the next sample.
TEST_F(RobotMonitorTest, ALossIsReportedOnce) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  std::vector<AspectTransition> told = update(joint_values(4.5, 8.0, {1, -1}, 2.0), 2.0).transitions;
  for (int i = 1; i <= 5; ++i) {
    for (int k = 0; k < 4; ++k) monitor_.work();
    const auto more = update(joint_values(4.5, 8.0, {1, -1}, 2.0 + 0.1 * i), 2.0 + 0.1 * i).transitions;
    told.insert(told.end(), more.begin(), more.end());
  }
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told.front().kind, AspectTransition::LOST);
  EXPECT_NE(told.front().message.find("no sample came for so long"), std::string::npos)
      << told.front().message;
  EXPECT_EQ(told.front().header.stamp, at(2.0));
}

TEST_F(RobotMonitorTest, ForgetsEverythingWhenTimeIsReset) {
  update(joint_values(4.5, 8.0, {1, -1}, 5.0), 5.0);
  const MonitorUpdate again = update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  EXPECT_EQ(again.state->status.code, Status::OK) << again.state->status.message;
  EXPECT_EQ(again.state->header.stamp, at(1.0));
}

TEST_F(RobotMonitorTest, WhatWasBeforeTimeBeganAgainIsNotReported) {
  monitor_.set_map(compute_aspect_map(mechanism_->manipulator()).map);
  const auto first = update(joint_values(4.5, 8.0, {1, -1}, 5.0), 5.0).transitions;
  ASSERT_EQ(first.size(), 1U);
  const auto again = update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0).transitions;
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again.front().aspect_before, 0U);
  EXPECT_EQ(again.front().aspect_after, first.front().aspect_after);
}

TEST_F(RobotMonitorTest, AClockThatIsSetBackIsNoReasonToStartAsConfigured) {
  ros::Time::setNow(at(5.0));  // as a simulation does
  update(joint_values(4.5, 8.0, {1, -1}, 5.0), 5.0);
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0).state->status.code, Status::OK);
  ros::Time::init();  // from here on the clock of the computer
  ASSERT_FALSE(ros::Time::isSimTime());
  update(joint_values(4.5, 8.0, {1, -1}, 5.0), 5.0);
  const MonitorUpdate again = update(joint_values(4.5, 8.0, {1, -1}, 2.0), 2.0);
  EXPECT_EQ(again.state->status.code, Status::NOT_STARTED);
  EXPECT_NE(again.state->status.message.find("clock"), std::string::npos);
  EXPECT_EQ(monitor_.start_near(test::pose_at(4.5, 8.0), at(2.0)).code, Status::OK);
  EXPECT_EQ(code(2.0), Status::OK);
}

TEST_F(RobotMonitorTest, RefusesStampsThatNoClockGives) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  auto message = joint_values(4.5, 8.01, {1, -1}, 1.1);
  for (const ros::Time& stamp :
       {ros::Time(), at(1.0), at(0.5), at(1000.0), ros::Time(4294967295U, 999999999U)}) {
    message.header.stamp = stamp;
    const MonitorUpdate refused = update(message, 1.1);
    EXPECT_EQ(refused.state->status.code, Status::INVALID_JOINT_STATES) << stamp;
    EXPECT_NE(refused.warning.find("stamp"), std::string::npos) << refused.warning;
  }
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 1.2), 1.2).state->status.code, Status::OK);
}

TEST_F(RobotMonitorTest, AnEncoderThatWrapsHasNotTurned) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  for (int turn = 1; turn <= 3; ++turn) {
    auto wrapped = joint_values(4.5, 8.0 + 0.01 * turn, {1, -1}, 1.0 + 0.1 * turn);
    for (double& position : wrapped.position) position += (turn % 2 == 0 ? 2.0 : -2.0) * EIGEN_PI;
    const MonitorUpdate update_ = update(wrapped, 1.0 + 0.1 * turn);
    EXPECT_EQ(update_.state->status.code, Status::OK);
    EXPECT_TRUE(update_.transitions.empty());
    EXPECT_NEAR(update_.state->pose.position.y, 8.0 + 0.01 * turn, 1e-9);
  }
}

TEST_F(RobotMonitorTest, TheSameMessageAgainIsIgnored) {
  const auto message = joint_values(4.5, 8.0, {1, -1}, 1.0);
  EXPECT_EQ(update(message, 1.0).state->status.code, Status::OK);
  const MonitorUpdate again = update(message, 1.1);
  EXPECT_FALSE(again.state);
  EXPECT_TRUE(again.warning.empty());
  EXPECT_EQ(code(1.1), Status::OK);
  EXPECT_EQ(monitor_.counts().invalid, 0U);
  EXPECT_TRUE(expire(1.6)) << "it is as old as it was";
}

TEST_F(RobotMonitorTest, CountsWhatWasLost) {
  const auto send = [&](std::uint32_t sequence, double seconds) {
    auto message = joint_values(4.5, 8.0, {1, -1}, seconds);
    message.header.seq = sequence;
    monitor_.update(message, at(seconds), "/driver");
  };
  send(0, 1.0);
  send(0, 1.1);
  EXPECT_FALSE(monitor_.counts().counted);
  send(4294967295U, 1.2);  // another way of counting
  send(1, 1.3);            // 0 was lost
  EXPECT_TRUE(monitor_.counts().counted);
  EXPECT_EQ(monitor_.counts().lost, 1U);
  send(5, 1.4);
  EXPECT_EQ(monitor_.counts().lost, 4U);
}

TEST_F(RobotMonitorTest, PassiveJointsStartItAndContradictABrokenEncoder) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  const auto all = *monitor_.complete(monitor_.current(at(1.0)).tracked, at(1.0));
  NodeOptions options;
  options.joint_states_timeout = timeout;
  RobotMonitor monitor(mechanism_, options);
  auto alone = joint_values(4.5, 8.0, {1, -1}, 1.0);
  EXPECT_EQ(monitor.update(alone, at(1.0)).state->status.code, Status::NOT_STARTED);
  const auto candidates = monitor.work();
  ASSERT_TRUE(candidates);
  EXPECT_EQ(candidates->candidates.size(), 2U);
  EXPECT_TRUE(candidates->complete);
  alone.header.stamp = at(1.1);
  EXPECT_EQ(monitor.update(alone, at(1.1)).state->status.code, Status::AMBIGUOUS);

  auto measured = all;
  measured.header.stamp = at(1.2);
  monitor.update(measured, at(1.2));
  monitor.work();
  measured.header.stamp = at(1.3);
  const MonitorUpdate known = monitor.update(measured, at(1.3));
  EXPECT_EQ(known.state->status.code, Status::OK) << known.state->status.message;
  EXPECT_NEAR(known.state->pose.position.y, 8.0, 1e-9);
  monitor.work();

  for (std::size_t i = 0; i < measured.name.size(); ++i)
    if (measured.name[i].find("elbow") != std::string::npos) measured.position[i] += 0.2;
  measured.header.stamp = at(1.4);
  monitor.update(measured, at(1.4));
  monitor.work();
  measured.header.stamp = at(1.5);
  const MonitorUpdate broken = monitor.update(measured, at(1.5));
  EXPECT_EQ(broken.state->status.code, Status::INCONSISTENT);
  EXPECT_NE(broken.state->status.message.find("elbow"), std::string::npos) << broken.state->status.message;
  EXPECT_GT(broken.state->residual, 1.0);
  expect_says_nothing(*broken.state);
}

// Leg 1 goes through its stretched configuration while actuated joint 2 rests: B_11 changes sign, det A does
// not.
TEST_F(RobotMonitorTest, ReportsAWorkingModeThatChanges) {
  RobotMonitor monitor(mechanism_, start_at_pose(4.51, 11.73));
  const auto before = joint_values(4.51, 11.73, {1, -1}, 1.0),
             after = joint_values(4.51, 11.73, {-1, -1}, 1.0);
  const double change = std::remainder(after.position[0] - before.position[0], 2.0 * EIGEN_PI);
  std::vector<AspectTransition> transitions;
  AspectState last;
  constexpr int steps = 100;
  for (int step = 0; step <= steps; ++step) {
    sensor_msgs::JointState message = before;
    message.header.stamp = at(1.0 + 0.01 * step);
    message.position[0] += change * step / steps;
    const MonitorUpdate update = monitor.update(message, message.header.stamp);
    last = *update.state;
    transitions.insert(transitions.end(), update.transitions.begin(), update.transitions.end());
  }
  EXPECT_EQ(last.status.code, Status::OK) << last.status.message;
  EXPECT_NEAR(last.pose.position.y, 11.73, 1e-6);
  ASSERT_EQ(transitions.size(), 1U);
  const AspectTransition& transition = transitions.front();
  EXPECT_EQ(transition.kind, AspectTransition::WORKING_MODE);
  EXPECT_EQ(transition.leg, mechanism_->manipulator()->leg(0).name);
  EXPECT_EQ(transition.joint, "crank_1_joint");
  EXPECT_EQ(transition.working_mode_before, (std::vector<std::int8_t>{1, -1}));
  EXPECT_EQ(transition.working_mode_after, (std::vector<std::int8_t>{-1, -1}));
  EXPECT_EQ(transition.determinant_sign_before, transition.determinant_sign_after);
  EXPECT_GT(transition.header.stamp, at(1.0));
  EXPECT_LT(transition.header.stamp, at(2.0));
}

}  // namespace
}  // namespace parallel_aspects
