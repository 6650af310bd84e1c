// SPDX-License-Identifier: BSD-3-Clause
// What a user says of loops beside what the URDF says, and where it says too little to try anything.
#include "urdf/setup/setup.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/texts.h"
#include <chrono>
#include <regex>
#include <string>

namespace parallel_aspects {
namespace {

using test::source_file;

SetupControl unhurried() { return {1000000}; }

SetupResult set_up_at_zero(const std::string& urdf, const SetupAnswers& answers,
                           const SetupControl& control = unhurried()) {
  return set_up(urdf, "robot.urdf", "robot.yaml", answers, control);
}

std::string at_zero(const std::string& robot) { return source_file("test/data/at_zero/" + robot + ".urdf"); }

std::string delta_without_a_closure() {
  return std::regex_replace(at_zero("delta"), std::regex("<joint name=\"closure_2\"[\\s\\S]*?</joint>"), "");
}

SetupAnswers closures(const std::vector<std::array<std::string, 2>>& pairs) {
  SetupAnswers answers;
  answers.closures = pairs;
  return answers;
}

TEST(AddedClosures, AreWrittenBesideThoseOfTheUrdf) {
  const std::string urdf = delta_without_a_closure();
  const SetupResult open = set_up_at_zero(urdf, {});
  ASSERT_EQ(open.problems.size(), 1U);
  EXPECT_TRUE(
      test::has(open.problems.front(), "; add --closures ball_2=rod_end_2, which makes it a robot in T3."));
  const SetupResult closed = set_up_at_zero(urdf, closures({{"ball_2", "rod_end_2"}}));
  ASSERT_TRUE(closed.mechanism) << (closed.problems.empty() ? "" : closed.problems.front());
  EXPECT_TRUE(test::has(closed.config, "  added_closures:\n    - {frames: [ball_2, rod_end_2], type: "));
  for (const Leg& leg : closed.mechanism->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, 0.4, 1e-6);
}

TEST(AddedClosures, TakeThePlaceOfAllThatCloseTheSame) {
  const SetupResult all =
      set_up_at_zero(at_zero("low_delta"),
                     closures({{"ball_1", "rod_end_1"}, {"ball_2", "rod_end_2"}, {"ball_3", "rod_end_3"}}));
  ASSERT_TRUE(all.mechanism);
  EXPECT_TRUE(test::has(all.config, "  closures:\n"));
  for (const Leg& leg : all.mechanism->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, 0.4, 1e-6);
  const SetupResult some = set_up_at_zero(at_zero("low_delta"), closures({{"ball_1", "rod_end_1"}}));
  EXPECT_EQ(some.problems, Problems{"--closures has some of the loops that robot.urdf closes itself, and not "
                                    "all; write all loops, or only those that it leaves open."});
}

TEST(AddedClosures, AreAskedForWithPlacesWhereFiveLegsEndAtOneLink) {
  const SetupResult asked = set_up_at_zero(at_zero("open_hexapod"), {});
  ASSERT_TRUE(asked.question);
  EXPECT_TRUE(asked.question->candidates.empty());
  EXPECT_TRUE(
      test::has(asked.question->text, "5 chains end at link 'platform', which has no frames for them"));
  ASSERT_EQ(asked.question->example.size(), 5U);
  EXPECT_EQ(asked.question->example.front(), "platform@X:Y:Z=rod_2");
  const std::array<std::string, 5> places{"0.191511111:0.160696902:0", "0.043412044:0.246201938:0",
                                          "-0.234923155:0.085505036:0", "-0.234923155:-0.085505036:0",
                                          "0.043412044:-0.246201938:0"};
  SetupAnswers answers;
  for (std::size_t k = 0; k < places.size(); ++k)
    answers.closures.push_back({"platform@" + places[k], "rod_" + std::to_string(k + 2)});
  const SetupResult found = set_up_at_zero(at_zero("open_hexapod"), answers);
  ASSERT_TRUE(found.mechanism) << (found.problems.empty() ? "" : found.problems.front());
  for (const Leg& leg : found.mechanism->manipulator()->legs())
    EXPECT_NEAR(std::sqrt(leg.squared_distance(0.0)), 0.533443, 1e-5);
}

TEST(Setup, EndsByTheClockOnTheWall) {
  SetupControl control = unhurried();
  control.latest = std::chrono::steady_clock::now();
  const SetupResult late = set_up_at_zero(at_zero("hexapod"), {}, control);
  EXPECT_FALSE(late.mechanism);
  EXPECT_TRUE(late.cut_short);
}

}  // namespace
}  // namespace parallel_aspects
