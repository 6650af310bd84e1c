// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/robot_description.h"

#include <gtest/gtest.h>

#include "support/robots/shipped.h"
#include "support/texts.h"

namespace parallel_aspects::ask {
namespace {

TEST(RobotDescription, IsThatOfTheMechanism) {
  const auto mechanism = test::shipped("delta");
  Session session(mechanism->manipulator());
  session.know(mechanism);
  const auto outcome = answer(session, DescribeQuestion());
  ASSERT_TRUE(outcome);
  const RobotDescription& found = outcome.answer;
  EXPECT_EQ(found.mechanism, mechanism);
  const InverseSolution home =
      inverse(*mechanism->manipulator(), found.home.pose,
              working_mode(*mechanism->manipulator(), found.home.pose, found.home.q).value());
  EXPECT_LT((home.q - found.home.q).norm(), 1e-9);
  ASSERT_TRUE(found.reach && found.reach->from);
  EXPECT_EQ(found.reach->lower.size(), 3U);
  EXPECT_LT(found.reach->lower.at(2).second, found.home.pose.position.z());
  EXPECT_TRUE(found.reach->alone.empty()) << "the platform does not turn";
}

TEST(RobotDescription, NeedsTheMechanism) {
  Session session(test::shipped("delta")->manipulator());
  const auto outcome = answer(session, DescribeQuestion());
  ASSERT_EQ(outcome.status, MapStatus::refused);
  EXPECT_TRUE(test::has(text_of(outcome.problems.at(0), plain_name), "as it was loaded"));
}

TEST(RobotDescription, HasTheConesOfUniversalJoints) {
  const auto robot = test::shipped("stewart")->manipulator();
  EXPECT_EQ(cones_of(*robot).size(),
            robot->constraints().cones.size() + robot->constraints().passive_cones.size());
}

}  // namespace
}  // namespace parallel_aspects::ask
