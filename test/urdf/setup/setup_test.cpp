// SPDX-License-Identifier: BSD-3-Clause
// What is found in bare URDFs: the shipped robots, and robots as others write them.
#include "urdf/setup/setup.h"

#include "urdf/description/name_words.h"
#include "urdf/description/source_names.h"
#include "urdf/load_search.h"

#include <gtest/gtest.h>

#include "support/loops.h"
#include "support/many_joints.h"
#include "support/shipped.h"
#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using Strings = std::vector<std::string>;

// Long enough for sanitizers on a busy machine; the searches take milliseconds.
SetupControl patient() { return {ProcessorClock::now() + std::chrono::minutes(5)}; }

SetupResult set_up_text(const std::string& urdf, const SetupAnswers& answers = {}) {
  return set_up(urdf, "robot.urdf", "robot.yaml", answers, patient());
}

Strings actuated_joints(const Mechanism& mechanism) {
  Strings joints;
  for (const Leg& leg : mechanism.manipulator()->legs()) joints.push_back(leg.actuated_joint);
  return joints;
}

std::string listed(const Problems& problems) {
  std::string text;
  for (const std::string& problem : problems) text += problem + '\n';
  return text;
}

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
                         ::testing::Values("agile_eye", "bipod", "delta", "five_bar", "hexa", "linear_delta",
                                           "six_pus", "spherical_3rrr", "stewart", "three_prr", "three_rpr",
                                           "three_rrr"));

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
        Found{"octahedral_hexapod",
              TaskSpace::SE3,
              "base",
              "platform",
              {"piston_a_1", "piston_a_2", "piston_b_1", "piston_b_2", "piston_c_1", "piston_c_2"}}));

std::string urdf_of(const std::string& name) {
  return test::source_file("test/data/setup/" + name + ".urdf");
}

SetupAnswers with_closures(const Strings& pairs) {
  SetupAnswers answers;
  for (const std::string& pair : pairs)
    answers.closures.push_back({pair.substr(0, pair.find('=')), pair.substr(pair.find('=') + 1)});
  return answers;
}

// Two ways to close it, which differ in their aspects; each loads where it is asked for.
TEST(Setup, AsksWhereEquallyMuchSpeaksForTwoWaysToClose) {
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

TEST(Setup, AsksWhichNeighboursMeetWhereNoNamesTell) {
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
  EXPECT_NE(result.config.find("of joint 'crank_2_jiont'"), std::string::npos) << result.config;
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
                  "' of robot.urdf is in a loop and turns there without moving anything "
                  "else; where it is a wrist behind the platform, close the loop before "
                  "it, by --closures tool=closing_2.");
    const SetupResult before = set_up_text(urdf, with_closures({"tool=closing_2"}));
    ASSERT_TRUE(before.mechanism) << listed(before.problems);
    EXPECT_EQ(before.notes, Strings{});
    EXPECT_EQ(before.mechanism->idle_degrees_of_freedom(), 0);
  }
  EXPECT_EQ(set_up_text(five_bar).notes, Strings{});
}

// Of the body of the platform, a link whose name tells nothing may be meant too.
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
  EXPECT_NE(result.config.find("Would load too: platform"), std::string::npos) << result.config;
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

// The option that the question shows, with the places that it asks for.
Strings filled(Strings pairs, const Strings& places) {
  for (std::size_t k = 0; k < places.size(); ++k)
    for (std::string& pair : pairs)
      if (const std::size_t at = pair.find("X:Y:Z"); at != std::string::npos) {
        pair.replace(at, 5, places[k]);
        break;
      }
  return pairs;
}

// Of rods and corners without links, in one question; the length of one rod is known from another.
TEST(Setup, AsksAtOnceForAllPlacesThatHaveNoLink) {
  const std::string blunt = urdf_of("blunt_three_rrr");
  const SetupResult one = set_up_text(blunt);
  ASSERT_TRUE(one.question) << listed(one.problems);
  EXPECT_NE(one.question->text.find("'platform' ends a chain"), std::string::npos) << one.question->text;
  EXPECT_TRUE(one.question->candidates.empty());
  EXPECT_EQ(one.question->example, (Strings{"platform@X:Y:Z=rod_2@0.4:0:0", "platform@X:Y:Z=rod_3@0.4:0:0"}));
  const SetupResult corrected =
      set_up_text(blunt, with_closures(filled(one.question->example, {"0.2:0:0", "0.1:0.2:0"})));
  ASSERT_TRUE(corrected.mechanism) << listed(corrected.problems);
  EXPECT_EQ(corrected.mechanism->manipulator()->task_space(), TaskSpace::SE2);
  const std::string hung = test::source_file("test/data/chains/three_rrr_on_slides.urdf");
  const SetupResult all = set_up_text(hung);
  ASSERT_TRUE(all.question) << listed(all.problems);
  EXPECT_NE(all.question->text.find("'rod_1', 'rod_2', 'rod_3'"), std::string::npos) << all.question->text;
  const SetupResult found =
      set_up_text(hung, with_closures(filled(all.question->example,
                                             {"0:0:0", "10:0:0", "10:0:0", "10:0:0", "10:10:0", "10:0:0"})));
  ASSERT_TRUE(found.mechanism) << listed(found.problems);
  EXPECT_EQ(found.mechanism->manipulator()->task_space(), TaskSpace::SE2);
}

// It is no more than likely that all rods are of one length, so it is asked.
TEST(Setup, OffersTheLengthOfOtherRods) {
  const std::string urdf = urdf_of("half_blunt_three_rrr");
  const SetupResult asked = set_up_text(urdf);
  ASSERT_TRUE(asked.question) << listed(asked.problems);
  ASSERT_EQ(asked.question->candidates.size(), 1U) << asked.question->text;
  const Strings offered{"corner_1=shank_1_end", "corner_2=shank_2@0.28:0:0", "corner_3=shank_3@0.28:0:0"};
  EXPECT_EQ(asked.question->candidates.front().values, offered);
  const SetupResult found = set_up_text(urdf, with_closures(offered));
  ASSERT_TRUE(found.mechanism) << listed(found.problems);
  EXPECT_NE(found.config.find("{link: shank_2, xyz: [0.28, 0, 0]}"), std::string::npos) << found.config;
  EXPECT_NEAR(found.mechanism->manipulator()->leg(1).rod_length, 0.28, 1e-12);
}

// Also where time did not suffice to try them.
TEST(Setup, OffersEachWayToCloseOnce) {
  const SetupControl none{ProcessorClock::now()};
  const SetupResult result = set_up(urdf_of("hung_three_rrr"), "robot.urdf", "robot.yaml", {}, none);
  ASSERT_TRUE(result.question) << listed(result.problems);
  std::set<std::set<std::string>> once;
  for (const SetupCandidate& candidate : result.question->candidates)
    EXPECT_TRUE(once.insert({candidate.values.begin(), candidate.values.end()}).second)
        << candidate.values.front();
  EXPECT_EQ(once.size(), 6U);
}

// One way that loads, and others that were not tried, are not equals.
TEST(Setup, SaysThatItDidNotTryAllWaysToClose) {
  const std::string urdf = urdf_of("unnamed_three_rpr");
  std::optional<SetupQuestion> question;
  for (int most = 1; most < 10000 && !(question && question->candidates.size() == 1); ++most) {
    SetupControl control = patient();
    control.cancelled = [left = most]() mutable { return --left < 0; };
    question = set_up(urdf, "robot.urdf", "robot.yaml", {}, control).question;
    ASSERT_TRUE(question) << most;
  }
  EXPECT_EQ(question->text,
            "robot.urdf does not tell which open ends meet; the search ended before all ways to close the "
            "loops were tried, and of those that were one loads");
}

// No file was written, and no value given: the options that were tried can be typed as they stand.
TEST(Setup, RefusesInTheWordsOfItsOptions) {
  for (const char* name : {"four_bar", "serial_arm"}) {
    const std::string urdf = test::source_file("test/data/culprits/" + std::string(name) + ".urdf");
    const SetupResult result = set_up_text(urdf);
    ASSERT_FALSE(result.problems.empty()) << name;
    for (const std::string& problem : result.problems)
      for (const char* key : {"robot.yaml", "operational_point", "actuated_joints", "mechanism."})
        EXPECT_EQ(problem.find(key), std::string::npos) << problem;
  }
  const SetupResult four_bar = set_up_text(test::source_file("test/data/culprits/four_bar.urdf"));
  EXPECT_NE(listed(four_bar.problems).find("name them with --closures"), std::string::npos)
      << listed(four_bar.problems);
}

// Of a turntable, of an operational point on a wrist and of missing actuated joints.
// As a robot is refused whose YAML is written by hand.
TEST(Setup, NamesTheElementAtFault) {
  const std::string joined = test::source_file("test/data/setup/gazebo_five_bar.urdf");
  const std::string bare =
      test::replaced(std::regex_replace(joined, std::regex("<gazebo>[\\s\\S]*?</gazebo>"), ""), "</robot>",
                     "<link name=\"right_end\"/><joint name=\"right_end_joint\" type=\"fixed\"><parent "
                     "link=\"forearm_right\"/>"
                     "<child link=\"right_end\"/><origin xyz=\"-0.1 0.2 0\"/></joint></robot>");
  for (const std::string& good : {joined, bare}) {
    EXPECT_TRUE(set_up_text(good).mechanism) << listed(set_up_text(good).problems);
    const std::string knee = "<child link=\"forearm_right\"/><origin xyz=\"0 0.2 0\"/><axis xyz=\"";
    const SetupResult result = set_up_text(test::replaced(good, knee + "0 0 1", knee + "0 1 0"));
    EXPECT_FALSE(result.mechanism);
    const std::string said = listed(result.problems);
    EXPECT_NE(said.find("<axis xyz=\"0 0 1\"/> for joint 'knee_right'"), std::string::npos) << said;
  }
}

TEST(Setup, KeepsTheListOfClosuresThatMayBeMeant) {
  const std::string urdf = test::source_file("test/data/at_zero/low_delta.urdf");
  const SetupResult result = set_up_text(urdf);
  ASSERT_TRUE(result.mechanism) << listed(result.problems);
  const std::size_t list = result.config.find("  # closures:\n  #   - {frames: [");
  ASSERT_NE(list, std::string::npos) << result.config;
  std::string uncommented = result.config.substr(0, list);
  for (std::size_t at = list; at < result.config.size();) {
    const std::size_t end = result.config.find('\n', at);
    const std::string line = result.config.substr(at, end - at);
    const bool is_listed =
        line.find("# closures:") != std::string::npos || line.find("#   - {") != std::string::npos;
    uncommented += (is_listed ? "  " + line.substr(4) : line) + '\n';
    at = end + 1;
  }
  const auto apart = load_mechanism(urdf, "robot.urdf", uncommented, "robot.yaml");
  for (const Leg& leg : apart->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, 0.438193, 1e-5);
  for (const Leg& leg : result.mechanism->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, 0.4, 1e-6);
}

TEST(SetupOptions, StandForTheKeysOfTheLoader) {
  const SourceNames file{"robot.urdf", "a.yaml"}, options{"robot.urdf", "this choice", true};
  EXPECT_EQ(file.entry("base_link", "column"), "base_link: column");
  EXPECT_EQ(options.entry("base_link", "column"), "--base column");
  EXPECT_EQ(file.entry("actuated_joints", Strings{"a", "b"}), "actuated_joints: [a, b]");
  EXPECT_EQ(options.entry("actuated_joints", Strings{"a", "b"}), "--actuated 'a b'");
  EXPECT_EQ(file.full_key("operational_point"), "mechanism.operational_point");
  EXPECT_EQ(options.full_key("operational_point"), "--platform");
  EXPECT_EQ(options.key("closures"), "--closures");
  EXPECT_EQ(options.key("task_space"), "task_space");
}

// The fault is in the answer, not in the closures, which are found.
TEST(Setup, SaysWhyAnswersDoNotFit) {
  for (const Strings& joints : {Strings{"stage_x", "stage_y", "stage_yaw"}, Strings{"hip_1", "hip_2"},
                                Strings{"hip_1", "hip_2", "knee_2"}}) {
    SetupAnswers answers;
    answers.actuated_joints = joints;
    const SetupResult result = set_up_text(urdf_of("hung_three_rrr"), answers);
    EXPECT_FALSE(result.question) << joints.back();
    EXPECT_FALSE(result.cut_short) << joints.back();
    ASSERT_FALSE(result.problems.empty()) << joints.back();
    EXPECT_NE(result.problems.front().find("--actuated '" + joints.front()), std::string::npos)
        << result.problems.front();
  }
}

TEST(Setup, SaysThatTimeDidNotSufficeForAnAnswer) {
  const SetupControl none{ProcessorClock::now()};
  const SetupResult result = set_up(urdf_of("guided_plunger"), "robot.urdf", "robot.yaml",
                                    with_closures({"plunger=small_end"}), none);
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_NE(result.problems.front().find("in the time there is"), std::string::npos)
      << result.problems.front();
}

TEST(Setup, SaysThatAPlaceHasThreeCoordinates) {
  const SetupResult result =
      set_up_text(test::source_file("urdf/five_bar.urdf"), with_closures({"tool=rod_2@0.28:0"}));
  EXPECT_EQ(result.problems,
            Problems{"--closures has 'rod_2@0.28:0'; write a place in the frame of link 'rod_2' with three "
                     "coordinates, as rod_2@X:Y:Z [m]."});
}

TEST(Setup, RefusesToCloseWhatIsFixed) {
  const SetupResult result = set_up_text(urdf_of("hung_three_rrr"), with_closures({"corner_1=corner_2"}));
  ASSERT_EQ(result.problems.size(), 1U) << listed(result.problems);
  EXPECT_NE(result.problems.front().find("fixed to each other"), std::string::npos)
      << result.problems.front();
}

// Limits have to state an effort, so that it tells no more than a name does.
TEST(Setup, TakesAnEffortThatLimitsNeedForAHint) {
  std::string urdf = urdf_of("hung_five_bar");
  for (const char* elbow : {"pivot1", "pivot2"}) {
    const std::string joint = "<joint name=\"" + std::string(elbow) + "\" type=";
    urdf =
        test::replaced(urdf, joint + "\"continuous\">",
                       joint + "\"revolute\"><limit lower=\"-3\" upper=\"3\" effort=\"9\" velocity=\"1\"/>");
  }
  const SetupResult result = set_up_text(urdf);
  ASSERT_TRUE(result.mechanism) << listed(result.problems);
  EXPECT_EQ(actuated_joints(*result.mechanism), (Strings{"drive1", "drive2"}));
}

TEST(Setup, CallsASerialArmSerial) {
  const SetupResult result = set_up_text(urdf_of("serial_arm"));
  EXPECT_FALSE(result.question);
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_NE(result.problems.front().find("serial"), std::string::npos) << result.problems.front();
}

// A prismatic leg that is drawn with its base turning could be neither; a five-bar could be driven at its
// elbows.
TEST(Setup, TakesAnswersAndSaysWhatElseWouldDo) {
  const std::string urdf = urdf_of("all_driven_five_bar");
  const SetupResult found = set_up_text(urdf);
  const auto choice = std::find_if(found.choices.begin(), found.choices.end(),
                                   [](const SetupChoice& each) { return each.key == "actuated_joints"; });
  ASSERT_NE(choice, found.choices.end());
  ASSERT_FALSE(choice->others.empty());
  const Strings elbows{"joint2", "joint4"};
  EXPECT_EQ(choice->others.front().values, elbows);
  EXPECT_NE(found.config.find("joint2, joint4"), std::string::npos) << found.config;
  SetupAnswers answers;
  answers.actuated_joints = elbows;
  answers.operational_point = "link4_tip";
  const SetupResult asked = set_up_text(urdf, answers);
  ASSERT_TRUE(asked.mechanism) << listed(asked.problems);
  EXPECT_EQ(actuated_joints(*asked.mechanism), elbows);
  EXPECT_EQ(asked.mechanism->platform_link(), "link4_tip");
}

TEST(Setup, RefusesAnswersThatNameNothing) {
  SetupAnswers answers = with_closures({"tool=closing_3"});
  answers.actuated_joints = {"tool_joint"};
  answers.base_link = "bas_link";
  const SetupResult result = set_up_text(test::source_file("urdf/five_bar.urdf"), answers);
  EXPECT_EQ(result.problems.size(), 3U) << listed(result.problems);
}

TEST(Setup, EndsWithTheTimeThatItIsGiven) {
  const SetupControl none{ProcessorClock::now()};
  const SetupResult result =
      set_up(test::source_file("urdf/stewart.urdf"), "robot.urdf", "robot.yaml", {}, none);
  EXPECT_TRUE(result.cut_short);
  EXPECT_FALSE(result.mechanism);
  ASSERT_TRUE(result.question);
  EXPECT_FALSE(result.question->candidates.empty());
  SetupControl cancelled = patient();
  cancelled.cancelled = [] { return true; };
  EXPECT_FALSE(
      set_up(test::source_file("urdf/stewart.urdf"), "robot.urdf", "robot.yaml", {}, cancelled).mechanism);
}

// Before every attempt to assemble, so that a search with a deadline is late by one of them at most.
TEST(LoadSearch, EndsWhereItsCheckpointThrows) {
  const auto load = [](const LoadSearch& search) {
    load_mechanism(test::source_file("urdf/five_bar.urdf"), "robot.urdf",
                   test::source_file("config/robots/five_bar.yaml"), "robot.yaml", "", search);
  };
  int attempts = 0;
  LoadSearch search;
  search.checkpoint = [&] { ++attempts; };
  load(search);
  EXPECT_GT(attempts, 0);
  struct Late {};
  search.checkpoint = [] { throw Late{}; };
  EXPECT_THROW(load(search), Late);
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

TEST(NameWords, AreSplitWhereReadersSplitThem) {
  EXPECT_EQ(words_of("rod_2-leftTip"), (Strings{"rod", "2", "left", "tip"}));
  EXPECT_EQ(words_of("legBEnd"), (Strings{"leg", "b", "end"}));
  EXPECT_EQ(words_of("TCP"), Strings{"tcp"});
  EXPECT_EQ(words_of(""), Strings{});
  EXPECT_EQ(role_of("crank_2_joint"), role_of("crank_13_joint"));
  EXPECT_GT(operational_point_likeness("platform"), operational_point_likeness("platform_2"));
  EXPECT_EQ(operational_point_likeness("rod_2_tip"), 0);
}

}  // namespace
}  // namespace parallel_aspects
