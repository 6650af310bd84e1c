// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/robot_monitor.h"

#include "parallel_aspects/aspects/aspect_map.h"
#include "ros/messages/hazard_messages.h"
#include "ros/monitor/decimation.h"
#include "ros/monitor/five_bar_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace parallel_aspects {
namespace {

constexpr double timeout = 0.5;

NodeOptions start_at_pose(double x, double y) {
  NodeOptions options;
  options.start.pose = std::vector<double>{x, y};
  options.joint_states_timeout = timeout;
  return options;
}

class RobotMonitorTest : public testing::Test {
 protected:
  static ros::Time at(double seconds) { return ros::Time(100.0 + seconds); }

  sensor_msgs::JointState joint_values(double x, double y, const std::vector<int>& signs,
                                       double seconds) const {
    return test::joints_at(*mechanism_->manipulator(), test::pose_at(x, y), signs, at(seconds));
  }

  MonitorUpdate update(const sensor_msgs::JointState& message, double seconds) {
    return monitor_.update(message, at(seconds));
  }

  // Both clocks go alike.
  std::optional<AspectState> expire(double seconds) {
    return monitor_.expire(at(seconds), ros::SteadyTime(100.0 + seconds));
  }

  std::uint8_t code(double seconds) const { return monitor_.current(at(seconds)).status.code; }

  std::shared_ptr<const Mechanism> mechanism_ = test::five_bar_mechanism();
  RobotMonitor monitor_{mechanism_, start_at_pose(4.5, 8.0)};
};

void expect_says_nothing(const AspectState& state) {
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

TEST_F(RobotMonitorTest, DoesNotStartFarFromTheConfiguredPose) {
  const MonitorUpdate first = update(joint_values(4.5, -8.0, {1, 1}, 1.0), 1.0);
  ASSERT_TRUE(first.state);
  EXPECT_EQ(first.state->status.code, Status::NOT_STARTED);
  for (const char* words : {"start/pose", "The nearest assembly mode of these actuated joints is", "m away"})
    EXPECT_NE(first.state->status.message.find(words), std::string::npos) << first.state->status.message;
  EXPECT_EQ(first.warning, first.state->status.message) << "also in the log";
  expect_says_nothing(*first.state);
  // Nor later, when the actuated joints pass by: the robot may be in its other assembly mode.
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 1.1), 1.1).state->status.code, Status::NOT_STARTED);
  EXPECT_EQ(monitor_.start_near(test::pose_at(4.5, 8.0), at(1.1)).code, Status::OK);
  EXPECT_EQ(update(joint_values(4.5, 8.01, {1, -1}, 1.2), 1.2).state->status.code, Status::OK);
}

TEST_F(RobotMonitorTest, KeepsSayingThatTheConfiguredPoseCannotBeReached) {
  RobotMonitor monitor(mechanism_, start_at_pose(40.0, 8.0));
  const auto first = monitor.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0));
  EXPECT_EQ(first.state->status.code, Status::NOT_STARTED);
  EXPECT_NE(first.warning.find("It cannot be reached in any working mode"), std::string::npos)
      << first.warning;
  monitor.work();
  const auto later = monitor.update(joint_values(4.5, 8.0, {1, -1}, 1.1), at(1.1));
  EXPECT_EQ(later.state->status.code, Status::AMBIGUOUS);
  EXPECT_NE(later.state->status.message.find("It cannot be reached"), std::string::npos);
  EXPECT_EQ(monitor.start_near(test::pose_at(4.5, 8.0), at(1.1)).code, Status::OK);
}

TEST_F(RobotMonitorTest, ARefusedStartChangesNothing) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  EXPECT_EQ(monitor_.start_near(test::pose_at(4.5, 3.0), at(1.0)).code, Status::NO_SOLUTION);
  const MonitorUpdate next = update(joint_values(4.5, 8.01, {1, -1}, 1.1), 1.1);
  EXPECT_EQ(next.state->status.code, Status::OK) << next.state->status.message;
  EXPECT_TRUE(next.transitions.empty());
}

TEST_F(RobotMonitorTest, SaysWhyItDoesNotStartWhereItIsSaidToBe) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  const auto why = [&](double x, double y) {
    const Status status = monitor_.start_near(test::pose_at(x, y), at(1.0));
    EXPECT_EQ(status.code, Status::NO_SOLUTION);
    return status.message;
  };
  EXPECT_NE(why(4.5, -8.0).find("The nearest assembly mode of these actuated joints is"), std::string::npos)
      << why(4.5, -8.0);
  EXPECT_NE(why(40.0, 8.0).find("It cannot be reached in any working mode"), std::string::npos)
      << why(40.0, 8.0);
}

// A node that is read-only refuses set_assembly_mode and reload, so it names neither as what to do.
TEST_F(RobotMonitorTest, WhatItSaysToDoIsNotRefused) {
  for (const bool read_only : {false, true}) {
    NodeOptions options = start_at_pose(4.5, 8.0);
    options.read_only = read_only;
    RobotMonitor lost(mechanism_, options);
    lost.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0));
    options.start.pose = std::vector<double>{4.5, -8.0};
    RobotMonitor elsewhere(mechanism_, options);
    options.start.pose.reset();
    RobotMonitor uninitialised(mechanism_, options);
    for (const std::string& message :
         {lost.update(joint_values(4.5, 8.0, {1, -1}, 3.0), at(3.0)).state->status.message,
          elsewhere.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0)).state->status.message,
          uninitialised.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0)).state->status.message}) {
      EXPECT_EQ(message.find("call set_assembly_mode") == std::string::npos, read_only) << message;
      EXPECT_EQ(message.find("call reload") == std::string::npos, read_only) << message;
      EXPECT_EQ(message.find("restart the node") != std::string::npos, read_only) << message;
      EXPECT_NE(message.find("set start/pose or start/determinant_sign"), std::string::npos) << message;
    }
  }
}

TEST_F(RobotMonitorTest, StartsWithASignOfTheDeterminant) {
  update(joint_values(4.5, -8.0, {1, 1}, 1.0), 1.0);
  EXPECT_EQ(monitor_.start_with_sign(-1, at(1.0)).code, Status::OK);
  EXPECT_EQ(monitor_.current(at(1.0)).tracked.determinant_sign, -1);
}

TEST_F(RobotMonitorTest, CannotBeStartedWithoutDrives) {
  EXPECT_EQ(monitor_.start_with_sign(1, at(1.0)).code, Status::NO_JOINT_STATES);
  EXPECT_EQ(monitor_.start_near(test::pose_at(4.5, 8.0), at(1.0)).code, Status::NO_JOINT_STATES);
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

TEST_F(RobotMonitorTest, TellsWhichJointsAreExpectedAndWhichArrive) {
  const auto named = [](const std::vector<std::string>& names) {
    sensor_msgs::JointState message;
    message.header.stamp = at(1.0);
    message.name = names;
    message.position.assign(names.size(), 0.0);
    return message;
  };
  const MonitorUpdate first = update(named({"crank1_joint", "crank2_joint"}), 1.0);
  ASSERT_TRUE(first.state);
  EXPECT_EQ(first.state->status.code, Status::NO_JOINT_STATES);
  for (const char* words :
       {"'crank_1_joint', 'crank_2_joint' are expected", "'crank1_joint', 'crank2_joint' arrive",
        "did you mean 'crank_1_joint', 'crank_2_joint' by 'crank1_joint', 'crank2_joint'?"})
    EXPECT_NE(first.state->status.message.find(words), std::string::npos) << first.state->status.message;
  EXPECT_EQ(first.warning, first.state->status.message);
  EXPECT_EQ(monitor_.current(at(1.0)).status.message, first.warning);
  EXPECT_FALSE(update(named({"crank1_joint", "crank2_joint"}), 1.1).state) << "that was said";
  const MonitorUpdate other = update(named({"panda_finger"}), 1.2);
  ASSERT_TRUE(other.state);
  EXPECT_NE(other.state->status.message.find("'panda_finger' arrive"), std::string::npos);
  EXPECT_TRUE(other.warning.empty()) << "once in the log";
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 1.3), 1.3).state->status.code, Status::OK);
  EXPECT_FALSE(update(named({"another"}), 1.4).state);
}

// Names of other robots would be work at their rate; what came while all was well is no reason for a silence.
TEST_F(RobotMonitorTest, JointsOfOthersAreHeardOnlyWhileNothingUsableComes) {
  sensor_msgs::JointState other;
  other.name = {"panda_finger"};
  other.position = {0.0};
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  update(other, 1.1);
  const auto stale = expire(1.6);
  ASSERT_TRUE(stale);
  EXPECT_EQ(stale->status.message.find("panda_finger"), std::string::npos) << stale->status.message;
  update(other, 1.7);
  EXPECT_NE(monitor_.current(at(1.8)).status.message.find("'panda_finger' arrives"), std::string::npos)
      << monitor_.current(at(1.8)).status.message;
}

TEST_F(RobotMonitorTest, GuessesTheJointThatIsMissing) {
  auto message = joint_values(4.5, 8.0, {1, -1}, 1.0);
  message.name[1] = "crank2_joint";
  const MonitorUpdate refused = update(message, 1.0);
  ASSERT_TRUE(refused.state);
  const std::string& text = refused.state->status.message;
  EXPECT_NE(text.find("did you mean 'crank_2_joint' by 'crank2_joint'?"), std::string::npos) << text;
}

TEST_F(RobotMonitorTest, KeepsLittleOfEnormousNames) {
  sensor_msgs::JointState message;
  for (int i = 0; i < 100000; ++i) message.name.push_back(std::string(300, 'x') + std::to_string(i));
  message.name.emplace_back(10000000, 'y');
  message.position.assign(message.name.size(), 0.0);
  const MonitorUpdate first = update(message, 1.0);
  ASSERT_TRUE(first.state);
  EXPECT_LT(first.state->status.message.size(), 3000U);
  for (int i = 0; i < 100; ++i) {
    message.name = {"joint_" + std::to_string(i)};
    message.position = {0.0};
    update(message, 1.1 + 0.001 * i);
  }
  EXPECT_NE(monitor_.current(at(2.0)).status.message.find("and others arrive"), std::string::npos);
}

TEST_F(RobotMonitorTest, BecomesStaleOnceAndRecovers) {
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

// Stamps say when the robot was where, arrivals only what the network did.
// A simulation that is paused: nothing comes, and its clock says that no time goes by.
TEST_F(RobotMonitorTest, AClockThatHaltsMakesItStaleUntilTheNextSample) {
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
TEST_F(RobotMonitorTest, WhatIsRefusedWhileTheClockStandsStillIsSaid) {
  monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0), "/simulation");
  EXPECT_FALSE(monitor_.expire(at(1.0), ros::SteadyTime(50.0)));
  EXPECT_TRUE(monitor_.expire(at(1.0), ros::SteadyTime(50.6)));
  const MonitorUpdate refused = monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1e6), at(1.0), "/driver");
  ASSERT_TRUE(refused.state);
  EXPECT_EQ(refused.state->status.code, Status::INVALID_JOINT_STATES) << refused.state->status.message;
}

// A driver that was restarted with another name: what arrives since is said, and what may be meant.
TEST_F(RobotMonitorTest, StaleSaysWhichJointsArriveSince) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  auto message = joint_values(4.5, 8.0, {1, -1}, 1.3);
  message.name[1] = "crank2_joint";
  update(message, 1.3);
  const auto stale = expire(1.6);
  ASSERT_TRUE(stale);
  EXPECT_NE(stale->status.message.find("did you mean 'crank_2_joint' by 'crank2_joint'?"), std::string::npos)
      << stale->status.message;
}

TEST_F(RobotMonitorTest, StaleSaysThatStampsAreBehindTheClock) {
  const MonitorUpdate late = update(joint_values(4.5, 8.0, {1, -1}, 1.0), 9.0);
  ASSERT_TRUE(late.state);
  EXPECT_EQ(late.state->status.code, Status::STALE);
  EXPECT_NE(late.state->status.message.find("behind this computer's clock"), std::string::npos)
      << late.state->status.message;
}

// A message is some time on its path, so its stamp is too old before its arrival is so long ago.
TEST_F(RobotMonitorTest, ASilenceIsNoClockThatIsBehind) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.1);
  const auto stale = expire(1.55);
  ASSERT_TRUE(stale);
  EXPECT_NE(stale->status.message.find("The last usable joint_states are older"), std::string::npos)
      << stale->status.message;
}

TEST_F(RobotMonitorTest, ASilenceCountsByStamps) {
  for (int i = 0; i < 20; ++i) update(joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.1 * i), 1.0 + 0.1 * i);
  for (int i = 20; i < 40; ++i) update(joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.1 * i), 5.0);
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 5.0), 5.0).state->status.code, Status::OK);
  EXPECT_EQ(update(joint_values(4.5, 8.0, {1, -1}, 5.6), 5.6).state->status.code, Status::AMBIGUOUS);
}

TEST_F(RobotMonitorTest, ContinuityAcrossSilencesCanBeStated) {
  NodeOptions options = start_at_pose(4.5, 8.0);
  options.tracking.samples.longest_interval = std::numeric_limits<double>::infinity();
  RobotMonitor trusting(mechanism_, options);
  trusting.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0));
  trusting.expire(at(1.9), ros::SteadyTime(101.9));
  EXPECT_EQ(trusting.update(joint_values(4.5, 8.1, {1, -1}, 2.0), at(2.0)).state->status.code, Status::OK);
}

// However often work is done until the next sample.
TEST_F(RobotMonitorTest, ALossIsToldOnce) {
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

// The second player has another name, its first messages come before the clock that it sets back.
TEST_F(RobotMonitorTest, ABagThatIsPlayedTwiceHasOnePublisher) {
  for (int i = 0; i <= 30; ++i)
    monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.1 * i), at(1.0 + 0.1 * i), "/play_1");
  for (int i = 0; i < 3; ++i) {
    const auto early = monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.1 * i), at(4.0), "/play_2");
    EXPECT_FALSE(early.state) << early.state->status.message;
  }
  const auto again = monitor_.update(joint_values(4.5, 8.0, {1, -1}, 1.3), at(1.3), "/play_2");
  EXPECT_EQ(again.state->status.code, Status::OK) << again.state->status.message;
}

TEST_F(RobotMonitorTest, WhatWasBeforeTimeBeganAnewIsNotTold) {
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

TEST_F(RobotMonitorTest, ASampleThatIsOldWhenItComesIsFollowedButStale) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  const MonitorUpdate late = update(joint_values(4.5, 8.1, {1, -1}, 1.1), 2.0);
  EXPECT_EQ(late.state->status.code, Status::STALE);
  expect_says_nothing(*late.state);
  EXPECT_FALSE(late.tracked);
  EXPECT_EQ(code(2.0), Status::STALE);
  EXPECT_FALSE(expire(2.1)) << "that was said";
  EXPECT_EQ(update(joint_values(4.5, 8.2, {1, -1}, 1.58), 2.05).state->status.code, Status::OK);
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

TEST_F(RobotMonitorTest, TwoNodesThatPublishTheDrivesAreRefused) {
  const auto send = [&](const char* publisher, double seconds) {
    return monitor_.update(joint_values(4.5, 8.0, {1, -1}, seconds), at(seconds), publisher).state;
  };
  const auto from = [&](const char* publisher, double seconds) { return send(publisher, seconds)->status; };
  EXPECT_EQ(from("/one", 1.0).code, Status::OK);
  EXPECT_FALSE(send("/two", 1.05)) << "the first may have ended";
  const Status refused = from("/one", 1.1);
  EXPECT_EQ(refused.code, Status::SEVERAL_PUBLISHERS);
  EXPECT_NE(refused.message.find("/one"), std::string::npos);
  EXPECT_NE(refused.message.find("/two"), std::string::npos);
  EXPECT_EQ(from("/two", 1.15).code, Status::SEVERAL_PUBLISHERS);
  EXPECT_EQ(from("/one", 1.2).code, Status::SEVERAL_PUBLISHERS);
  EXPECT_EQ(code(1.2), Status::SEVERAL_PUBLISHERS);
  EXPECT_NE(from("/one", 1.7).code, Status::SEVERAL_PUBLISHERS) << "the other one has been silent since";
}

// While both publish, that is what is said; only when they are silent, that nothing comes.
TEST_F(RobotMonitorTest, TwoNodesThatPublishTheDrivesAreNotStale) {
  const auto send = [&](const char* publisher, double seconds) {
    monitor_.update(joint_values(4.5, 8.0, {1, -1}, seconds), at(seconds), publisher);
  };
  send("/one", 1.0);
  for (int i = 1; i <= 20; ++i) {
    send("/two", 1.0 + 0.1 * i - 0.05);
    send("/one", 1.0 + 0.1 * i);
    ASSERT_FALSE(expire(1.0 + 0.1 * i)) << i;
  }
  EXPECT_EQ(code(3.0), Status::SEVERAL_PUBLISHERS);
  const auto stale = expire(3.6);
  ASSERT_TRUE(stale);
  EXPECT_EQ(stale->status.code, Status::STALE);
  EXPECT_EQ(code(3.6), Status::STALE);
}

// One of them ends: until it has been silent for the timeout nothing is said, least of all that nothing
// comes.
TEST_F(RobotMonitorTest, TheLastOfTwoPublishersIsNotStale) {
  const auto send = [&](const char* publisher, double seconds) {
    return monitor_.update(joint_values(4.5, 8.0, {1, -1}, seconds), at(seconds), publisher).state;
  };
  for (int i = 0; i < 10; ++i) send(i % 2 == 0 ? "/one" : "/two", 1.0 + 0.1 * i);
  std::optional<AspectState> state;
  for (int i = 10; !state || state->status.code == Status::SEVERAL_PUBLISHERS; ++i) {
    ASSERT_LT(i, 20);
    state = send("/one", 1.05 + 0.1 * i);
    ASSERT_FALSE(expire(1.05 + 0.1 * i)) << i;
  }
  EXPECT_EQ(state->status.code, Status::AMBIGUOUS) << "nobody knows how it moved meanwhile";
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

// One publisher for each joint, each half a period after the other.
TEST_F(RobotMonitorTest, DrivesOfSeveralPublishersAreMerged) {
  const auto send = [&](int actuation, double y, double seconds) {
    auto message = joint_values(4.5, y, {1, -1}, seconds);
    message.name = {message.name[static_cast<std::size_t>(actuation)]};
    message.position = {message.position[static_cast<std::size_t>(actuation)]};
    return monitor_.update(message, at(seconds), actuation == 0 ? "/one" : "/two");
  };
  const auto alone = send(0, 8.0, 1.0);
  EXPECT_EQ(alone.state->status.code, Status::NO_JOINT_STATES);
  EXPECT_NE(alone.state->status.message.find("crank_2_joint"), std::string::npos);
  EXPECT_EQ(send(1, 8.0 + 5e-4, 1.005).state->status.code, Status::NO_JOINT_STATES) << "none is as early";
  for (int i = 2; i < 100; ++i) {
    const MonitorUpdate merged = send(i % 2, 8.0 + 5e-4 * i, 1.0 + 0.005 * i);
    ASSERT_TRUE(merged.state);
    ASSERT_EQ(merged.state->status.code, Status::OK) << i << ": " << merged.state->status.message;
    EXPECT_EQ(merged.state->header.stamp, at(1.0 + 0.005 * (i - 1))) << "the last time that all are known of";
    EXPECT_LE(std::abs(merged.state->pose.position.y - 8.0 - 5e-4 * (i - 1)), merged.tracked->spread + 1e-9);
    monitor_.work();
  }
  EXPECT_TRUE(send(0, 8.05, 1.5).state);
  EXPECT_FALSE(send(0, 8.05, 1.7).state) << "the other value is too old";
  EXPECT_TRUE(expire(2.3)) << "actuated joints that are missing make it stale";
}

// Values that are long apart are not joined, which is said with what to do.
TEST_F(RobotMonitorTest, DrivesThatComeTooFarApartAreSaidToBe) {
  std::string text;
  for (int i = 0; i < 20 && text.find("in one message") == std::string::npos; ++i) {
    auto message = joint_values(4.5, 8.0, {1, -1}, 1.0 + 0.06 * i);
    const auto actuation = static_cast<std::size_t>(i % 2);
    message.name = {message.name[actuation]};
    message.position = {message.position[actuation]};
    const MonitorUpdate merged =
        monitor_.update(message, message.header.stamp, actuation == 0 ? "/one" : "/two");
    if (merged.state) text = merged.state->status.message;
  }
  EXPECT_NE(text.find("publish all of them in one message, or each more often"), std::string::npos) << text;
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

// Between two measurements distances are bounded by the motion since; the nearest boundary here is det A = 0.
TEST_F(RobotMonitorTest, DistancesAreBoundedAndJudged) {
  NodeOptions options = start_at_pose(4.5, 8.0);
  RobotMonitor unlimited(mechanism_, options);
  const auto first = unlimited.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0));
  EXPECT_TRUE(std::isnan(first.state->parallel_distance.lower)) << "not measured yet";
  unlimited.work();
  const AspectState here = *unlimited.update(joint_values(4.5, 8.0, {1, -1}, 1.01), at(1.01)).state;
  EXPECT_EQ(here.level, AspectState::CLEAR);
  ASSERT_GT(here.parallel_distance.lower, 0.0);
  EXPECT_GE(here.parallel_distance.upper, here.parallel_distance.lower);
  EXPECT_TRUE(std::isnan(first.state->stand_off)) << "not measured yet";
  EXPECT_GT(here.stand_off, 0.0);
  EXPECT_LT(here.stand_off, here.parallel_distance.lower);
  EXPECT_EQ(here.limit_distance.lower, std::numeric_limits<double>::infinity());
  const AspectState near = *unlimited.update(joint_values(4.5, 8.2, {1, -1}, 1.1), at(1.1)).state;
  EXPECT_NEAR(near.parallel_distance.lower, here.parallel_distance.lower - 0.2, 1e-6);
  EXPECT_NEAR(near.parallel_distance.upper, here.parallel_distance.upper + 0.2, 1e-6);

  options.thresholds.parallel_warn = here.parallel_distance.lower + 0.01;
  options.thresholds.parallel_stop = here.parallel_distance.lower - 0.1;
  RobotMonitor monitor(mechanism_, options);
  monitor.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0));
  monitor.work();
  const AspectState warned = *monitor.update(joint_values(4.5, 8.0, {1, -1}, 1.01), at(1.01)).state;
  EXPECT_EQ(warned.level, AspectState::WARN);
  EXPECT_NE(warned.reason.find("parallel singularity"), std::string::npos) << warned.reason;
  const AspectState stopped = *monitor.update(joint_values(4.5, 8.2, {1, -1}, 1.1), at(1.1)).state;
  EXPECT_EQ(stopped.level, AspectState::STOP) << "it may be that much closer now";
}

TEST_F(RobotMonitorTest, AMessageThatNobodyHasFilledIsNoLevel) {
  EXPECT_LT(AspectState().level, AspectState::CLEAR);
  EXPECT_EQ(unknown_state(*mechanism_->manipulator(), {}, {}).level, AspectState::UNKNOWN);
}

// Straight towards the nearest pose with det A = 0 of the present mode, and back: a share of the way and a
// time that go on in small steps.
class NearDeterminantZero : public RobotMonitorTest {
 protected:
  // Until the status is another one.
  AspectState go_to(double share) {
    for (const std::uint8_t code = state_.status.code;
         std::abs(share - share_) > 1e-9 && state_.status.code == code;) {
      share_ += std::clamp(share - share_, -0.001, 0.001);
      time_ += 0.01;
      if (state_.level != 0) last_ = state_;
      state_ = *monitor_
                    .update(joint_values(at_share().position.x(), at_share().position.y(), {1, -1}, time_),
                            at(time_))
                    .state;
      monitor_.work();
    }
    return state_;
  }
  Pose at_share() const {
    Pose pose = start_;
    pose.position += share_ * (nearest_.witness.position - start_.position);
    return pose;
  }
  NodeOptions options() const {
    NodeOptions options = start_at_pose(4.5, 8.0);
    options.thresholds.parallel_warn = 0.1 * nearest_.upper;
    return options;
  }

  const Pose start_ = test::pose_at(4.5, 8.0);
  const BoundaryDistance nearest_ = BoundaryDistanceMeter(mechanism_->manipulator())
                                        .measure(start_, *WorkingMode::from_signs({1, -1}))
                                        .parallel;
  RobotMonitor monitor_{mechanism_, options()};
  double share_ = -0.001, time_ = 1.0;
  AspectState state_, last_;  // present, and before
};

TEST_F(NearDeterminantZero, TellsTheLastProvedHazardWhileLostAndUntilItIsClearOfThat) {
  const AspectState lost = go_to(1.5);
  EXPECT_EQ(last_.level, AspectState::WARN);
  EXPECT_EQ(last_.last_hazard.kind, LastHazard::NONE);
  EXPECT_TRUE(std::isnan(last_.last_hazard.lower));
  EXPECT_EQ(lost.status.code, Status::AMBIGUOUS) << lost.status.message;
  expect_says_nothing(lost);
  EXPECT_EQ(lost.last_hazard.kind, LastHazard::PARALLEL_SINGULARITY);
  EXPECT_EQ(lost.last_hazard.stamp, last_.header.stamp);
  EXPECT_EQ(lost.last_hazard.lower, last_.parallel_distance.lower);
  EXPECT_LT(lost.last_hazard.speed, 0.0);
  EXPECT_NE(lost.reason.find("approached"), std::string::npos) << lost.reason;

  EXPECT_EQ(go_to(0.95).last_hazard.stamp, lost.last_hazard.stamp);
  ASSERT_EQ(monitor_.start_near(at_share(), at(time_)).code, Status::OK);
  state_.status.code = Status::OK;
  const AspectState near = go_to(0.94);
  EXPECT_EQ(near.level, AspectState::WARN) << near.reason;
  EXPECT_EQ(near.last_hazard.stamp, lost.last_hazard.stamp);
  const AspectState held = go_to(0.895);
  EXPECT_EQ(held.level, AspectState::WARN) << "within the hysteresis: " << held.reason;
  EXPECT_EQ(held.last_hazard.kind, LastHazard::PARALLEL_SINGULARITY);
  const AspectState clear = go_to(0.8);
  EXPECT_EQ(clear.level, AspectState::CLEAR) << clear.reason;
  EXPECT_EQ(clear.last_hazard.kind, LastHazard::NONE);
}

TEST(StandOffWarning, IsGivenWhereAThresholdLiesInside) {
  StandOffEstimate estimate;
  EXPECT_EQ(message_of(estimate), "") << "no parallel singularity was found";
  EXPECT_EQ(warning_of(estimate, 0.1), "");
  estimate.largest = 0.14;
  estimate.poses = 50;
  EXPECT_NE(message_of(estimate).find("0.14 m"), std::string::npos);
  EXPECT_NE(message_of(estimate).find("estimate"), std::string::npos);
  EXPECT_EQ(warning_of(estimate, 0.2), "");
  EXPECT_EQ(warning_of(estimate, 0.0), "") << "there is no threshold";
  EXPECT_NE(warning_of(estimate, 0.1).find("parallel_stop"), std::string::npos);
}

// A level that comes between two samples that are published is published too.
TEST(Decimation, TellsLevelsThatChange) {
  Decimation tested(10);
  AspectState state;
  state.level = AspectState::CLEAR;
  EXPECT_TRUE(tested.differs(state));
  EXPECT_FALSE(tested.differs(state));
  state.level = AspectState::STOP;
  EXPECT_TRUE(tested.differs(state));
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
