// SPDX-License-Identifier: BSD-3-Clause
#include "ask/question_parts.h"
#include "parallel_aspects/ask/connect.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <string>

namespace parallel_aspects::ask {
namespace {

LocateQuestion at_pose(const Pose& pose) {
  LocateQuestion question;
  question.pose = pose;
  return question;
}

// The map, the signs of the configuration and a pose on the way back from its joint values say the same.
TEST(Locate, EachConfigurationLiesInAnAspectOfItsSigns) {
  Session session(test::five_bar());
  const auto located = answer(session, at_pose(Pose::planar(4.5, 8.0)));
  ASSERT_TRUE(located);
  ASSERT_EQ(located.answer.configurations.size(), 4U);
  const auto map = compute_aspect_map(session.robot()).map;
  for (const LocatedConfiguration& each : located.answer.configurations) {
    ASSERT_TRUE(each.location && *each.location);
    const Aspect& aspect = map->aspects().at(static_cast<std::size_t>(each.location->aspect - 1));
    EXPECT_EQ(aspect.mode, each.mode);
    EXPECT_EQ(aspect.determinant_sign, each.determinant_sign);
    LocateQuestion back;
    back.joints = each.q;
    back.mode = each.mode;
    back.sign = each.determinant_sign > 0 ? Sign::plus : Sign::minus;
    const auto again = answer(session, back).answer.configurations;
    ASSERT_EQ(again.size(), 1U);
    EXPECT_LT((again.front().pose.position - each.pose.position).norm(), 1e-6);
    EXPECT_EQ(again.front().location->aspect, each.location->aspect);
  }
}

TEST(Locate, WhatContradictsIsSaid) {
  Session session(test::five_bar());
  LocateQuestion question = at_pose(Pose::planar(4.5, 8.0));
  question.brief = true;
  std::size_t found = 0;
  for (const Sign sign : {Sign::plus, Sign::minus}) {
    question.sign = sign;
    found += answer(session, question).answer.configurations.size();
  }
  EXPECT_EQ(found, 4U);
  question.sign.reset();
  question.mode = WorkingMode::from_signs({1, -1});
  const LocatedConfiguration one = answer(session, question).answer.configurations.at(0);
  EXPECT_FALSE(one.location) << "no map is known";
  question.joints = one.q;
  question.mode = WorkingMode::from_signs({-1, 1});
  const LocateAnswer none = answer(session, question).answer;
  EXPECT_TRUE(none.configurations.empty());
  EXPECT_TRUE(test::has(none.reason, "in (+,-), det A"));
  EXPECT_TRUE(test::has(none.reason, "contradicts working mode (-,+)"));
}

TEST(Locate, SaysWhyThereIsNoConfiguration) {
  Session session(test::five_bar());
  const LocateAnswer far = answer(session, at_pose(Pose::planar(40.0, 0.0))).answer;
  EXPECT_TRUE(test::has(far.reason, "cannot reach"));
  const auto nothing = answer(session, LocateQuestion{});
  ASSERT_EQ(nothing.problems.size(), 1U);
  EXPECT_EQ(nothing.problems.front().kind, ProblemKind::missing);
  LocateQuestion sampled = at_pose(Pose::planar(4.5, 8.0));
  sampled.roadmap.samples.emplace().value = 20;
  EXPECT_EQ(answer(session, sampled).problems.at(0).field, "samples");
}

TEST(Locate, WithSixDegreesOfFreedomInARoadmap) {
  Session session(test::shipped("stewart")->mapped_manipulator());
  LocateQuestion question = at_pose(Pose{{0.0, 0.0, 1.3}, Eigen::Quaterniond::Identity()});
  question.roadmap.samples.emplace().value = 50;
  const auto located = answer(session, question);
  ASSERT_TRUE(located);
  for (const LocatedConfiguration& each : located.answer.configurations) EXPECT_FALSE(each.location);
  EXPECT_FALSE(located.answer.loaded);
}

}  // namespace
}  // namespace parallel_aspects::ask
