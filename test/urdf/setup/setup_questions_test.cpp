// SPDX-License-Identifier: BSD-3-Clause
// What setup asks where a URDF leaves something open, and what it does with answers.
#include "urdf/description/messages.h"
#include "urdf/load_mechanism.h"
#include "urdf/setup/setup_texts.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/robots/shipped.h"
#include "support/texts.h"
#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::actuated_joints;
using test::listed;
using test::patient;
using test::set_up_text;
using test::Strings;
using test::urdf_of;
using test::with_closures;

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

// With the work of the command, whose answer depends on nothing else; no other order of its ends is offered.
TEST(Setup, SaysThatARobotIsSingularInEveryPose) {
  const SetupResult result = set_up(test::source_file("test/data/faulty/singular_hexapod.urdf"), "robot.urdf",
                                    "robot.yaml", {}, SetupControl{25000});
  EXPECT_FALSE(result.question);
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_TRUE(test::has(result.problems.front(),
                        "robot.urdf is assembled, but singular in every pose: det A is zero"));
  EXPECT_FALSE(test::has(result.problems.front(), "corner_3=piston_2"));
}

// Of rods and corners without links, in one question.
TEST(Setup, AsksAtOnceForAllPlacesThatHaveNoLink) {
  const std::string blunt = urdf_of("blunt_three_rrr");
  const SetupResult one = set_up_text(blunt);
  ASSERT_TRUE(one.question) << listed(one.problems);
  EXPECT_TRUE(test::has(one.question->text, "'platform', 'rod_2', 'rod_3' end chains"));
  EXPECT_TRUE(one.question->candidates.empty());
  EXPECT_EQ(one.question->example, (Strings{"platform@X:Y:Z=rod_2@X:Y:Z", "platform@X:Y:Z=rod_3@X:Y:Z"}));
  const SetupResult corrected = set_up_text(
      blunt, with_closures(filled(one.question->example, {"0.2:0:0", "0.4:0:0", "0.1:0.2:0", "0.4:0:0"})));
  ASSERT_TRUE(corrected.mechanism) << listed(corrected.problems);
  EXPECT_EQ(corrected.mechanism->manipulator()->task_space(), TaskSpace::SE2);
  const std::string hung = test::source_file("test/data/chains/three_rrr_on_slides.urdf");
  const SetupResult all = set_up_text(hung);
  ASSERT_TRUE(all.question) << listed(all.problems);
  EXPECT_TRUE(test::has(all.question->text, "'rod_1', 'rod_2', 'rod_3'"));
  const SetupResult found =
      set_up_text(hung, with_closures(filled(all.question->example,
                                             {"0:0:0", "10:0:0", "10:0:0", "10:0:0", "10:10:0", "10:0:0"})));
  ASSERT_TRUE(found.mechanism) << listed(found.problems);
  EXPECT_EQ(found.mechanism->manipulator()->task_space(), TaskSpace::SE2);
}

// Rods may be of one length or not, and the plate of the hexapod is beside the pin that carries it.
TEST(Setup, NeverTakesALengthOfAnotherLink) {
  const std::string half = urdf_of("half_blunt_three_rrr");
  const SetupResult rods = set_up_text(half);
  ASSERT_TRUE(rods.question) << listed(rods.problems);
  EXPECT_TRUE(rods.question->candidates.empty());
  EXPECT_EQ(rods.question->example,
            (Strings{"corner_1=shank_1_end", "corner_2=shank_2@X:Y:Z", "corner_3=shank_3@X:Y:Z"}));
  const SetupResult found =
      set_up_text(half, with_closures(filled(rods.question->example, {"0.28:0:0", "0.28:0:0"})));
  ASSERT_TRUE(found.mechanism) << listed(found.problems);
  EXPECT_TRUE(test::has(found.config, "{link: shank_2, xyz: [0.28, 0, 0]}"));
  EXPECT_NEAR(found.mechanism->manipulator()->leg(1).rod_length, 0.28, 1e-12);
  const SetupResult plate = set_up_text(urdf_of("pinned_hexapod"));
  ASSERT_TRUE(plate.question) << listed(plate.problems);
  EXPECT_TRUE(plate.question->candidates.empty());
  EXPECT_EQ(plate.question->example, (Strings{"plate@X:Y:Z=pin_2", "plate@X:Y:Z=pin_3", "plate@X:Y:Z=pin_4",
                                              "plate@X:Y:Z=pin_5", "plate@X:Y:Z=pin_6"}));
}

// Its legs are as long as each other, as they are drawn.
TEST(Setup, FindsTheHexapodFromTheAnswerThatItAsksFor) {
  const std::string urdf = urdf_of("pinned_hexapod");
  const SetupResult asked = set_up_text(urdf);
  ASSERT_TRUE(asked.question) << listed(asked.problems);
  const SetupResult found = set_up_text(
      urdf, with_closures(filled(asked.question->example,
                                 {"0.115080:0.125126:0", "0.050823:0.162225:0", "-0.165903:0.037099:0",
                                  "-0.165903:-0.037099:0", "0.050823:-0.162225:0"})));
  ASSERT_TRUE(found.mechanism) << listed(found.problems);
  for (const Leg& leg : found.mechanism->manipulator()->legs())
    EXPECT_NEAR(std::sqrt(leg.squared_distance(0.0)), 0.25 / 0.909512, 1e-5) << leg.name;
}

// The length by which the plate is beside the first pin, which all other pins then seem to have.
TEST(Setup, RefusesAnAnswerWithALengthOfAnotherLink) {
  const std::string urdf = urdf_of("pinned_hexapod"), length = "@-0.11508:0.125126:0";
  const Strings places{"0.11508:0.125126:0", "0.050823:0.162225:0", "-0.165903:0.037099:0",
                       "-0.165903:-0.037099:0", "0.050823:-0.162225:0"};
  Strings lent, right;
  std::string all;
  for (std::size_t k = 0; k < places.size(); ++k) {
    right.push_back("plate@" + places[k] + "=pin_" + std::to_string(k + 2));
    lent.push_back(right.back() + length);
    all += (k == 0 ? "" : " ") + right.back();
  }
  const SetupResult wrong = set_up_text(urdf, with_closures(lent));
  EXPECT_FALSE(wrong.mechanism);
  EXPECT_EQ(listed(wrong.problems),
            "robot.yaml ends legs by the length of another link: closures hold rods where joint "
            "'plate_joint' has link 'plate' on 'pin_1', while the leg of 'pin_1' ends at its origin; end all "
            "legs so and write --closures '" +
                all + "', or, if the legs differ, add a link at the end of each rod to robot.urdf.\n");
  const SetupResult found = set_up_text(urdf, with_closures(right));
  ASSERT_TRUE(found.mechanism) << listed(found.problems);
}

TEST(Setup, AsksForBothEndsOfRodsThatManyChainsHave) {
  const SetupResult delta = set_up_text(urdf_of("bare_rods"));
  ASSERT_TRUE(delta.question) << listed(delta.problems);
  ASSERT_FALSE(delta.question->example.empty());
  EXPECT_EQ(delta.question->example.back(), "platform@X:Y:Z=rod_3@X:Y:Z");
  EXPECT_TRUE(test::has(delta.question->text, "their rods have none"));
  const SetupResult hopper = set_up_text(urdf_of("hopper"));
  ASSERT_TRUE(hopper.question) << listed(hopper.problems);
  Strings pairs;
  for (const char* leg : {"front_left", "front_right", "rear_left", "rear_right"}) {
    const std::string lower = "lower_" + std::string(leg);
    pairs.push_back(lower + "_inner@X:Y:Z=" + lower + "_outer@X:Y:Z");
  }
  EXPECT_EQ(hopper.question->example, pairs) << hopper.question->text;
}

// Also where time did not suffice to try them.
TEST(Setup, OffersEachWayToCloseOnce) {
  const SetupControl none{0};
  const SetupResult result = set_up(urdf_of("unnamed_three_rpr"), "robot.urdf", "robot.yaml", {}, none);
  ASSERT_TRUE(result.question) << listed(result.problems);
  std::set<std::set<std::string>> once;
  for (const SetupCandidate& candidate : result.question->candidates)
    EXPECT_TRUE(once.insert({candidate.values.begin(), candidate.values.end()}).second)
        << candidate.values.front();
  EXPECT_EQ(once.size(), 2U);
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
            "robot.urdf does not say which open ends meet; the search ended before all ways to close the "
            "loops were tried, and of those that were one loads");
}

// With the work of the command: ends that were tried and refused are no answer.
TEST(Setup, SaysTheCauseBeforeItAsksForEnds) {
  const auto said = [](const std::string& urdf) {
    const SetupResult result = set_up(urdf, "robot.urdf", "robot.yaml", {}, SetupControl{25000});
    EXPECT_FALSE(result.question) << result.question->text;
    return listed(result.problems);
  };
  const std::string rod = said(test::source_file("test/data/bad/zero_rod.urdf"));
  EXPECT_EQ(rod.rfind("this choice has --platform 'tool' on the axis of joint 'elbow_1_joint'", 0), 0U)
      << rod;
  const std::string crank = said(test::source_file("test/data/bad/zero_crank.urdf"));
  EXPECT_EQ(crank.rfind("robot.urdf puts 'crank_1_joint' and 'elbow_1_joint' on one axis", 0), 0U) << crank;
}

// No file was written, and no value given: the options that were tried can be typed as they stand.
TEST(Setup, RefusesInTheWordsOfItsOptions) {
  for (const char* name : {"four_bar", "serial_arm"}) {
    const std::string urdf = test::source_file("test/data/faulty/" + std::string(name) + ".urdf");
    const SetupResult result = set_up_text(urdf);
    ASSERT_FALSE(result.problems.empty()) << name;
    for (const std::string& problem : result.problems)
      for (const char* key : {"robot.yaml", "operational_point", "actuated_joints", "mechanism."})
        EXPECT_FALSE(test::has(problem, key));
  }
  const SetupResult four_bar = set_up_text(test::source_file("test/data/faulty/four_bar.urdf"));
  EXPECT_TRUE(test::has(listed(four_bar.problems), "name them with --closures"));
}

// What the chain that the platform hangs on does is not taken for a leg, nor a swivel for a motor.
TEST(Setup, RefusesWithTheTrueCause) {
  const auto refusal = [](const std::string& robot, const std::string& one, const std::string& other) {
    return listed(set_up_text(test::replaced(urdf_of(robot), one, other)).problems);
  };
  const std::string hung = refusal("hung_five_bar", "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 0 1\"/>");
  EXPECT_TRUE(test::has(hung, "write <axis xyz=\"0 1 0\"/> for joint 'rail_y'"));
  const std::string knee = "<child link=\"link\"/><origin xyz=\"0.1 0.2 0\" rpy=\"0 0 0\"/><axis xyz=\"";
  const std::string struts = refusal("strut_and_crank", knee + "0 0 1", knee + "1 0 0");
  EXPECT_TRUE(test::has(struts, "write <axis xyz=\"0 0 1\"/> for joint 'knee'"));
  const std::string arm = "<child link=\"upper_arm_right\"/><origin xyz=\"0.05 0 0.02\"";
  const std::string layered = refusal("layered_five_bar", arm, arm + " rpy=\"1.5708 0 0.95993\"");
  EXPECT_TRUE(test::has(layered, "write rpy=\"0 0 0\" in the origin of joint 'shoulder_right'"));
}

// As a robot is refused whose YAML is written by hand.
TEST(Setup, NamesTheElementAtFault) {
  const std::string joined = test::source_file("test/data/setup/gazebo_five_bar.urdf");
  const std::string bare = test::replaced(
      std::regex_replace(joined, std::regex("<gazebo>[\\s\\S]*?</gazebo>"), ""), "</robot>",
      "<link name=\"right_end\"/><joint name=\"right_end_joint\" type=\"fixed\"><parent "
      "link=\"forearm_right\"/><child link=\"right_end\"/><origin xyz=\"-0.1 0.2 0\"/></joint></robot>");
  for (const std::string& good : {joined, bare}) {
    EXPECT_TRUE(set_up_text(good).mechanism) << listed(set_up_text(good).problems);
    const std::string knee = "<child link=\"forearm_right\"/><origin xyz=\"0 0.2 0\"/><axis xyz=\"";
    const SetupResult result = set_up_text(test::replaced(good, knee + "0 0 1", knee + "0 1 0"));
    EXPECT_FALSE(result.mechanism);
    const std::string said = listed(result.problems);
    EXPECT_TRUE(test::has(said, "<axis xyz=\"0 0 1\"/> for joint 'knee_right'"));
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
    EXPECT_TRUE(test::has(result.problems.back(), "--actuated '" + joints.front()))
        << result.problems.front();
  }
}

TEST(Setup, SaysThatTimeDidNotSufficeForAnAnswer) {
  const SetupControl none{0};
  const SetupResult result = set_up(urdf_of("guided_plunger"), "robot.urdf", "robot.yaml",
                                    with_closures({"plunger=small_end"}), none);
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_TRUE(test::has(result.problems.front(), "in the time there is"));
}

TEST(Setup, SaysThatAPlaceHasThreeCoordinates) {
  const SetupResult result =
      set_up_text(test::source_file("urdf/five_bar.urdf"), with_closures({"tool=rod_2@0.28:0"}));
  EXPECT_EQ(result.problems, Problems{"--closures has 'rod_2@0.28:0'; write a place in the frame of link "
                                      "'rod_2' with three coordinates, as rod_2@X:Y:Z [m]."});
}

TEST(Setup, RefusesToCloseWhatIsFixed) {
  const SetupResult result = set_up_text(urdf_of("hung_three_rrr"), with_closures({"corner_1=corner_2"}));
  ASSERT_EQ(result.problems.size(), 1U) << listed(result.problems);
  EXPECT_TRUE(test::has(result.problems.front(), "fixed to each other"));
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

// Whatever frames are at its ends.
TEST(Setup, CallsASerialArmSerial) {
  std::string urdf = urdf_of("serial_arm");
  for (const std::string link : {"base_link", "l3", "l3", "l3"}) {
    const SetupResult result = set_up_text(urdf);
    EXPECT_FALSE(result.question);
    EXPECT_EQ(result.problems,
              Problems{"robot.urdf is a serial arm, one chain of 3 joints from link 'base_link' to link 'l3' "
                       "without a loop; only the command `aspects` treats serial arms, with a YAML as "
                       "`aspects setup` writes it."});
    const std::string frame = "frame_" + std::to_string(urdf.size());
    urdf = test::replaced(
        urdf, "</robot>",
        "<link name=\"" + frame + "\"/>" + test::fixed_joint(link, frame, "xyz=\"0 0 0.33\"") + "</robot>");
  }
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
  EXPECT_TRUE(test::has(found.config, "joint2, joint4"));
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
  const SetupControl none{0};
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

// A chain of the base that no closure is on may be a leg, whose others end on the base where no link is.
TEST(Setup, AsksWhetherAChainOfTheBaseIsALeg) {
  const std::string urdf = urdf_of("hanging_three_rrr");
  const SetupResult asked = set_up_text(urdf);
  ASSERT_TRUE(asked.question) << listed(asked.problems);
  EXPECT_EQ(asked.question->text,
            "robot.urdf does not say whether the chain between the root and link 'plate' is a leg, whose "
            "loops end on the root");
  ASSERT_EQ(asked.question->candidates.size(), 2U);
  const auto answered = [&](std::size_t k) {
    SetupAnswers answers = with_closures(asked.question->candidates.at(k).values);
    if (k == 0) answers.actuated_joints = {"hip_1", "hip_2", "hip_3"};
    return set_up_text(urdf, answers);
  };
  const SetupResult leg = answered(0), left_out = answered(1);
  ASSERT_TRUE(leg.mechanism) << listed(leg.problems);
  ASSERT_TRUE(left_out.mechanism) << listed(left_out.problems);
  EXPECT_EQ(leg.mechanism->manipulator()->task_space(), TaskSpace::SE2);
  EXPECT_EQ(leg.mechanism->manipulator()->base_frame(), "base");
  EXPECT_EQ(leg.mechanism->platform_link(), "tcp");
  EXPECT_EQ(actuated_joints(*leg.mechanism), (Strings{"hip_1", "hip_2", "hip_3"}));
  EXPECT_EQ(left_out.mechanism->manipulator()->task_space(), TaskSpace::T2);
}

TEST(Setup, FindsTheBaseOfATreeThatStartsAtThePlatformByItsName) {
  SetupAnswers answers;
  answers.actuated_joints = {"hip_1", "hip_2", "hip_3"};
  const SetupResult found = set_up_text(urdf_of("upside_down_three_rrr"), answers);
  ASSERT_TRUE(found.mechanism) << listed(found.problems);
  EXPECT_EQ(found.mechanism->manipulator()->task_space(), TaskSpace::SE2);
  EXPECT_EQ(found.mechanism->manipulator()->base_frame(), "ground");
  EXPECT_EQ(found.mechanism->platform_link(), "stage");
  EXPECT_EQ(actuated_joints(*found.mechanism), answers.actuated_joints);
  EXPECT_EQ(found.choices.front().taken.reason,
            "its name says so, and that of link 'stage', where the tree starts, that it is the platform");
}

}  // namespace
}  // namespace parallel_aspects
