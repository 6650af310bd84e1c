// SPDX-License-Identifier: BSD-3-Clause
//
// How tracking starts, and what is said where it does not.
#include "ros/monitor/missing_state.h"
#include "ros/monitor/robot_monitor_fixture.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::expect_says_nothing;
using test::RobotMonitorTest;
using test::start_at_pose;

class MonitorStart : public RobotMonitorTest {};

TEST_F(MonitorStart, DoesNotStartFarFromTheConfiguredPose) {
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

TEST_F(MonitorStart, KeepsSayingThatTheConfiguredPoseCannotBeReached) {
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

TEST_F(MonitorStart, ARefusedStartChangesNothing) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  EXPECT_EQ(monitor_.start_near(test::pose_at(4.5, 3.0), at(1.0)).code, Status::NO_SOLUTION);
  const MonitorUpdate next = update(joint_values(4.5, 8.01, {1, -1}, 1.1), 1.1);
  EXPECT_EQ(next.state->status.code, Status::OK) << next.state->status.message;
  EXPECT_TRUE(next.transitions.empty());
}

TEST_F(MonitorStart, SaysWhyItDoesNotStartWhereItIsSaidToBe) {
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
TEST_F(MonitorStart, WhatItSaysToDoIsNotRefused) {
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

TEST_F(MonitorStart, StartsWithASignOfTheDeterminant) {
  update(joint_values(4.5, -8.0, {1, 1}, 1.0), 1.0);
  EXPECT_EQ(monitor_.start_with_sign({{}, -1}, at(1.0)).code, Status::OK);
  EXPECT_EQ(monitor_.current(at(1.0)).tracked.determinant_sign, -1);
}

// The five-bar is in (+,-), det A < 0 there.
TEST_F(MonitorStart, AStatementThatContradictsTheJointsIsRefused) {
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  const int sign = monitor_.current(at(1.0)).tracked.determinant_sign;
  const Pose pose = test::pose_at(4.5, 8.0);
  EXPECT_EQ(monitor_.start_near(pose, at(1.0), {WorkingMode::from_signs({1, -1}), sign}).code, Status::OK);
  for (const StatedSigns& stated : {StatedSigns{WorkingMode::from_signs({-1, 1}), 0}, StatedSigns{{}, -sign},
                                    StatedSigns{WorkingMode::from_signs({1, 1}), sign}}) {
    const Status refused = monitor_.start_near(pose, at(1.0), stated);
    EXPECT_EQ(refused.code, Status::NO_SOLUTION) << refused.message;
    EXPECT_NE(refused.message.find("in (+,-), det A "), std::string::npos) << refused.message;
    EXPECT_NE(refused.message.find("contradicts "), std::string::npos) << refused.message;
  }
  EXPECT_EQ(monitor_.start_with_sign({WorkingMode::from_signs({-1, 1}), sign}, at(1.0)).code,
            Status::NO_SOLUTION);
  EXPECT_EQ(monitor_.current(at(1.0)).status.code, Status::OK) << "nothing has changed";
  EXPECT_EQ(monitor_.current(at(1.0)).tracked.determinant_sign, sign);
}

TEST_F(MonitorStart, AStatementIsNoCrossing) {
  monitor_.set_map(compute_aspect_map(mechanism_->manipulator(), {}).map);
  update(joint_values(4.5, 8.0, {1, -1}, 1.0), 1.0);
  const int sign = monitor_.current(at(1.0)).tracked.determinant_sign;
  ASSERT_EQ(monitor_.start_with_sign({{}, -sign}, at(1.0)).code, Status::OK);
  const auto transitions = update(joint_values(4.5, 8.0, {1, -1}, 1.1), 1.1).transitions;
  std::string text;
  for (const AspectTransition& transition : transitions) text += transition.message + "\n";
  EXPECT_NE(text.find("the assembly mode was stated anew"), std::string::npos) << text;
  EXPECT_EQ(text.find("changed its sign"), std::string::npos) << text;
}

TEST_F(MonitorStart, CannotBeStartedWithoutDrives) {
  EXPECT_EQ(monitor_.start_with_sign({{}, 1}, at(1.0)).code, Status::NO_JOINT_STATES);
  EXPECT_EQ(monitor_.start_near(test::pose_at(4.5, 8.0), at(1.0)).code, Status::NO_JOINT_STATES);
}

TEST_F(MonitorStart, ARefusedStartKeepsTheCandidates) {
  NodeOptions options;
  options.joint_states_timeout = test::timeout;
  RobotMonitor monitor(mechanism_, options);
  monitor.update(joint_values(4.5, 8.0, {1, -1}, 1.0), at(1.0));
  const auto candidates = monitor.work();
  ASSERT_TRUE(candidates);
  EXPECT_EQ(candidates->candidates.size(), 2U);
  EXPECT_EQ(monitor.start_near(test::pose_at(4.5, 3.0), at(1.0)).code, Status::NO_SOLUTION);
  EXPECT_EQ(monitor.start_with_sign({{}, 0}, at(1.0)).code, Status::NO_SOLUTION);
  const auto after = monitor.work();
  EXPECT_FALSE(after) << after->message;
  EXPECT_EQ(monitor.current(at(1.0)).status.code, Status::AMBIGUOUS);
}

TEST_F(MonitorStart, CandidatesWithoutAReasonAreNotSaidToHaveOne) {
  const Tracker tracker(mechanism_->manipulator());
  const auto message =
      candidates_message(*mechanism_->manipulator(), tracker.state(), tracker.candidates(), at(1.0));
  EXPECT_EQ(message.message, "Which assembly modes are possible is not known yet.");
  EXPECT_FALSE(message.complete);
}

// What keeps the assembly mode unknown far from singularities is that the values are of different times.
TEST_F(MonitorStart, MergedJointsAreSaidToBeTheCauseAwayFromSingularities) {
  const JointVector uncertainty = JointVector::Constant(2, 0.1), none = JointVector::Zero(2);
  const auto message = [](const JointVector& merged) {
    return ambiguous_status(Ambiguity::near_parallel_singularity, merged, "", false).message;
  };
  EXPECT_NE(message(uncertainty).find("publish all of them in one message"), std::string::npos);
  EXPECT_EQ(message(none).find("in one message"), std::string::npos);
  const Manipulator& robot = *mechanism_->manipulator();
  const JointVector q = inverse(robot, test::pose_at(4.5, 8.0), *WorkingMode::from_signs({1, -1})).q;
  const std::string far = why_not_near(robot, q, test::pose_at(4.5, 3.0), 0.1, "that pose", uncertainty);
  EXPECT_NE(far.find("publish all of them in one message"), std::string::npos) << far;
}

}  // namespace
}  // namespace parallel_aspects
