// SPDX-License-Identifier: BSD-3-Clause
//
// Samples that are too old, and whose fault that is said to be.
#include "parallel_aspects/aspects/aspect_map.h"
#include "ros/monitor/robot_monitor_fixture.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace parallel_aspects {
namespace {

using test::expect_says_nothing;
using test::RobotMonitorTest;
using test::start_at_pose;

class StaleState : public RobotMonitorTest {};

TEST_F(StaleState, BecomesStaleOnceAndRecovers) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  EXPECT_FALSE(expire(1.4));
  const auto stale = expire(1.6);
  ASSERT_TRUE(stale);
  EXPECT_EQ(stale->status.code, Status::STALE);
  expect_says_nothing(*stale);
  EXPECT_FALSE(expire(1.7));
  EXPECT_EQ(code(1.7), Status::STALE);
  const AspectState after = *update(joint_values(4.5, 8.01, {1, -1}, 1.8), 1.8).state;
  EXPECT_EQ(after.status.code, Status::AMBIGUOUS) << "it may have been moved meanwhile";
  EXPECT_NE(after.status.message.find("longest_interval"), std::string::npos) << after.status.message;
  EXPECT_EQ(monitor_.start_near(test::pose_at(4.5, 8.0), at(1.8)).code, Status::OK);
  EXPECT_EQ(update(joint_values(4.5, 8.01, {1, -1}, 1.9), 1.9).state->status.code, Status::OK);
  EXPECT_TRUE(expire(2.6));
}

// A simulation that is paused: nothing comes, and its clock says that no time goes by.
TEST_F(StaleState, AClockThatHaltsMakesItStaleUntilTheNextSample) {
  monitor_.set_map(compute_aspect_map(mechanism_->manipulator()).map);
  const AspectState before = *update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0).state;
  const auto halted = [&](double wall) { return monitor_.expire(at(1.0), ros::SteadyTime(wall)); };
  EXPECT_FALSE(halted(50.0));
  EXPECT_FALSE(halted(50.4));
  EXPECT_EQ(code(1.0), Status::OK);
  const auto stale = halted(50.6);
  ASSERT_TRUE(stale);
  EXPECT_EQ(stale->status.code, Status::STALE);
  EXPECT_NE(stale->status.message.find("paused"), std::string::npos) << stale->status.message;
  expect_says_nothing(*stale);
  EXPECT_EQ(code(1.0), Status::STALE);
  EXPECT_FALSE(halted(50.8)) << "that was said";
  const MonitorUpdate after = update(joint_values(4.5, 8.0, {1, -1}, 1.01), 1.01);
  EXPECT_EQ(after.state->status.code, Status::OK) << "by the stamps it has not been away";
  EXPECT_EQ(after.state->aspect, before.aspect);
  EXPECT_TRUE(after.transitions.empty());
  EXPECT_FALSE(monitor_.expire(at(1.01), ros::SteadyTime(90.0)));
}

// A driver that does not use the simulated clock, after the simulation was paused.
TEST_F(StaleState, WhatIsRefusedWhileTheClockStandsStillIsSaid) {
  monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0), "/simulation");
  EXPECT_FALSE(monitor_.expire(at(1.0), ros::SteadyTime(50.0)));
  EXPECT_TRUE(monitor_.expire(at(1.0), ros::SteadyTime(50.6)));
  const MonitorUpdate refused = monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1e6), at(1.0), "/driver");
  ASSERT_TRUE(refused.state);
  EXPECT_EQ(refused.state->status.code, Status::INVALID_JOINT_STATES) << refused.state->status.message;
}

// A driver that was restarted with another name: what arrives since is said, and what may be meant.
TEST_F(StaleState, StaleSaysWhichJointsArriveSince) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  auto message = joint_values(4.5, 8.0, {1, -1}, 1.3);
  message.name[1] = "crank2_joint";
  update(message, 1.3);
  const auto stale = expire(1.6);
  ASSERT_TRUE(stale);
  EXPECT_NE(stale->status.message.find("did you mean 'crank_2_joint' by 'crank2_joint'?"), std::string::npos)
      << stale->status.message;
}

TEST_F(StaleState, StaleSaysThatStampsAreBehindTheClock) {
  const MonitorUpdate late = update(joint_values(4.5, 8.0, {1, -1}, 1.0), 9.0);
  ASSERT_TRUE(late.state);
  EXPECT_EQ(late.state->status.code, Status::STALE);
  EXPECT_NE(late.state->status.message.find("behind this computer's clock"), std::string::npos)
      << late.state->status.message;
}

// A message is some time on its path, so its stamp is too old before its arrival is so long ago.
TEST_F(StaleState, ASilenceIsNoClockThatIsBehind) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.1);
  const auto stale = expire(1.55);
  ASSERT_TRUE(stale);
  EXPECT_NE(stale->status.message.find("The last usable joint_states are older"), std::string::npos)
      << stale->status.message;
}

// Stamps say when the robot was where, arrivals only what the network did.
TEST_F(StaleState, ASilenceCountsByStamps) {
  for (int i = 0; i < 20; ++i) update(joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.1 * i), 1.0 + 0.1 * i);
  for (int i = 20; i < 40; ++i) update(joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.1 * i), 5.0);
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 5.0), 5.0).state->status.code, Status::OK);
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 5.6), 5.6).state->status.code, Status::AMBIGUOUS);
}

TEST_F(StaleState, ContinuityAcrossSilencesCanBeStated) {
  NodeOptions options = start_at_pose(4.5, 8.0);
  options.tracking.samples.longest_interval = std::numeric_limits<double>::infinity();
  RobotMonitor trusting(mechanism_, options);
  trusting.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0));
  trusting.expire(at(1.9), ros::SteadyTime(101.9));
  EXPECT_EQ(trusting.update(joint_values(4.5, 8.1, {1, -1}, 2.0), at(2.0)).state->status.code, Status::OK);
}

TEST_F(StaleState, ASampleThatIsOldWhenItComesIsFollowedButStale) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  const MonitorUpdate late = update(joint_values(4.5, 8.1, {1, -1}, 1.1), 2.0);
  EXPECT_EQ(late.state->status.code, Status::STALE);
  expect_says_nothing(*late.state);
  EXPECT_FALSE(late.tracked);
  EXPECT_EQ(code(2.0), Status::STALE);
  EXPECT_FALSE(expire(2.1)) << "that was said";
  EXPECT_EQ(update(joint_values(4.5, 8.2, {1, -1}, 1.58), 2.05).state->status.code, Status::OK);
}

// After SIGSTOP, or on a computer without time: what waited meanwhile is old, which is no fault of its
// sender.
TEST_F(StaleState, AProcessThatStoodStillBlamesNoClock) {
  const auto beat = [&](double seconds) { monitor_.beat(ros::SteadyTime(100.0 + seconds)); };
  beat(1.0);
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  EXPECT_FALSE(expire(1.25));
  beat(9.0);
  const auto late = update(joint_values(4.5, 8.0, {1, -1}, 1.1), 9.0).state;
  ASSERT_TRUE(late);
  for (const Status& status : {late->status, monitor_.current(at(9.0)).status}) {
    EXPECT_EQ(status.code, Status::STALE);
    EXPECT_NE(status.message.find("stood still for 7.75 s"), std::string::npos) << status.message;
    EXPECT_EQ(status.message.find("clock"), std::string::npos) << status.message;
  }
  for (double seconds = 9.2; seconds < 10.0; seconds += 0.2) beat(seconds);
  const auto later = update(joint_values(4.5, 8.0, {1, -1}, 1.2), 10.0).state;
  EXPECT_NE(later->status.message.find("behind this computer's clock"), std::string::npos)
      << later->status.message;
}

}  // namespace
}  // namespace parallel_aspects
