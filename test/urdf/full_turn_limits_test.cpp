// SPDX-License-Identifier: BSD-3-Clause
// Limits of +-3.14 and the like, which people write for none.
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/tracking/tracker.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"

namespace parallel_aspects {
namespace {

using test::Description;

Description nearly_a_turn(const std::string& constraints = "") {
  return {test::source_file("test/data/nearly_a_turn.urdf"),
          test::source_file("test/data/nearly_a_turn.yaml") + constraints};
}

std::size_t components(const Mechanism& mechanism) {
  const MapResult result = compute_aspect_map(mechanism.mapped_manipulator());
  EXPECT_EQ(result.status, MapStatus::complete) << result.message;
  return result.map->aspects().size();
}

TEST(NearlyAFullTurn, BoundsNoAspect) {
  const auto mechanism = test::load(nearly_a_turn());
  EXPECT_EQ(components(*mechanism), 10U) << "as many as without limits";
  EXPECT_TRUE(mechanism->mapped_manipulator()->constraint_kinds().none());
  const std::vector<std::string> expected{
      "robot.urdf limits joints to less than 0.01 rad below a full turn, which bounds no aspect: "
      "'crank_1_joint', 'crank_2_joint', 'elbow_1_joint', 'elbow_2_joint'; constraints: {strict_limits: "
      "true} in robot.yaml takes the limits as they are."};
  EXPECT_EQ(mechanism->notes(), expected);
}

TEST(NearlyAFullTurn, BoundsAspectsWhereLimitsAreStrict) {
  const auto mechanism = test::load(nearly_a_turn("constraints: {strict_limits: true}\n"));
  EXPECT_EQ(components(*mechanism), 20U);
  EXPECT_TRUE(mechanism->notes().empty());
}

// A stop or a cable may be there.
TEST(NearlyAFullTurn, HoldsInTime) {
  const auto mechanism = test::load(nearly_a_turn());
  const Manipulator& manipulator = *mechanism->manipulator();
  const Leg& leg = manipulator.leg(0);
  EXPECT_EQ(leg.limits.lower, -3.14);
  EXPECT_EQ(leg.limits.upper, 3.14);
  EXPECT_FALSE(mechanism->mapped_manipulator()->leg(0).limits.limited());
  EXPECT_EQ(mechanism->mapped_manipulator()->leg(0).limits.velocity, 2.0);
  const JointVector last = (JointVector(2) << 3.13, 0.0).finished();
  const JointVector next = (JointVector(2) << -3.13, 0.0).finished();
  EXPECT_EQ(unwrapped(manipulator, last, next), next) << "it went the long way, not through the stop";
  EXPECT_FALSE(manipulator.within_limits((JointVector(2) << 3.1405, 0.0).finished()));
  EXPECT_TRUE(mechanism->joint_outside_limits((Eigen::VectorXd(4) << 0.0, 3.1405, 0.0, 0.0).finished()));
}

TEST(NearlyAFullTurn, IsLessThanAHundredthOfARadian) {
  Description robot = nearly_a_turn();
  robot.change_urdf("3.14\"", "3.136\"");
  const auto mechanism = test::load(robot);
  EXPECT_EQ(mechanism->mapped_manipulator(), mechanism->manipulator());
  EXPECT_EQ(mechanism->mapped_manipulator()->constraints().passive_limits.size(), 2U);
  EXPECT_TRUE(mechanism->notes().empty());
}

}  // namespace
}  // namespace parallel_aspects
