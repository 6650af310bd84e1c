// SPDX-License-Identifier: BSD-3-Clause
// Loops that a URDF closes where its links are while all joints are zero. Each remedy is followed to the
// letter, and what it makes is compared with the robot that is meant.
#include "urdf/corrections/said_of_robots.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/texts.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Description;
using test::exchanged;
using test::matched;
using test::only_warning;
using test::replaced;
using test::sentence;
using test::warnings;

const std::map<std::string, std::string>& configs() {
  static const std::map<std::string, std::string> texts{
      {"five_bar", "operational_point: tool, actuated_joints: [motor_left, motor_right]"},
      {"delta", "operational_point: platform, actuated_joints: [motor_1, motor_2, motor_3]"},
      {"low_delta", "operational_point: platform, actuated_joints: [motor_1, motor_2, motor_3]"},
      {"three_rrr", "operational_point: center, actuated_joints: [motor_1, motor_2, motor_3]"},
      {"hexapod",
       "operational_point: platform, actuated_joints: [piston_1, piston_2, piston_3, piston_4, piston_5, "
       "piston_6]"}};
  return texts;
}

Description robot(const std::string& name) {
  return {test::source_file("test/data/at_zero/" + name + ".urdf"),
          "mechanism: {base_link: base, " + configs().at(name) + "}\n"};
}

Description with_closures(Description text, const std::string& entry) {
  text.change_config("}\n", ", " + entry + "}\n");
  return text;
}

using test::refusal;

// Whether the legs are the same, wherever the actuated joints have their zero.
bool are_same(const Manipulator& one, const Manipulator& other) {
  constexpr double rounding = 1e-6;
  if (one.task_space() != other.task_space()) return false;
  for (std::size_t k = 0; k < one.legs().size(); ++k) {
    const Leg &a = one.leg(k), &b = other.leg(k);
    if ((a.anchor - b.anchor).norm() > rounding || std::abs(a.rod_length - b.rod_length) > rounding ||
        (a.proximal_point(0.0) - b.proximal_point(0.0)).norm() > rounding ||
        std::abs(a.squared_distance(0.0) - b.squared_distance(0.0)) > rounding)
      return false;
  }
  return true;
}

bool is_robot(const Description& text, const std::string& name) {
  return refusal(text).empty() &&
         are_same(*test::load(text)->manipulator(), *test::load(robot(name))->manipulator());
}

TEST(ClosureAtZero, IsAsItIsDrawn) {
  for (const std::string name : {"five_bar", "delta", "three_rrr", "hexapod"})
    EXPECT_EQ(warnings(robot(name)), std::vector<std::string>{}) << name;
}

TEST(ClosureAtZero, JoinsAllEndsThatItDrawsApartAndSaysTheListThatHoldsThem) {
  const std::string said = only_warning(robot("low_delta"));
  EXPECT_TRUE(test::begins(said,
                           "robot.urdf has ends of closures apart while all joints are zero, 'rod_end_1' and "
                           "'ball_1' by 0.05 m (closure 'closure_1')"));
  EXPECT_TRUE(test::has(said, "with legs of 0.438193, 0.438193, 0.438193 m"));
  EXPECT_TRUE(test::has(said, "with legs of 0.4, 0.4, 0.4 m"));
  for (const Leg& leg : test::load(robot("low_delta"))->manipulator()->legs())
    EXPECT_NEAR(leg.rod_length, 0.4, 1e-9);
  const Description apart = with_closures(
      robot("low_delta"), matched(said, "write (closures: \\[.*\\}\\]) under mechanism in robot.yaml"));
  EXPECT_EQ(warnings(apart), std::vector<std::string>{});
  for (const Leg& leg : test::load(apart)->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, 0.438193, 1e-5);
}

// An angle that is wrong, and happens to load.
TEST(ClosureAtZero, JoinsTheToolOfAFiveBarToItsRod) {
  Description five_bar = robot("five_bar");
  five_bar.change_urdf("rpy=\"0 0 2.1\"", "rpy=\"0 0 1.9\"");
  five_bar.change_config("point: tool", "point: tip");
  EXPECT_TRUE(test::has(only_warning(five_bar), "they are taken to meet"));
  for (const Leg& leg : test::load(five_bar)->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, 0.12, 1e-9);
}

// Two coordinates are wrong at once, which is no correction that is tried.
TEST(ClosureAtZero, SaysWhichEndsAreApartWhereNoCorrectionIsFound) {
  Description delta = robot("delta");
  delta.change_urdf("xyz=\"-0.07 0.1212435565 0\"", "xyz=\"0.01 -0.4 0.3\"");
  const Problems problems = refusal(delta);
  const std::string said = problems.empty() ? warnings(delta).front() : problems.back();
  EXPECT_TRUE(test::has(said, "'rod_end_2' and 'ball_2' by "));
  EXPECT_TRUE(test::has(said, " m (closure 'closure_2'), and "));
  EXPECT_TRUE(test::has(said, "correct the origins of the joints in their loops"));
}

// What tells so is the place of the ends, or the numbers in their names.
TEST(ClosureAtZero, IsNotedWhereItsEndsAreCrossed) {
  for (const std::string name : {"delta", "low_delta"}) {
    Description crossed = robot(name);
    crossed.urdf = exchanged(crossed.urdf, "<child>ball_2</child>", "<child>ball_3</child>");
    const std::string said = only_warning(crossed);
    EXPECT_TRUE(test::begins(
        said, "It seems that robot.urdf has the ends of closure 'closure_2', closure 'closure_3' crossed"));
    EXPECT_TRUE(
        test::has(said,
                  "; if so, write link 'ball_2' in the place of 'ball_3' in closure 'closure_2' and write "
                  "link 'ball_3' in the place of 'ball_2' in closure 'closure_3', or write closures: ["));
  }
}

TEST(ClosureAtZero, IsNotedWhereNamesOfClosingFramesAreCrossed) {
  Description crossed = robot("three_rrr");
  crossed.urdf = exchanged(crossed.urdf, "<child link=\"closing_2_2\"/>", "<child link=\"closing_3_2\"/>");
  const std::string said = only_warning(crossed);
  EXPECT_TRUE(
      test::has(said, "; if so, exchange the names of links 'closing_2_2' and 'closing_3_2', or write "));
}

TEST(ClosureAtZero, IsNotedInAListWhereNumbersOfNamesAreCrossed) {
  Description delta = test::shipped_text("three_rpr");
  delta.config = exchanged(delta.config, "bar_2_tip", "bar_3_tip");
  const auto loaded = test::refusal(delta).empty() ? warnings(delta) : std::vector<std::string>{};
  for (const std::string& note : loaded) EXPECT_TRUE(test::has(note, "bar_2_tip"));
}

TEST(ClosureAtZero, NamesTheJointThatALegLacks) {
  Description lacking = robot("hexapod");
  lacking.urdf =
      std::regex_replace(lacking.urdf, std::regex("  <joint name=\"second_3\"[\\s\\S]*?</joint>\n"), "",
                         std::regex_constants::format_first_only);
  lacking.change_urdf("  <link name=\"cylinder_3\"/>\n", "");
  lacking.change_urdf("<parent link=\"cylinder_3\"/>", "<parent link=\"yoke_3\"/>");
  const std::string said = sentence(lacking);
  EXPECT_TRUE(test::has(said, "has one joint less in the leg of joint 'piston_3' than in others"));
  const std::vector<Description> corrected = test::followed(lacking, said);
  ASSERT_EQ(corrected.size(), 1U) << said;
  EXPECT_TRUE(is_robot(corrected.front(), "hexapod")) << said;
}

TEST(ClosureAtZero, HasItsTypeInTheWordsOfTheUrdf) {
  Description hexapod = robot("hexapod");
  hexapod.change_urdf("name=\"ball_3\" type=\"ball\"", "name=\"ball_3\" type=\"revolute\"");
  const std::string said = sentence(hexapod);
  EXPECT_TRUE(test::has(said, "write type=\"ball\" for closure 'ball_3', which makes it a robot in SE3."));
}

TEST(ClosureAtZero, IsAddedWhereOneIsMissing) {
  Description delta = robot("delta");
  delta.urdf = std::regex_replace(delta.urdf, std::regex("<joint name=\"closure_2\"[\\s\\S]*?</joint>"), "");
  const std::string said = sentence(delta);
  const std::string entry = matched(said, "add (\\{frames: .*\\}) to mechanism.added_closures");
  ASSERT_FALSE(entry.empty()) << said;
  EXPECT_TRUE(is_robot(with_closures(delta, "added_closures: [" + entry + "]"), "delta")) << said;
}

TEST(ClosureAtZero, IsNotListedAndAddedTo) {
  const std::string one = "{frames: [rod_end_1, ball_1], type: point}";
  const std::string said =
      sentence(with_closures(robot("delta"), "closures: [" + one + "], added_closures: [" + one + "]"));
  EXPECT_TRUE(test::has(said, "has mechanism.closures and mechanism.added_closures"));
}

std::string without_joint(const std::string& urdf, const std::string& name, const std::string& link) {
  return replaced(
      std::regex_replace(urdf, std::regex("  <joint name=\"" + name + "\"[\\s\\S]*?</joint>\n"), ""),
      "  <link name=\"" + link + "\"/>\n", "");
}

TEST(ClosureAtZero, MayBeWhereTheJointOfItsRodIs) {
  Description five_bar = robot("five_bar");
  five_bar.urdf = without_joint(five_bar.urdf, "tip_right", "tip");
  five_bar.change_urdf("<child>tip</child>", "<child>rod_right</child>");
  const std::string said = sentence(five_bar);
  EXPECT_TRUE(test::has(said,
                        "; closure 'loop' holds link 'rod_right' where joint 'elbow_right' is: give its far "
                        "end, if that is meant, by {link: rod_right, xyz: [X, Y, Z]}"));
  five_bar.change_urdf("<child>rod_right</child>", "<child>rod_right</child><pose>0.12 0 0 0 0 0</pose>");
  const auto loaded = test::load(five_bar);
  for (const Leg& leg : loaded->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, 0.12, 1e-6) << said;
}

// No rod has its far end.
TEST(ClosureAtZero, IsSaidToBeWhereTheJointOfItsRodIs) {
  Description five_bar = robot("five_bar");
  five_bar.urdf = without_joint(without_joint(five_bar.urdf, "tip_right", "tip"), "tip_left", "tool");
  five_bar.change_urdf("<parent>tool</parent>\n      <child>tip</child>",
                       "<parent>rod_left</parent>\n      <child>rod_right</child>");
  five_bar.change_config("point: tool", "point: rod_left");
  const Problems problems = refusal(five_bar);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(
      problems.back(),
      "robot.urdf has joint 'elbow_right' where closure 'loop' holds link 'rod_right', at its origin, so "
      "that the rod between them has length zero; give the far end of the rod: write {link: rod_right, xyz: "
      "[X, Y, Z]} in the place of rod_right in it, or the <pose> of a <gazebo><joint>.");
}

TEST(ClosureAtZero, MayHoldAPlatformWhereAnotherLegIs) {
  Description rrr = robot("three_rrr");
  rrr.change_config("}\n",
                    ", closures: [{frames: [closing_2_1, plate], type: revolute}, {frames: [closing_3_1, "
                    "closing_3_2], type: revolute}]}\n");
  const std::string said = only_warning(rrr);
  EXPECT_TRUE(
      test::has(said, "write link 'closing_2_2' in the place of 'plate' in closure 'closing_2_1 - plate'"));
  rrr.change_config("[closing_2_1, plate]", "[closing_2_1, closing_2_2]");
  EXPECT_EQ(warnings(rrr), std::vector<std::string>{});
}

TEST(ClosureAtZero, MayBeTurnedByDegrees) {
  const std::string closures =
      "closures: [{frames: [tool, {link: rod_right, xyz: [0.12, 0, 0.005], rpy: [0, 0, 90]}], type: "
      "revolute}]";
  const std::string said = only_warning(with_closures(robot("five_bar"), closures));
  EXPECT_TRUE(test::has(said, "turns the frame in link 'rod_right'"));
  const std::string rpy = matched(said, "write (rpy: \\[[^\\]]*\\])");
  EXPECT_EQ(warnings(with_closures(robot("five_bar"), replaced(closures, "rpy: [0, 0, 90]", rpy))),
            std::vector<std::string>{});
}

// One joint of the URDF changed, of those whose text stands once.
struct Fault {
  std::string kind, joint;
  Description text;
};

std::vector<Fault> faults_of(const std::string& name) {
  std::vector<Fault> faults;
  const Description good = robot(name);
  const std::regex joint("<joint name=\"([^\"]+)\" type=\"\\w+\">\\s*<parent[\\s\\S]*?</joint>");
  const auto add = [&](const std::string& kind, const std::smatch& found, const std::string& pattern,
                       const std::string& changed) {
    const std::string text = found[0].str();
    const std::string other =
        std::regex_replace(text, std::regex(pattern), changed, std::regex_constants::format_first_only);
    if (other != text)
      faults.push_back({kind, found[1].str(), {replaced(good.urdf, text, other), good.config}});
  };
  const std::string n = "(-?[0-9.e-]+)";
  for (std::sregex_iterator at(good.urdf.begin(), good.urdf.end(), joint), end; at != end; ++at) {
    std::smatch place;
    const std::string text = (*at)[0].str();
    if (std::regex_search(text, place, std::regex("xyz=\"" + n + " " + n + " " + n + "\" rpy"))) {
      std::string millimetres;
      for (std::size_t k = 1; k < 4; ++k)
        millimetres += (k == 1 ? "" : " ") + std::to_string(1e3 * std::stod(place[k].str()));
      if (std::any_of(place.begin() + 1, place.end(), [](const auto& one) { return one != "0"; }))
        add("millimetres", *at, "xyz=\"[^\"]*\" rpy", "xyz=\"" + millimetres + "\" rpy");
    }
    add("sign x", *at, "xyz=\"([1-9.0][^ ]+) ([^\"]*)\" rpy", "xyz=\"-$1 $2\" rpy");
    add("sign x", *at, "xyz=\"-([^ ]+) ([^\"]*)\" rpy", "xyz=\"$1 $2\" rpy");
    add("axis", *at, "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 0 1\"/>");
    add("axis", *at, "<axis xyz=\"(1 0 0|0 0 1)\"/>", "<axis xyz=\"0 1 0\"/>");
    add("yaw", *at, "rpy=\"([^ ]+) ([^ ]+) ([1-9.0-][^\"]+)\"", "rpy=\"$1 $2 0\"");
  }
  return faults;
}

// What loads is the robot that is meant, or a note says that ends are apart; and every remedy makes it that
// robot, or one of several does.
class FaultAtZero : public ::testing::TestWithParam<std::string> {};

TEST_P(FaultAtZero, IsNotCorrectedIntoAnotherRobot) {
  std::map<std::string, int> counts;
  const std::vector<Fault> faults = faults_of(GetParam());
  for (std::size_t k = 0; k < faults.size(); k += test::is_sanitized ? 12 : 1) {
    const auto& [kind, joint, text] = faults[k];
    const Problems problems = refusal(text);
    if (problems.empty()) {
      ++counts[is_robot(text, GetParam()) ? "same" : warnings(text).empty() ? "loads" : "noted"];
      continue;
    }
    std::string said;
    for (const std::string& problem : problems) said += problem;
    if (said.find("makes it a robot") == std::string::npos &&
        said.find("would make it one") == std::string::npos &&
        said.find("closures: [") == std::string::npos) {
      ++counts["not found"];
      continue;
    }
    if (const std::string closures = matched(said, "write (closures: \\[.*\\}\\]) under mechanism in");
        !closures.empty()) {
      EXPECT_TRUE(refusal(with_closures(text, closures)).empty()) << kind << " of " << joint << ": " << said;
      if (std::getenv("CORRECTIONS_VERBOSE") != nullptr)
        std::cout << kind << " of " << joint << ": " << said << '\n';
      ++counts["as a list"];
      continue;
    }
    const std::vector<Description> corrected = test::followed(text, said);
    const bool is_meant = std::any_of(corrected.begin(), corrected.end(),
                                      [](const Description& one) { return is_robot(one, GetParam()); });
    ++counts[is_meant ? "corrected" : "wrong"];
    EXPECT_TRUE(is_meant) << kind << " of " << joint << ": " << said;
  }
  for (const auto& [outcome, count] : counts)
    std::cout << GetParam() << ' ' << outcome << ' ' << count << '\n';
}

INSTANTIATE_TEST_SUITE_P(Robots, FaultAtZero,
                         ::testing::Values("five_bar", "delta", "low_delta", "three_rrr", "hexapod"));

}  // namespace
}  // namespace parallel_aspects
