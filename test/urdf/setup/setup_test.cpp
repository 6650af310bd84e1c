// SPDX-License-Identifier: BSD-3-Clause
// What is found in bare URDFs: the shipped robots, and robots as others write them.
#include "urdf/setup/setup_texts.h"

#include <gtest/gtest.h>

#include "support/loops.h"
#include "support/many_joints.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::actuated_joints;
using test::listed;
using test::set_up_text;
using test::Strings;
using test::urdf_of;
using test::with_closures;

class SetupOfShipped : public ::testing::TestWithParam<std::string> {};

TEST_P(SetupOfShipped, IsTheShippedRobot) {
  const std::string urdf = test::source_file("urdf/" + GetParam() + ".urdf");
  const SetupResult result = set_up_text(urdf);
  ASSERT_TRUE(result.mechanism) << listed(result.problems) << (result.question ? result.question->text : "");
  EXPECT_FALSE(result.cut_short);
  const auto loaded = load_mechanism(urdf, "robot.urdf", result.config, "robot.yaml");
  const auto shipped = test::shipped(GetParam());
  EXPECT_EQ(loaded->manipulator()->task_space(), shipped->manipulator()->task_space());
  EXPECT_EQ(loaded->platform_link(), shipped->platform_link());
  ASSERT_EQ(actuated_joints(*loaded), actuated_joints(*shipped));
  for (std::size_t k = 0; k < shipped->manipulator()->leg_count(); ++k) {
    const Leg &one = loaded->manipulator()->leg(k), &other = shipped->manipulator()->leg(k);
    EXPECT_TRUE(one.base_point().isApprox(other.base_point(), 1e-9) ||
                (one.base_point() - other.base_point()).norm() < 1e-9);
    EXPECT_LT((one.anchor - other.anchor).norm(), 1e-9) << k;
    EXPECT_NEAR(one.rod_length, other.rod_length, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(All, SetupOfShipped,
                         ::testing::Values("agile_eye", "ankle", "bipod", "delta", "five_bar", "hexa",
                                           "linear_delta", "six_pus", "skew_wrist", "spherical_3rrr",
                                           "stewart", "three_prr", "three_rpr", "three_rrr", "tilt_table"));

struct Found {
  std::string file;
  TaskSpace space;
  std::string base, platform;
  Strings joints;
};

void PrintTo(const Found& found, std::ostream* stream) { *stream << found.file; }

class SetupOfOthers : public ::testing::TestWithParam<Found> {};

TEST_P(SetupOfOthers, FindsTheRobot) {
  const Found& expected = GetParam();
  const std::string urdf = test::source_file("test/data/setup/" + expected.file + ".urdf");
  const SetupResult result = set_up_text(urdf);
  ASSERT_TRUE(result.mechanism) << listed(result.problems) << (result.question ? result.question->text : "");
  const auto loaded = load_mechanism(urdf, "robot.urdf", result.config, "robot.yaml");
  EXPECT_EQ(loaded->manipulator()->task_space(), expected.space);
  EXPECT_EQ(loaded->manipulator()->base_frame(), expected.base);
  EXPECT_EQ(loaded->platform_link(), expected.platform);
  EXPECT_EQ(actuated_joints(*loaded), expected.joints);
}

const Strings upper_arms{"upper_arm_1_joint", "upper_arm_2_joint", "upper_arm_3_joint"};

INSTANTIATE_TEST_SUITE_P(
    All, SetupOfOthers,
    ::testing::Values(
        Found{"gazebo_five_bar", TaskSpace::T2, "base", "tcp", {"shoulder_left", "shoulder_right"}},
        Found{"isaac_stewart",
              TaskSpace::SE3,
              "base_link",
              "top_plate",
              {"extend_1", "extend_2", "extend_3", "extend_4", "extend_5", "extend_6"}},
        Found{"drake_delta", TaskSpace::T3, "base_link", "effector", upper_arms},
        Found{"turning_delta", TaskSpace::T3, "column", "effector", upper_arms},
        Found{"gripping_delta", TaskSpace::T3, "base_link", "effector", upper_arms},
        Found{"detachable_three_rrr",
              TaskSpace::SE2,
              "base_footprint",
              "ee_plate",
              {"motor1", "motor2", "motor3"}},
        Found{"exported_five_bar", TaskSpace::T2, "Base", "Frame1", {"Joint1", "Joint3"}},
        Found{"lettered_three_rpr",
              TaskSpace::SE2,
              "ground",
              "nacelle",
              {"legAStroke", "legBStroke", "legCStroke"}},
        Found{"elbow_closed_five_bar",
              TaskSpace::T2,
              "rr_base_link",
              "rr_outer_2",
              {"rr_active_1", "rr_active_2"}},
        Found{"all_driven_five_bar", TaskSpace::T2, "base_link", "link2_tip", {"joint1", "joint3"}},
        Found{
            "layered_five_bar", TaskSpace::T2, "base_plate", "tip_left", {"shoulder_left", "shoulder_right"}},
        Found{"hung_three_rrr", TaskSpace::SE2, "ground", "moving_stage", {"hip_1", "hip_2", "hip_3"}},
        Found{"hung_delta", TaskSpace::T3, "frame", "tool_plate", {"shoulder_1", "shoulder_2", "shoulder_3"}},
        Found{"hung_five_bar", TaskSpace::T2, "table", "tool", {"drive1", "drive2"}},
        Found{"guided_plunger", TaskSpace::T1, "housing", "plunger", {"crank_shaft"}},
        Found{"gripping_five_bar", TaskSpace::T2, "BaseTable", "Hand", {"LeftShoulder", "RightShoulder"}},
        Found{"clamping_five_bar", TaskSpace::T2, "BaseTable", "Hand", {"LeftShoulder", "RightShoulder"}},
        Found{"jawed_five_bar", TaskSpace::T2, "mesa", "biela_der_fin", {"motor_izq", "motor_der"}},
        Found{"strut_and_crank", TaskSpace::T2, "bench", "link_eye", {"stroke", "pivot"}},
        Found{"octahedral_hexapod",
              TaskSpace::SE3,
              "base",
              "platform",
              {"piston_a_1", "piston_a_2", "piston_b_1", "piston_b_2", "piston_c_1", "piston_c_2"}}));

// Two ways to close it, which differ in their aspects; each loads where it is asked for.
TEST(Setup, AsksWhereTwoWaysToCloseAreEquallyLikely) {
  const SetupResult result = set_up_text(urdf_of("unnamed_three_rpr"));
  EXPECT_FALSE(result.mechanism);
  EXPECT_TRUE(result.config.empty());
  ASSERT_TRUE(result.question) << listed(result.problems);
  EXPECT_EQ(result.question->key, "closures");
  ASSERT_EQ(result.question->candidates.size(), 2U);
  for (const SetupCandidate& candidate : result.question->candidates)
    EXPECT_TRUE(set_up_text(urdf_of("unnamed_three_rpr"), with_closures(candidate.values)).mechanism);
}

using Pairs = std::set<std::set<std::string>>;

Pairs closures_found(const SetupResult& result) {
  Pairs pairs;
  for (const SetupChoice& choice : result.choices)
    if (choice.key == "closures")
      for (const std::string& pair : choice.taken.values)
        pairs.insert({pair.substr(0, pair.find('=')), pair.substr(pair.find('=') + 1)});
  return pairs;
}

// The corners have other words than the legs.
std::string with_named_corners(std::string hexapod) {
  for (const auto& [corner, name] :
       {std::pair{"corner_a", "pin_left"}, {"corner_b", "pin_right"}, {"corner_c", "pin_back"}})
    hexapod = test::replaced(hexapod, corner, name);
  return hexapod;
}

// Two legs meet in each corner; the first leg carries the platform in one.
TEST(Setup, FindsAllLegsThatMeetInPairs) {
  const Pairs all{{"corner_a", "rod_a_2_end"},
                  {"corner_b", "rod_b_1_end"},
                  {"corner_b", "rod_b_2_end"},
                  {"corner_c", "rod_c_1_end"},
                  {"corner_c", "rod_c_2_end"}};
  EXPECT_EQ(closures_found(set_up_text(urdf_of("octahedral_hexapod"))), all);
}

TEST(Setup, AsksWhichNeighboursMeetWhereNamesDoNotDecide) {
  const std::string urdf = with_named_corners(urdf_of("octahedral_hexapod"));
  const SetupResult result = set_up_text(urdf);
  EXPECT_FALSE(result.mechanism);
  ASSERT_TRUE(result.question) << listed(result.problems);
  EXPECT_EQ(result.question->candidates.size(), 4U);
  for (const SetupCandidate& candidate : result.question->candidates) {
    EXPECT_EQ(candidate.values.size(), 5U);
    const SetupResult answered = set_up_text(urdf, with_closures(candidate.values));
    ASSERT_TRUE(answered.mechanism) << listed(answered.problems);
    EXPECT_EQ(answered.mechanism->manipulator()->task_space(), TaskSpace::SE3);
  }
}

// "platform_bravo" and "rod_bravo_tip".
TEST(Setup, TakesWordsThatCountForNumbers) {
  for (const std::string robot : {"three_rrr", "delta", "stewart"}) {
    std::string urdf = test::source_file("urdf/" + robot + ".urdf");
    for (const auto& [number, word] : {std::pair{"1", "alpha"},
                                       {"2", "bravo"},
                                       {"3", "charlie"},
                                       {"4", "delta"},
                                       {"5", "echo"},
                                       {"6", "golf"}})
      for (const std::string after : {"_", "\""})
        if (const std::string old = "_" + std::string(number) + after; urdf.find(old) != std::string::npos)
          urdf = test::replaced(urdf, old, "_" + std::string(word) + after);
    const SetupResult result = set_up_text(urdf);
    ASSERT_TRUE(result.mechanism) << robot << listed(result.problems);
    EXPECT_EQ(result.mechanism->manipulator()->task_space(),
              test::shipped(robot)->manipulator()->task_space());
    EXPECT_EQ(closures_found(result).count(
                  robot == "delta"     ? std::set<std::string>{"platform_bravo_left", "rod_bravo_left_tip"}
                  : robot == "stewart" ? std::set<std::string>{"platform_bravo", "piston_bravo_tip"}
                                       : std::set<std::string>{"platform_bravo", "rod_bravo_tip"}),
              1U)
        << robot;
  }
}

// That of another joint is found, and the unknown name is said.
TEST(Setup, SaysThatATransmissionNamesNoJoint) {
  std::string transmissions;
  for (const std::string joint : {"crank_1_joint", "crank_2_jiont", "crank_3_joint"})
    transmissions += "<transmission name=\"of_" + joint + "\"><joint name=\"" + joint + "\"/></transmission>";
  const std::string urdf =
      test::replaced(test::source_file("urdf/three_rrr.urdf"), "</robot>", transmissions + "</robot>");
  const SetupResult result = set_up_text(urdf);
  const std::string note =
      "robot.urdf has a <transmission> of joint 'crank_2_jiont', but no such joint; did you mean "
      "'crank_2_joint'?";
  EXPECT_EQ(result.notes, Strings{note});
  ASSERT_TRUE(result.mechanism) << listed(result.problems);
  EXPECT_EQ(actuated_joints(*result.mechanism), (Strings{"crank_1_joint", "crank_2_joint", "crank_3_joint"}));
  EXPECT_TRUE(test::has(result.config, "of joint 'crank_2_jiont'"));
}

// A tool behind a wrist on the first rod of a five-bar: the only open end of that chain.
TEST(Setup, NotesAWristThatIsInALoop) {
  const std::string quill =
      R"(<link name="spindle"/><joint name="quill" type="prismatic"><parent link="tool"/>)"
      R"(<child link="spindle"/><axis xyz="0 0 1"/><limit lower="-1" upper="1"/></joint>)";
  const auto yaw = [](const std::string& parent) {
    return R"(<link name="gripper"/><joint name="yaw" type="continuous"><parent link=")" + parent +
           R"("/><child link="gripper"/><origin xyz="0 0 -0.1"/><axis xyz="0 0 1"/></joint>)";
  };
  const std::string five_bar = test::source_file("urdf/five_bar.urdf");
  for (const auto& [joints, first] :
       {std::pair{yaw("tool"), "yaw"}, std::pair{quill + yaw("spindle"), "quill"}}) {
    const std::string urdf = test::replaced(five_bar, "</robot>", joints + "</robot>");
    const SetupResult result = set_up_text(urdf);
    ASSERT_TRUE(result.mechanism) << listed(result.problems);
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_EQ(result.notes.front(),
              "Joint '" + std::string(first) +
                  "' of robot.urdf is in a loop and turns there without moving anything else; where it is a "
                  "wrist behind the platform, close the loop before it, by --closures tool=closing_2.");
    const SetupResult before = set_up_text(urdf, with_closures({"tool=closing_2"}));
    ASSERT_TRUE(before.mechanism) << listed(before.problems);
    EXPECT_EQ(before.notes, Strings{});
    EXPECT_EQ(before.mechanism->idle_degrees_of_freedom(), 0);
  }
  EXPECT_EQ(set_up_text(five_bar).notes, Strings{});
}

// Of the body of the platform, a link whose name says nothing may be meant too.
TEST(Setup, ListsOtherOperationalPoints) {
  const std::string pin = R"(<link name="LINK"/><joint name="LINK" type="fixed"><parent link="platform"/>)"
                          R"(<child link="LINK"/><origin xyz="0.01 0 0"/></joint></robot>)";
  std::string urdf = test::source_file("urdf/three_rrr.urdf");
  for (const std::string link : {"gripper_tcp", "screw_hole"})
    urdf = test::replaced(urdf, "</robot>", test::replaced(pin, "LINK", link));
  const SetupResult result = set_up_text(urdf);
  ASSERT_TRUE(result.mechanism) << listed(result.problems);
  for (const SetupChoice& choice : result.choices) {
    if (choice.key != "operational_point") continue;
    EXPECT_EQ(choice.taken.values, Strings{"gripper_tcp"});
    Strings others;
    for (const SetupCandidate& other : choice.others) others.push_back(other.values.front());
    EXPECT_EQ(others.front(), "platform");
    EXPECT_EQ(std::count(others.begin(), others.end(), "screw_hole"), 0);
  }
  EXPECT_TRUE(test::has(result.config, "Would load too: platform"));
}

std::string without_numbers(std::string wrist) {
  for (const auto& [name, other] :
       {std::pair{"dome1", "qa"}, {"dome2", "qb"}, {"dist1_end", "ra"}, {"dist2_end", "rb"}})
    wrist = test::replaced(wrist, name, other);
  return wrist;
}

// All frames are in the centre, and their axes alone tell them apart, whatever the names are.
TEST(Setup, PairsTheFramesOfAWristByTheirAxes) {
  const std::string wrist = urdf_of("wrist");
  const Pairs right{{"dome1", "dist1_end"}, {"dome2", "dist2_end"}};
  EXPECT_EQ(closures_found(set_up_text(wrist)), right);
  const std::string unnamed = without_numbers(wrist);
  EXPECT_EQ(closures_found(set_up_text(unnamed)), (Pairs{{"qa", "ra"}, {"qb", "rb"}}));
  const std::string with_tool = test::replaced(
      wrist, "</robot>",
      R"(<link name="cap"/><joint name="cap" type="fixed"><parent link="dome"/><child link="cap"/>)"
      R"(<origin xyz="0 0 0.1"/></joint></robot>)");
  EXPECT_EQ(closures_found(set_up_text(with_tool)), right);
}

// Beside the tip of a planar leg, in another layer, it is held as well by the tip.
TEST(Setup, DoesNotAskInWhichLayerAFrameIsHeld) {
  const std::string with_pen = test::replaced(
      urdf_of("layered_five_bar"), "</robot>",
      R"(<link name="pen"/><joint name="pen" type="fixed"><parent link="forearm_left"/><child link="pen"/>)"
      R"(<origin xyz="0.2 0 -0.05"/></joint></robot>)");
  const SetupResult result = set_up_text(with_pen);
  EXPECT_EQ(closures_found(result), (Pairs{{"tip_left", "tip_right"}})) << listed(result.problems);
}

// Neither places nor names tell which axis of the dome is whose.
TEST(Setup, AsksWhereNoAxesOfAWristAreOneAtZero) {
  const std::string turned =
      test::replaced(without_numbers(urdf_of("wrist")), R"(rpy="0 0.9273 0")", R"(rpy="0.2 0.9273 0")");
  const SetupResult result = set_up_text(turned);
  EXPECT_FALSE(result.mechanism);
  ASSERT_TRUE(result.question) << listed(result.problems) << result.config;
  EXPECT_EQ(result.question->key, "closures");
}

// Names that YAML or a comment could take for something else.
TEST(Setup, WritesNamesAsTheyAre) {
  std::string urdf = test::source_file("urdf/five_bar.urdf");
  urdf = test::replaced(urdf, "\"tool\"", "\"tool: #1 [x]\"");
  urdf = test::replaced(urdf, "\"crank_1_joint\"", "\"true\"");
  const SetupResult result = set_up_text(urdf);
  ASSERT_TRUE(result.mechanism) << listed(result.problems);
  EXPECT_EQ(result.mechanism->platform_link(), "tool: #1 [x]");
  EXPECT_EQ(actuated_joints(*result.mechanism), (Strings{"true", "crank_2_joint"}));
}

// A stand below, hands above, balls of three joints, welds and 200 joints.
TEST(Setup, FindsAHexapodAmongTwoHundredJoints) {
  const test::HexapodOf200Joints hexapod;
  const SetupResult result = set_up_text(hexapod.description().urdf);
  ASSERT_TRUE(result.mechanism) << listed(result.problems) << (result.question ? result.question->text : "");
  EXPECT_EQ(result.mechanism->manipulator()->task_space(), TaskSpace::SE3);
  EXPECT_EQ(result.mechanism->platform_link(), "platform");
  EXPECT_EQ(actuated_joints(*result.mechanism),
            (Strings{"crank_1", "crank_2", "crank_3", "crank_4", "crank_5", "crank_6"}));
}

}  // namespace
}  // namespace parallel_aspects
