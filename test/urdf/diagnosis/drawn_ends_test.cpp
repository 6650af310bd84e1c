// SPDX-License-Identifier: BSD-3-Clause
// Robots that load otherwise than they are meant: each is told in a note, whose remedy is followed to the
// letter.
#include "urdf/corrections/said_of_robots.h"
#include "urdf/diagnosis/placed_closures.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/texts.h"
#include <array>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::are_same;
using test::Description;
using test::exchanged;
using test::matched;
using test::only_warning;
using test::replaced;
using test::warnings;

// The closures of the YAML are one to a line.
Description with_list(Description text, const std::string& entry) {
  text.config =
      std::regex_replace(text.config, std::regex("\n  closures:\n(    - .*\n)+"), "\n  " + entry + "\n");
  return text;
}

std::string renamed(const std::string& text) {
  return std::regex_replace(std::regex_replace(text, std::regex("(bar|rod|platform)_2"), "$1_B"),
                            std::regex("(bar|rod|platform)_3"), "$1_C");
}

TEST(CrossedEnds, AreReportedByNamesWhereThereAreThreeLegs) {
  for (const bool by_letters : {false, true})
    for (const std::string robot : {"three_rrr", "three_rpr"}) {
      Description good = test::shipped_text(robot);
      if (by_letters) good = {renamed(good.urdf), renamed(good.config)};
      EXPECT_EQ(warnings(good), std::vector<std::string>{}) << robot;
      Description crossed = good;
      const std::string second = by_letters ? "[platform_B," : "[platform_2,",
                        third = by_letters ? "[platform_C," : "[platform_3,";
      crossed.config = exchanged(crossed.config, second, third);
      const std::string said = only_warning(crossed);
      EXPECT_TRUE(test::begins(said, "It seems that robot.yaml has the ends of closure 'platform_"));
      EXPECT_TRUE(test::has(said, " crossed, as their names say; if so, write link 'platform_"));
      const Description listed =
          with_list(crossed, matched(said, "or write (closures: \\[.*\\}\\]) under mechanism in robot.yaml"));
      EXPECT_TRUE(are_same(listed, good)) << said;
      EXPECT_EQ(warnings(listed), std::vector<std::string>{}) << robot;
    }
}

TEST(CrossedEnds, AreTheCauseWhereThatMakesNoRobot) {
  const Description good = test::shipped_text("three_prr");
  Description crossed = good;
  crossed.config = exchanged(crossed.config, "[platform_2,", "[platform_3,");
  const Problems problems = test::refusal(crossed);
  ASSERT_EQ(problems.size(), 1U);
  const std::vector<Description> corrected = test::followed(crossed, problems.front());
  ASSERT_EQ(corrected.size(), 1U) << problems.front();
  EXPECT_TRUE(are_same(corrected.front(), good)) << problems.front();
}

// Links are numbered by a program, as CAD does.
TEST(CrossedEnds, AreReportedByNamesOfJoints) {
  Description crossed = test::shipped_text("three_rpr");
  for (auto* text : {&crossed.urdf, &crossed.config})
    for (const auto& [name, other] : {std::pair{"bar_2_tip", "part_18"}, std::pair{"bar_3_tip", "part_24"},
                                      std::pair{"bar_2", "part_17"}, std::pair{"bar_3", "part_23"}})
      *text = std::regex_replace(*text, std::regex("\"" + std::string(name) + "\"|\\b" + name + "(?=\\])"),
                                 text == &crossed.urdf ? "\"" + std::string(other) + "\"" : other);
  crossed.config = std::regex_replace(crossed.config, std::regex("bar_2_tip"), "part_18");
  crossed.config = std::regex_replace(crossed.config, std::regex("bar_3_tip"), "part_24");
  EXPECT_EQ(warnings(crossed), std::vector<std::string>{});
  crossed.config = exchanged(crossed.config, "[platform_2,", "[platform_3,");
  EXPECT_TRUE(test::has(only_warning(crossed), "as their names say"));
}

// The same three loops in four dialects, drawn 50 mm apart.
std::string in_dialect(const std::string& urdf, const std::string& with) {
  return std::regex_replace(
      urdf,
      std::regex(
          "<gazebo>\\s*<joint name=\"(\\w+)\" "
          "type=\"ball\">\\s*<parent>(\\w+)</parent>\\s*<child>(\\w+)</child>\\s*</joint>\\s*</gazebo>"),
      with);
}

Description low_delta() {
  return {test::source_file("test/data/at_zero/low_delta.urdf"),
          "mechanism: {base_link: base, operational_point: platform, actuated_joints: [motor_1, motor_2, "
          "motor_3]}\n"};
}

TEST(DrawnOpen, IsOneRobotInAllDialects) {
  const Description by_joints = low_delta();
  const std::vector<std::string> others{
      "<loop_joint name=\"$1\" type=\"spherical\"><link1 link=\"$2\"/><link2 link=\"$3\"/></loop_joint>",
      "<gazebo><plugin name=\"gz::sim::systems::DetachableJoint\" "
      "filename=\"gz-sim-detachable-joint-system\"><parent_link>$2</parent_link><child_model>low_delta</"
      "child_model><child_link>$3</child_link></plugin></gazebo>",
      "<gazebo><joint name=\"$1\" type=\"fixed\"><parent>$2</parent><child>$3</child></joint></gazebo>"};
  for (const Leg& leg : test::load(by_joints)->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, 0.4, 1e-6);
  for (const std::string& dialect : others) {
    Description other = by_joints;
    other.urdf = in_dialect(other.urdf, dialect);
    ASSERT_NE(other.urdf, by_joints.urdf);
    EXPECT_TRUE(are_same(other, by_joints)) << dialect;
  }
}

TEST(DrawnOpen, SaysWhatHoldsItApart) {
  const std::string said = only_warning(low_delta());
  EXPECT_TRUE(test::has(said,
                        "they are taken to meet, with legs of 0.4, 0.4, 0.4 m; if they are held so, as by "
                        "simulators, write closures: ["));
  Description apart = low_delta();
  apart.change_config(
      "}\n", ", " + matched(said, "write (closures: \\[.*\\}\\]) under mechanism in robot.yaml") + "}\n");
  for (const Leg& leg : test::load(apart)->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, 0.438193, 1e-5);
}

// Two of three loops are closed while all joints are zero.
TEST(MisplacedEnd, IsReportedWithTheOriginThatPutsItThere) {
  Description good{test::source_file("test/data/at_zero/delta.urdf"), low_delta().config};
  good.urdf = in_dialect(
      good.urdf,
      "<loop_joint name=\"$1\" type=\"spherical\"><link1 link=\"$2\"/><link2 link=\"$3\"/></loop_joint>");
  EXPECT_EQ(warnings(good), std::vector<std::string>{});
  Description wrong = good;
  wrong.change_urdf("xyz=\"-0.025 -0.04330127019 0\"", "xyz=\"-0.025 -0.04330127019 0.03\"");
  EXPECT_TRUE(test::has(only_warning(wrong), "'rod_end_3' and 'ball_3' by 0.03 m (closure 'closure_3')"));
  wrong.urdf = replaced(good.urdf, "xyz=\"-0.025 -0.04330127019 0\"", "xyz=\"0.025 -0.04330127019 0\"");
  const std::string said = only_warning(wrong);
  bool any = false;
  for (const std::string& remedy : test::remedies(said))
    any = any || are_same(test::corrected(wrong, remedy), good);
  EXPECT_TRUE(any) << said;
}

TEST(ReversedAxis, IsReportedWhereLimitsAreNotTheSameToBothSides) {
  Description delta{test::source_file("test/data/at_zero/delta.urdf"), low_delta().config};
  const std::string motor = "rpy=\"0 0 2.094395102\"/>\n    <axis xyz=\"0 1 0\"/>";
  delta.change_urdf(motor, replaced(motor, "0 1 0", "0 -1 0"));
  const std::string said = only_warning(delta);
  EXPECT_TRUE(test::has(said, "lets actuated joint 'motor_2' move the other way round"));
  ASSERT_EQ(test::remedies(said).size(), 1U) << said;
  EXPECT_EQ(warnings(test::corrected(delta, test::remedies(said).front())), std::vector<std::string>{});
}

TEST(Angle, BeyondAFullTurnIsOneInDegrees) {
  for (const std::string degrees : {"37.5", "-51.57", "338.434"}) {
    Description five_bar = test::shipped_text("five_bar");
    const std::string motor = "<joint name=\"crank_2_joint\" type=\"continuous\">";
    const std::size_t origin = five_bar.urdf.find("<origin xyz=", five_bar.urdf.find(motor));
    const std::size_t end = five_bar.urdf.find("/>", origin);
    five_bar.urdf.replace(end, 0, " rpy=\"0 0 " + degrees + "\"");
    EXPECT_TRUE(test::has(only_warning(five_bar), "by rpy (0, 0, " + degrees + ") rad, as if in degrees"))
        << degrees;
  }
}

// Ends that are places beside links, in all dialects that have them.
class PlacedEnds : public ::testing::TestWithParam<std::string> {
 protected:
  Description with(const test::PlacedClosures& closures) const {
    return test::placed_delta(GetParam(), closures);
  }
  Description good() const { return with(test::closures_of_delta()); }
};

TEST_P(PlacedEnds, HaveNoNoteWhereTheyAreRight) {
  EXPECT_EQ(warnings(good()), std::vector<std::string>{});
  const Description by_links{test::source_file("test/data/at_zero/delta.urdf"), low_delta().config};
  EXPECT_TRUE(are_same(good(), by_links));
}

TEST_P(PlacedEnds, AreNotedWhereTheyAreCrossed) {
  test::PlacedClosures crossed = test::closures_of_delta();
  std::swap(crossed[1].places[1], crossed[2].places[1]);
  const std::string said = only_warning(with(crossed));
  EXPECT_TRUE(test::has(said,
                        "has the ends of closure 'rod_2 - platform', closure 'rod_3 - platform' crossed, "
                        "since these are 0.0866 m and 0.0866 m apart while all joints are zero"));
  EXPECT_TRUE(are_same(with(test::followed(crossed, said)), good())) << said;
  Description listed = test::placed_delta("list", crossed);
  listed.config = std::regex_replace(
      listed.config, std::regex("closures: \\[.*\\]\\}"),
      matched(said, "or write (closures: \\[.*\\}\\]) under mechanism in robot.yaml") + "}");
  EXPECT_TRUE(are_same(listed, good())) << said;
}

TEST_P(PlacedEnds, AreNotedWhereOneIsMisplaced) {
  for (const std::string place : {"0.025 0.04330127019 0", "0.04330127019 -0.025 0"}) {
    test::PlacedClosures wrong = test::closures_of_delta();
    wrong[1].places[1] = place;
    const std::string said = only_warning(with(wrong));
    EXPECT_TRUE(test::has(said, "(closure 'rod_2 - platform'), where those of others meet"));
    EXPECT_TRUE(are_same(with(test::followed(wrong, said)), good())) << said;
  }
}

TEST_P(PlacedEnds, AreInMetres) {
  for (const std::size_t count : {1, 3}) {
    test::PlacedClosures wrong = test::closures_of_delta();
    for (std::size_t k = 0; k < count; ++k)
      wrong[k].places[1] = std::array{"50 0 0", "-25 43.30127019 0", "-25 -43.30127019 0"}.at(k);
    const Problems problems = test::refusal(with(wrong).urdf, with(wrong).config);
    const std::string said = problems.empty() ? only_warning(with(wrong)) : problems.front();
    EXPECT_TRUE(test::has(said, "at (50, 0, 0) m"));
    EXPECT_TRUE(test::has(said, ", as if in millimetres; "));
    EXPECT_TRUE(are_same(with(test::followed(wrong, said)), good())) << said;
  }
}

// One place of one closure, each wrong as people make it: what loads is the robot that is meant or noted, and
// what is named makes it that robot, or one of several corrections does.
TEST_P(PlacedEnds, WrongOnesAreNotCorrectedIntoAnotherRobot) {
  const test::PlacedClosures all = test::closures_of_delta();
  std::map<std::string, int> counts;
  for (std::size_t k = 0; k < all.size(); ++k)
    for (const std::size_t end : {0, 1})
      for (const std::string& place : test::wrong_places(all[k].places.at(end))) {
        test::PlacedClosures wrong = all;
        wrong[k].places.at(end) = place;
        const Description text = with(wrong);
        const Problems problems = test::refusal(text);
        const std::vector<std::string> said = problems.empty() ? warnings(text) : problems;
        if (said.empty()) {
          EXPECT_TRUE(are_same(text, good())) << place;
          continue;
        }
        ++counts[problems.empty() ? "noted" : "refused"];
        if (said.front().find("m away from its link") != std::string::npos) continue;
        bool any = false;
        for (const test::PlacedClosures& corrected : test::followed_apart(wrong, said.front()))
          any = any || are_same(with(corrected), good());
        EXPECT_TRUE(any) << place << ": " << testing::PrintToString(said);
      }
  for (const auto& [outcome, count] : counts)
    std::cout << GetParam() << ' ' << outcome << ' ' << count << '\n';
}

INSTANTIATE_TEST_SUITE_P(Dialects, PlacedEnds, ::testing::ValuesIn(test::placed_dialects()));

Description five_bar_with_pose(const std::string& pose) {
  const std::string urdf =
      replaced(test::source_file("test/data/at_zero/five_bar.urdf"), "<child>tip</child>",
               "<child>rod_right</child><pose>" + pose + " 0 0 0</pose>");
  return {
      urdf,
      "mechanism: {base_link: base, operational_point: tool, actuated_joints: [motor_left, motor_right]}\n"};
}

TEST(PlaceAtZero, IsTheCauseWhereItIsBesideTheEndThatItHolds) {
  const Description good = five_bar_with_pose("0.12 0 0.005");
  EXPECT_EQ(warnings(good), std::vector<std::string>{});
  const std::string said = test::sentence(five_bar_with_pose("0.14 0 0.005"));
  EXPECT_TRUE(test::begins(said,
                           "robot.urdf has closure 'loop' 0.02 m beside the origin of link 'tool' while all "
                           "joints are zero; write <pose> starting with 0.12"));
  const std::string place =
      matched(said, "write <pose> starting with (.*) in link 'rod_right' of closure 'loop'");
  EXPECT_TRUE(are_same(five_bar_with_pose(place), good)) << said;
}

Description delta_with_pose(const std::string& pose) {
  return {replaced(test::source_file("test/data/at_zero/delta.urdf"), "<child>ball_2</child>",
                   "<child>platform</child><pose>" + pose + " 0 0 0</pose>"),
          low_delta().config};
}

// A simulator would hold the rod beside the joint.
TEST(PlaceAtZero, IsNotedWhereARobotLoadsWithIt) {
  const Description good = delta_with_pose("-0.025 0.04330127019 0");
  EXPECT_EQ(warnings(good), std::vector<std::string>{});
  const std::string said = only_warning(delta_with_pose("0.025 0.04330127019 0"));
  EXPECT_TRUE(test::has(said,
                        "has closure 'closure_2' 0.05 m beside the origin of link 'rod_end_2' while all "
                        "joints are zero; if it is to be there, write <pose> starting with -0.025"));
  const std::string place =
      matched(said, "write <pose> starting with (.*) in link 'platform' of closure 'closure_2'");
  EXPECT_TRUE(are_same(delta_with_pose(place), good)) << said;
}

TEST(Closures, ThatAUrdfHasTwiceAreSaidOfIt) {
  Description delta{test::source_file("test/data/at_zero/delta.urdf"), low_delta().config};
  const std::string again =
      "<gazebo><joint name=\"closure_2\" "
      "type=\"ball\"><parent>rod_end_2</parent><child>ball_2</child></joint></gazebo>";
  delta.change_urdf("</robot>", again + "</robot>");
  EXPECT_TRUE(test::has_note(
      delta, "robot.urdf lists closure 'closure_2' twice, which counts once; leave out one entry."));
  delta.change_urdf("</robot>", again + "</robot>");
  EXPECT_TRUE(test::has_note(delta,
                             "robot.urdf lists closure 'closure_2' more than once, which counts once; leave "
                             "out all entries but one."));
}

// A joint value more or less at zero makes the drawing another one, and not the robot.
TEST(Wrist, IsOneRobotHoweverOpenItIsDrawn) {
  Description wrist{test::source_file("test/data/setup/wrist.urdf"),
                    "mechanism:\n  operational_point: dome\n  actuated_joints: [m0, m1, m2]\n  closures:\n"
                    "    - {frames: [dome1, dist1_end], type: revolute}\n"
                    "    - {frames: [dome2, dist2_end], type: revolute}\n"};
  const std::string joint =
      "<joint name=\"w1\" type=\"continuous\"><parent link=\"prox1\"/><child link=\"dist1\"/><origin xyz=\"0 "
      "0 0\"";
  for (const std::string angle : {"0.4", "0.9", "1.5", "2.1", "2.7", "3.1", "-0.8", "-1.6", "-2.4"}) {
    Description open = wrist;
    open.change_urdf(joint, joint + " rpy=\"0 " + angle + " 0\"");
    EXPECT_TRUE(are_same(open, wrist)) << angle;
  }
}

// All frames are in one point but for what CAD leaves.
TEST(Wrist, MayHaveFramesThatAreRounded) {
  const std::string config =
      "mechanism:\n  operational_point: dome\n  actuated_joints: [m0, m1, m2]\n  closures:\n"
      "    - {frames: [dome1, dist1_end], type: revolute}\n"
      "    - {frames: [dome2, dist2_end], type: revolute}\n";
  const Description wrist{test::source_file("test/data/setup/wrist.urdf"), config};
  Description rounded = wrist;
  rounded.urdf = std::regex_replace(rounded.urdf, std::regex("xyz=\"0 0 0\""), "xyz=\"1.2e-7 -3e-8 2e-7\"");
  EXPECT_NE(rounded.urdf, wrist.urdf);
  EXPECT_TRUE(are_same(rounded, wrist));
}

TEST_P(PlacedEnds, AreNotedWhereOneOriginPutsAllOfThemTogether) {
  Description wrong = good();
  wrong.change_urdf("xyz=\"0 0 -0.2951270913\"", "xyz=\"0 0 0.2951270913\"");
  const Problems problems = test::refusal(wrong);
  const std::string said = problems.empty() ? only_warning(wrong) : problems.front();
  EXPECT_TRUE(!problems.empty() ||
              said.find(", all of which one origin puts together; ") != std::string::npos)
      << said;
  bool any = false;
  for (const std::string& remedy : test::remedies(said))
    any = any || are_same(test::corrected(wrong, remedy), good());
  EXPECT_TRUE(any) << said;
}

// Another direction than those of the other legs, by which the robot loads as another one.
TEST(OtherAxis, IsReportedOfAnActuatedJoint) {
  for (const std::string axis : {"1 0 0", "0.6 0 0.8", "0 1 0"}) {
    const Description good = test::shipped_text("linear_delta");
    Description wrong = good;
    const std::string joint = "<joint name=\"slider_2_joint\"";
    const std::size_t at = wrong.urdf.find("<axis xyz=\"", wrong.urdf.find(joint)) + 11;
    wrong.urdf.replace(at, wrong.urdf.find('"', at) - at, axis);
    const std::string said = only_warning(wrong);
    EXPECT_TRUE(test::has(said, "lets actuated joint 'slider_2_joint' move along another axis, "));
    ASSERT_EQ(test::remedies(said).size(), 1U) << said;
    const Description right = test::corrected(wrong, test::remedies(said).front());
    EXPECT_EQ(warnings(right), std::vector<std::string>{});
    EXPECT_TRUE(are_same(right, good)) << said;
  }
}

}  // namespace
}  // namespace parallel_aspects
