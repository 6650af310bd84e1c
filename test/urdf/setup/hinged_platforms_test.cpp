// SPDX-License-Identifier: BSD-3-Clause
//
// Platforms on two passive hinges as others write them, without a word on the loops. All are the shipped
// robots, by other frames, names and zeros.
#include "urdf/setup/setup_texts.h"

#include <gtest/gtest.h>

#include "support/loops.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <ostream>
#include <set>
#include <string>

namespace parallel_aspects {
namespace {

using test::listed;
using test::set_up_text;
using test::Strings;
using test::urdf_of;

struct Hinged {
  std::string file, shipped, base, platform;
  Strings joints;
  std::set<std::set<std::string>> closures;
};

void PrintTo(const Hinged& hinged, std::ostream* stream) { *stream << hinged.file; }

std::set<std::set<std::string>> closures_of(const SetupResult& result) {
  std::set<std::set<std::string>> pairs;
  for (const SetupChoice& choice : result.choices)
    for (const std::string& pair : choice.taken.values)
      if (const std::size_t middle = pair.find('='); choice.key == "closures")
        pairs.insert({pair.substr(0, middle), pair.substr(middle + 1)});
  return pairs;
}

class SetupOfHinged : public ::testing::TestWithParam<Hinged> {};

TEST_P(SetupOfHinged, FindsChainAndLegs) {
  const Hinged& expected = GetParam();
  const SetupResult result = set_up_text(urdf_of(expected.file));
  ASSERT_TRUE(result.mechanism) << listed(result.problems) << (result.question ? result.question->text : "");
  EXPECT_FALSE(result.question) << result.question->text;
  EXPECT_EQ(closures_of(result), expected.closures);
  const Mechanism& found = *result.mechanism;
  const auto of_shipped = test::shipped(expected.shipped);
  const Manipulator &robot = *found.manipulator(), &shipped = *of_shipped->manipulator();
  EXPECT_EQ(robot.task_space(), TaskSpace::R2);
  EXPECT_EQ(robot.base_frame(), expected.base);
  EXPECT_EQ(found.platform_link(), expected.platform);
  EXPECT_EQ(test::actuated_joints(found), expected.joints);
  EXPECT_NEAR(robot.description().hinges.offset, shipped.description().hinges.offset, 1e-9);
  EXPECT_NEAR(robot.description().hinges.twist, shipped.description().hinges.twist, 1e-9);
  ASSERT_EQ(robot.leg_count(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT((robot.leg(k).base_point() - shipped.leg(k).base_point()).norm(), 1e-9) << k;
    EXPECT_LT((robot.leg(k).anchor - shipped.leg(k).anchor).norm(), 1e-9) << k;
    if (robot.leg(k).actuated_by_angle()) {
      EXPECT_NEAR(robot.leg(k).rod_length, shipped.leg(k).rod_length, 1e-9) << k;
    }
  }
  EXPECT_EQ(test::open_loops(found), 0);
}

INSTANTIATE_TEST_SUITE_P(All, SetupOfHinged,
                         ::testing::Values(Hinged{"humanoid_ankle",
                                                  "ankle",
                                                  "left_shank",
                                                  "left_foot",
                                                  {"left_outer_motor_joint", "left_inner_motor_joint"},
                                                  {{"left_foot_outer_ball", "left_outer_rod_end"},
                                                   {"left_foot_inner_ball", "left_inner_rod_end"}}},
                                           Hinged{"exported_ankle",
                                                  "ankle",
                                                  "Tibia",
                                                  "Pied",
                                                  {"Pivot3", "Pivot7"},
                                                  {{"Repere7", "Repere27"}, {"Repere11", "Repere31"}}},
                                           Hinged{"antenna_mount",
                                                  "tilt_table",
                                                  "ground",
                                                  "dish",
                                                  {"east_stroke", "north_stroke"},
                                                  {{"dish_east", "east_eye"}, {"dish_north", "north_eye"}}}),
                         [](const auto& hinged) { return hinged.param.file; });

// The knee of the humanoid is in no loop, and the hinges of its ankle are no legs, whatever their efforts.
TEST(SetupOfHumanoid, LeavesTheKneeOut) {
  const SetupResult result = set_up_text(urdf_of("humanoid_ankle"));
  ASSERT_TRUE(result.mechanism) << listed(result.problems);
  const Problems notes = result.mechanism->notes();
  ASSERT_EQ(notes.size(), 1U) << listed(notes);
  EXPECT_TRUE(test::has(notes.front(), "'left_knee_joint'"));
}

// The limits of the chain are constraints of the pose.
TEST(SetupOfHumanoid, TakesTheLimitsOfThePassiveHinges) {
  const SetupResult result = set_up_text(urdf_of("humanoid_ankle"));
  ASSERT_TRUE(result.mechanism) << listed(result.problems);
  const auto& limits = result.mechanism->manipulator()->constraints().hinge_limits;
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_EQ(limits[0].limits.lower, -0.9);
  EXPECT_EQ(limits[0].limits.upper, 0.6);
  EXPECT_EQ(limits[1].limits.lower, -0.35);
  EXPECT_EQ(limits[1].limits.upper, 0.35);
}

// Angles have no lengths among them.
TEST(SetupOfExported, WritesTheUnitsOfThePose) {
  const std::string config = set_up_text(urdf_of("exported_ankle")).config;
  EXPECT_TRUE(test::has(config, "Coordinates: theta1, theta2 [rad]."));
}

}  // namespace
}  // namespace parallel_aspects
