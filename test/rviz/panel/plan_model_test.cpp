// SPDX-License-Identifier: BSD-3-Clause
//
// Goals out of what was chosen, and planned paths to walk along.
#include "rviz/panel/plan_model.h"

#include <parallel_aspects/Configuration.h>
#include <parallel_aspects/Status.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

geometry_msgs::PoseStamped pose_at(double x, double y, double phi = 0.0) {
  geometry_msgs::PoseStamped pose;
  pose.pose.position.x = x;
  pose.pose.position.y = y;
  pose.pose.orientation.z = std::sin(0.5 * phi);
  pose.pose.orientation.w = std::cos(0.5 * phi);
  return pose;
}

// 3 m, a crossing, 4 m.
PlanPathResult through_a_gate() {
  PlanPathResult result;
  result.answer = PlanPathResult::YES;
  result.path.poses = {pose_at(0, 0), pose_at(3, 0), pose_at(3, 0), pose_at(3, 4)};
  result.working_modes = {1, 1, 1, 1, -1, 1, -1, 1};
  result.crossings = {1};
  result.crossing_legs = {"leg_1"};
  result.length = 7.0;
  result.least_index = 0.1234;
  return result;
}

NodeView followed_with_plan() {
  NodeView view;
  view.node = "/aspect_node";
  view.connected = true;
  view.state.emplace();
  return view;
}

TEST(PlanModel, AsksForWhatWasChosen) {
  PlanChoice choice;
  choice.goal = PlanEnd{pose_at(1, 2), {1, -1}};
  PlanPathGoal goal = goal_of(choice);
  EXPECT_EQ(goal.start.kind, Configuration::NOW);
  EXPECT_EQ(goal.goal.kind, Configuration::POSE);
  EXPECT_EQ(goal.goal.pose.pose, choice.goal->pose.pose);
  EXPECT_EQ(goal.goal.working_mode, choice.goal->working_mode);
  EXPECT_EQ(goal.policy, PlanPathGoal::STAY);
  EXPECT_TRUE(goal.path_only);
  EXPECT_EQ(goal.parallel_margin, 0.0);
  choice.start = PlanEnd{pose_at(5, 6), {}};
  choice.through_gates = choice.in_time = true;
  choice.parallel_margin = 0.2;
  goal = goal_of(choice);
  EXPECT_EQ(goal.start.pose.pose.position.x, 5.0);
  EXPECT_EQ(goal.policy, PlanPathGoal::SERIAL);
  EXPECT_FALSE(goal.path_only);
  EXPECT_EQ(goal.parallel_margin, 0.2);
}

TEST(PlanModel, RefusesWithAReason) {
  NodeView view = followed_with_plan();
  PlanChoice choice;
  EXPECT_NE(may_plan(view, choice, {}).refusal.find("goal"), std::string::npos);
  choice.goal.emplace();
  EXPECT_TRUE(may_plan(view, choice, {}));
  PlanView running;
  running.runs = true;
  EXPECT_FALSE(may_plan(view, choice, running));
  view.state->status.code = Status::AMBIGUOUS;
  EXPECT_FALSE(may_plan(view, choice, {}));
  choice.start.emplace();
  EXPECT_TRUE(may_plan(view, choice, {}));
  EXPECT_FALSE(may_plan(NodeView(), choice, {}));
}

TEST(PlanModel, PublishesNothingWithoutATopic) {
  PlanView plan;
  EXPECT_FALSE(may_publish(plan, "/arm/command"));
  auto result = std::make_shared<PlanPathResult>(through_a_gate());
  result->trajectory.points.resize(1);
  plan.result = result;
  EXPECT_FALSE(may_publish(plan, ""));
  EXPECT_FALSE(may_publish(plan, "not a name"));
  EXPECT_TRUE(may_publish(plan, "/arm/command"));
}

TEST(PlanModel, SaysWhatBecameOfIt) {
  PlanPathResult result = through_a_gate();
  EXPECT_EQ(text_of(result), "Proved path, 7 m. Changes of posture: 1 (leg_1). Least index 0.123.");
  result.seconds = 2.5;
  result.crossings.clear();
  EXPECT_EQ(text_of(result), "Proved path, 7 m in 2.5 s. It stays in one aspect. Least index 0.123.");
  result.answer = PlanPathResult::NO;
  result.reason = "it is apart.";
  EXPECT_EQ(text_of(result), "No path: it is apart.");
  result.status.code = Status::MAP_NOT_READY;
  result.status.message = "wait";
  EXPECT_EQ(text_of(result), "wait");
}

TEST(PlanModel, GoesToTheMiddleOfAnAspect) {
  NodeView view = followed_with_plan();
  EXPECT_FALSE(end_in_aspect(view, 1));
  ListAspects::Response list;
  list.aspects.resize(1);
  list.aspects[0].id = 4;
  list.aspects[0].working_mode = {1, -1};
  list.aspects[0].deepest_pose = pose_at(1, 2).pose;
  view.aspects = std::make_shared<const ListAspects::Response>(list);
  EXPECT_FALSE(end_in_aspect(view, 1));
  ASSERT_TRUE(end_in_aspect(view, 4));
  EXPECT_EQ(end_in_aspect(view, 4)->pose.pose, list.aspects[0].deepest_pose);
  EXPECT_EQ(end_in_aspect(view, 4)->working_mode, list.aspects[0].working_mode);
}

TEST(PlannedMotion, RunsEvenlyAlongThePath) {
  const PlannedMotion motion(through_a_gate());
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> shares(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double share = shares(generator), way = 7.0 * share;
    const geometry_msgs::Pose pose = motion.pose_at(share);
    EXPECT_NEAR(pose.position.x, std::min(way, 3.0), 1e-12) << share;
    EXPECT_NEAR(pose.position.y, std::max(way - 3.0, 0.0), 1e-12) << share;
    EXPECT_EQ(motion.mode_at(share).front(), way < 3.0 ? 1 : -1) << share;
  }
  EXPECT_EQ(motion.pose_at(1.0), pose_at(3, 4).pose);
  EXPECT_EQ(motion.pose_at(-1.0), pose_at(0, 0).pose);
  ASSERT_EQ(motion.crossings().size(), 1U);
  EXPECT_DOUBLE_EQ(motion.crossings()[0], 3.0 / 7.0);
  EXPECT_EQ(motion.mode_at(motion.crossings()[0]).front(), -1);
}

// The quaternion of the end has the other sign, which means the same orientation.
TEST(PlannedMotion, TurnsTheShortWay) {
  PlanPathResult result;
  result.path.poses = {pose_at(1, 1), pose_at(1, 1, 1.0)};
  result.path.poses[1].pose.orientation.z *= -1.0;
  result.path.poses[1].pose.orientation.w *= -1.0;
  result.working_modes = {1, 1};
  result.seconds = 3.0;
  const PlannedMotion motion(result);
  const geometry_msgs::Quaternion middle = motion.pose_at(0.5).orientation;
  EXPECT_NEAR(2.0 * std::atan2(middle.z, middle.w), 0.5, 1e-12);
  EXPECT_EQ(motion.seconds(), 3.0);
  EXPECT_TRUE(PlannedMotion().empty());
}

TEST(PlannedMotion, MayStandStill) {
  PlanPathResult result;
  result.path.poses = {pose_at(1, 1), pose_at(1, 1)};
  result.working_modes = {1, 1};
  const PlannedMotion motion(result);
  for (const double share : {0.0, 0.5, 1.0}) {
    EXPECT_EQ(motion.pose_at(share).position.x, 1.0);
    EXPECT_EQ(motion.pose_at(share).orientation.w, 1.0);
  }
}

}  // namespace
}  // namespace parallel_aspects
