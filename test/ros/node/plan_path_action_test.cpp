// SPDX-License-Identifier: BSD-3-Clause
//
// ~plan_path of the running node.
#include "ros/node/node_client.h"

#include <parallel_aspects/CheckTrajectory.h>
#include <parallel_aspects/MapProgress.h>
#include <parallel_aspects/PlanPathAction.h>
#include <parallel_aspects/Status.h>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <actionlib/client/simple_action_client.h>
#include <algorithm>
#include <cmath>
#include <nav_msgs/Path.h>
#include <string>
#include <trajectory_msgs/JointTrajectory.h>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {
namespace {

using actionlib::SimpleClientGoalState;
using test::at_pose;
using test::eventually;
using test::Recorder;
using Client = actionlib::SimpleActionClient<PlanPathAction>;
using Result = PlanPathResult;

const ros::Duration deadline(test::deadline);

// Along the way from one working mode to another, through one serial gate.
PlanPathGoal through_a_gate() {
  PlanPathGoal goal;
  goal.start = at_pose(4.5, 8.0, "", {1, 1});
  goal.goal = at_pose(4.5, -8.0, "", {-1, 1});
  goal.policy = PlanPathGoal::SERIAL;
  return goal;
}

PlanPathGoal in_one_aspect() {
  PlanPathGoal goal;
  goal.start = at_pose(4.5, 8.0, "");
  goal.goal = at_pose(4.0, 6.0, "");
  return goal;
}

struct Answer {
  SimpleClientGoalState state = SimpleClientGoalState::LOST;
  Result result;
};

class PlanPathAsked : public testing::Test {
 protected:
  static Answer ask(const PlanPathGoal& goal, const std::string& node = "/aspect_node") {
    Client client(node + "/plan_path", true);
    EXPECT_TRUE(client.waitForServer(deadline)) << node;
    client.sendGoal(goal);
    EXPECT_TRUE(client.waitForResult(deadline)) << node;
    const auto result = client.getResult();
    return {client.getState(), result ? *result : Result()};
  }

  static void wait_for_map(const std::string& node) {
    const Recorder<MapProgress> progress(node + "/map_progress");
    EXPECT_TRUE(
        eventually([&] { return progress.last() && progress.last()->state == MapProgress::COMPLETE; }));
  }

  static void expect_refused(const PlanPathGoal& goal, std::uint8_t code, const std::string& words,
                             const std::string& node = "/aspect_node") {
    const Answer answer = ask(goal, node);
    EXPECT_EQ(answer.state, SimpleClientGoalState::ABORTED) << words;
    EXPECT_EQ(answer.result.status.code, code) << answer.result.status.message;
    EXPECT_NE(answer.result.status.message.find(words), std::string::npos) << answer.result.status.message;
    EXPECT_EQ(answer.result.reason, answer.result.status.message);
    EXPECT_TRUE(answer.result.path.poses.empty() && answer.result.trajectory.points.empty());
  }
};

TEST_F(PlanPathAsked, PlansThroughAGateAndPublishesIt) {
  wait_for_map("/aspect_node");
  const Answer answer = ask(through_a_gate());
  const Result& result = answer.result;
  EXPECT_EQ(answer.state, SimpleClientGoalState::SUCCEEDED);
  ASSERT_EQ(result.status.code, Status::OK) << result.status.message;
  ASSERT_EQ(result.answer, Result::YES) << result.reason;
  EXPECT_EQ(result.path.header.frame_id, "base_link");
  EXPECT_EQ(result.path.poses.front().pose.position.y, 8.0);
  EXPECT_EQ(result.path.poses.back().pose.position.y, -8.0);
  EXPECT_EQ(result.working_modes.size(), 2 * result.path.poses.size());
  EXPECT_EQ(result.crossing_legs, std::vector<std::string>{"leg_1"});
  ASSERT_EQ(result.crossings.size(), 1U);
  ASSERT_LT(result.crossings[0] + 1, result.path.poses.size());
  EXPECT_EQ(result.working_modes[2 * result.crossings[0]], 1);
  EXPECT_EQ(result.working_modes[2 * (result.crossings[0] + 1)], -1);
  ASSERT_GT(result.trajectory.points.size(), 2U) << result.timing;
  EXPECT_GT(result.seconds, 0.5);
  EXPECT_NEAR(result.trajectory.points.back().time_from_start.toSec(), result.seconds, 1e-9);

  const Recorder<nav_msgs::Path> path("/aspect_node/planned_path");
  const Recorder<trajectory_msgs::JointTrajectory> trajectory("/aspect_node/planned_trajectory");
  const Recorder<visualization_msgs::MarkerArray> markers("/aspect_node/planned_path_markers");
  EXPECT_TRUE(eventually([&] { return path.last() && trajectory.last() && markers.last(); })) << "latched";
  EXPECT_EQ(*path.last(), result.path);
  EXPECT_EQ(*trajectory.last(), result.trajectory);
  EXPECT_EQ(markers.last()->markers.size(), 4U);  // delete, line, ends, gates
}

// What was planned is safe for the service that checks trajectories; through a gate, where it may pass that.
TEST_F(PlanPathAsked, PlansWhatIsSafe) {
  wait_for_map("/aspect_node");
  const Answer through = ask(through_a_gate());
  CheckTrajectory::Request passing;
  passing.trajectory = through.result.trajectory;
  passing.start = at_pose(4.5, 8.0, "");
  EXPECT_EQ(test::call<CheckTrajectory>("check_trajectory", passing).answer, CheckTrajectory::Response::NO);
  passing.pass_serial = 1;
  const auto passed = test::call<CheckTrajectory>("check_trajectory", passing);
  EXPECT_EQ(passed.answer, CheckTrajectory::Response::YES) << passed.reason << passed.status.message;
  EXPECT_EQ(passed.crossings.size(), 1U);
  passing.poses.resize(1);
  passing.times.resize(1);
  passing.trajectory.points.clear();
  EXPECT_EQ(test::call<CheckTrajectory>("check_trajectory", passing).status.code, Status::INVALID_REQUEST);

  const Answer answer = ask(in_one_aspect());
  ASSERT_EQ(answer.result.answer, Result::YES) << answer.result.reason;
  CheckTrajectory::Request request;
  request.trajectory = answer.result.trajectory;
  request.start = at_pose(4.5, 8.0, "");
  const auto checked = test::call<CheckTrajectory>("check_trajectory", request);
  EXPECT_EQ(checked.answer, CheckTrajectory::Response::YES) << checked.reason << checked.status.message;
  for (std::size_t j = 0; j < checked.never_faster.size(); ++j)
    EXPECT_LE(checked.never_faster[j], checked.velocity_limits[j]);

  PlanPathGoal untimed = in_one_aspect();
  untimed.path_only = true;
  const Answer path = ask(untimed);
  EXPECT_EQ(path.result.answer, Result::YES);
  EXPECT_TRUE(path.result.trajectory.points.empty());
}

TEST_F(PlanPathAsked, SaysNoWhereThereIsNone) {
  wait_for_map("/aspect_node");
  PlanPathGoal goal = in_one_aspect();
  goal.goal = at_pose(40.0, 8.0, "");
  const Answer far = ask(goal);
  EXPECT_EQ(far.state, SimpleClientGoalState::SUCCEEDED);
  EXPECT_EQ(far.result.status.code, Status::OK);
  EXPECT_EQ(far.result.answer, Result::NO);
  EXPECT_NE(far.result.reason.find("cannot reach"), std::string::npos) << far.result.reason;
  goal = through_a_gate();
  goal.policy = PlanPathGoal::STAY;
  EXPECT_EQ(ask(goal).result.answer, Result::NO);
}

// In T2 each aspect is a uniqueness domain.
TEST_F(PlanPathAsked, StaysInAUniquenessDomainWhereItStaysInAnAspect) {
  wait_for_map("/aspect_node");
  PlanPathGoal goal = in_one_aspect();
  goal.stay_in_domain = true;
  const Answer stays = ask(goal);
  EXPECT_EQ(stays.result.answer, Result::YES) << stays.result.reason;
  EXPECT_EQ(stays.result.in_one_domain, Result::YES);
  EXPECT_EQ(ask(through_a_gate()).result.in_one_domain, Result::NO);
  goal = through_a_gate();
  goal.stay_in_domain = true;
  const Answer leaves = ask(goal);
  EXPECT_EQ(leaves.result.answer, Result::UNKNOWN);
  EXPECT_TRUE(leaves.result.path.poses.empty());
  EXPECT_NE(leaves.result.reason.find("it leaves an aspect"), std::string::npos) << leaves.result.reason;
  goal = in_one_aspect();
  goal.around_cusp = 1;
  goal.start.working_mode = {1, 1};
  goal.held_joint = "crank_1_joint";
  expect_refused(goal, Status::INVALID_REQUEST, "");
}

TEST_F(PlanPathAsked, TakesThePathThatIsPreferred) {
  wait_for_map("/aspect_node");
  PlanPathGoal goal = through_a_gate();
  const Result shortest = ask(goal).result;
  goal.prefer = PlanPathGoal::CLEAR;
  const Result clear = ask(goal).result;
  goal.prefer = PlanPathGoal::FAST;
  const Result fast = ask(goal).result;
  ASSERT_EQ(shortest.answer, Result::YES) << shortest.reason;
  ASSERT_EQ(clear.answer, Result::YES) << clear.reason;
  ASSERT_EQ(fast.answer, Result::YES) << fast.reason;
  EXPECT_LE(shortest.length, clear.length);
  EXPECT_GE(clear.least_index, shortest.least_index);
  EXPECT_LE(fast.seconds, std::min(shortest.seconds, clear.seconds));
}

TEST_F(PlanPathAsked, RefusesWhatItCannotBeAsked) {
  PlanPathGoal goal = in_one_aspect();
  goal.policy = 7;
  expect_refused(goal, Status::INVALID_REQUEST, "policy");
  goal = in_one_aspect();
  goal.prefer = 4;
  expect_refused(goal, Status::INVALID_REQUEST, "prefer must be");
  goal.prefer = PlanPathGoal::FAST;
  goal.path_only = true;
  expect_refused(goal, Status::INVALID_REQUEST, "leave out path_only");
  goal = in_one_aspect();
  goal.start.kind = Configuration::NOW;
  goal.start.pose = geometry_msgs::PoseStamped();
  expect_refused(goal, Status::NO_JOINT_STATES, "");
  goal = in_one_aspect();
  goal.goal.working_mode = {1};
  expect_refused(goal, Status::INVALID_REQUEST, "goal: working_mode");
  goal = in_one_aspect();
  goal.goal.determinant_sign = 1;
  expect_refused(goal, Status::INVALID_REQUEST, "goal is stated by joints");
  goal = in_one_aspect();
  goal.start.pose.pose.position.x = std::nan("");
  expect_refused(goal, Status::INVALID_REQUEST, "start must be finite");
  goal = in_one_aspect();
  goal.start.pose.header.frame_id = "nowhere";
  expect_refused(goal, Status::NO_TRANSFORM, "nowhere");
}

// A map that takes the margin is computed for it.
TEST_F(PlanPathAsked, KeepsAMargin) {
  wait_for_map("/aspect_node");
  PlanPathGoal goal = in_one_aspect();
  goal.path_only = true;
  goal.parallel_margin = 0.3;
  const Answer answer = ask(goal);
  ASSERT_EQ(answer.result.answer, Result::YES) << answer.result.reason;
  EXPECT_GE(answer.result.least_index, 0.3);
  goal.start.working_mode = {1, -1};
  goal.parallel_margin = 0.999;  // more than it has there
  const Answer too_much = ask(goal);
  EXPECT_EQ(too_much.result.answer, Result::NO) << too_much.result.reason;
  goal.parallel_margin = 0.0;
  EXPECT_EQ(ask(goal).result.answer, Result::YES);
  for (const double wrong : {-0.1, 1.0, std::nan("")}) {
    goal.parallel_margin = wrong;
    expect_refused(goal, Status::INVALID_REQUEST, "parallel_margin");
  }
}

TEST_F(PlanPathAsked, StaysInASlice) {
  PlanPathGoal goal = in_one_aspect();
  goal.goal = at_pose(4.5, 6.0, "");
  goal.path_only = true;
  goal.held_names = {"x"};
  goal.held_values = {4.5};
  const Answer held = ask(goal);
  ASSERT_EQ(held.result.answer, Result::YES) << held.result.reason << held.result.status.message;
  for (const auto& pose : held.result.path.poses) EXPECT_NEAR(pose.pose.position.x, 4.5, 1e-9);
  goal.held_values = {4.4};
  expect_refused(goal, Status::INVALID_REQUEST, "start lies 0.1 m from the slice");
  goal.held_values.clear();
  expect_refused(goal, Status::INVALID_REQUEST, "give a value for each name");
  goal.held_names = {"q"};
  goal.held_values = {1.0};
  expect_refused(goal, Status::INVALID_REQUEST, "'q'");
}

TEST_F(PlanPathAsked, PassesDetAWhereAnyPathWillDo) {
  wait_for_map("/aspect_node");
  PlanPathGoal goal = through_a_gate();
  goal.policy = PlanPathGoal::ANY;
  goal.prefer = PlanPathGoal::QUICK;
  expect_refused(goal, Status::INVALID_REQUEST, "give policy serial");
  goal.path_only = true;
  const Answer any = ask(goal);
  ASSERT_EQ(any.result.answer, Result::YES) << any.result.reason;
  EXPECT_EQ(any.result.crossings.size(), any.result.crossing_legs.size());
}

TEST_F(PlanPathAsked, NeedsAMap) {
  expect_refused(in_one_aspect(), Status::MAP_NOT_READY, "not there yet", "/slow/aspect_node");
}

TEST_F(PlanPathAsked, NeedsVelocityLimitsForATrajectoryAlone) {
  wait_for_map("/unlimited/aspect_node");
  expect_refused(in_one_aspect(), Status::INVALID_REQUEST, "has no velocity limit", "/unlimited/aspect_node");
  PlanPathGoal goal = in_one_aspect();
  goal.path_only = true;
  EXPECT_EQ(ask(goal, "/unlimited/aspect_node").result.answer, Result::YES);
}

// Cancelled with its first feedback, that is while it is planned. A goal may be done before that arrives;
// where it is not, it ends as cancelled, and the next is answered.
TEST_F(PlanPathAsked, CanBeCancelledHalfWay) {
  wait_for_map("/aspect_node");
  Client client("/aspect_node/plan_path", true);
  ASSERT_TRUE(client.waitForServer(deadline));
  bool preempted = false;
  for (int i = 0; i < 50 && !preempted; ++i) {
    client.sendGoal(through_a_gate(), Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                    [&client](const PlanPathFeedbackConstPtr&) { client.cancelGoal(); });
    ASSERT_TRUE(client.waitForResult(deadline));
    preempted = client.getState() == SimpleClientGoalState::PREEMPTED;
  }
  ASSERT_TRUE(preempted);
  EXPECT_EQ(client.getResult()->status.code, Status::CANCELLED);
  EXPECT_TRUE(client.getResult()->path.poses.empty());
  EXPECT_EQ(ask(through_a_gate()).result.answer, Result::YES);
}

}  // namespace
}  // namespace parallel_aspects
