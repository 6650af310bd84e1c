// SPDX-License-Identifier: BSD-3-Clause
// Frames of closures on wrong links, and closures that are missing: each remedy is followed to the letter.
#include "urdf/corrections/said_of_robots.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/texts.h"
#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Description;
using test::exchanged;
using test::expect_remedies_work;
using test::has_note;
using test::replaced;
using test::sentence;
using test::shipped_text;

Description on_link(const std::string& robot, const std::string& frame, const std::string& parent,
                    const std::string& other) {
  Description moved = shipped_text(robot);
  moved.change_urdf("<parent link=\"" + parent + "\"/>\n    <child link=\"" + frame + "\"/>",
                    "<parent link=\"" + other + "\"/>\n    <child link=\"" + frame + "\"/>");
  return moved;
}

TEST(FrameCorrection, IsTheParentOfAFrameOfAFiveBar) {
  for (const std::string other : {"crank_2", "crank_1", "base_link", "tool"}) {
    const Description robot = on_link("five_bar", "closing_2", "rod_2", other);
    const std::string said = sentence(robot);
    EXPECT_EQ(said, "robot.urdf fixes link 'closing_2', which closure 'tool - closing_2' holds, to link '" +
                        other +
                        "', and link 'rod_2' is in no loop; write <parent link=\"rod_2\"/> for joint "
                        "'closing_2_joint', which makes it a robot in T2.");
    expect_remedies_work(robot, said);
  }
}

// Either end may be meant to be on the other rod.
TEST(FrameCorrection, IsOneOfTwoWhereBothEndsAreOnOneRod) {
  const Description robot = on_link("five_bar", "closing_2", "rod_2", "rod_1");
  const std::string said = sentence(robot);
  EXPECT_EQ(test::remedies(said).size(), 2U);
  expect_remedies_work(robot, said);
}

TEST(FrameCorrection, IsTheParentOfAFrameAnywhere) {
  for (const std::string other : {"bar_3", "bar_1", "base_link", "platform"}) {
    const Description robot = on_link("three_rpr", "bar_2_tip", "bar_2", other);
    const std::string said = sentence(robot);
    EXPECT_TRUE(test::has(said, "for joint 'bar_2_tip_joint'"));
    expect_remedies_work(robot, said);
  }
  for (const std::string other : {"rod_3_left", "crank_2"}) {
    const Description robot = on_link("delta", "rod_2_left_tip", "rod_2_left", other);
    const std::string said = sentence(robot);
    EXPECT_TRUE(test::has(said,
                          "write <parent link=\"rod_2_left\"/> for joint 'rod_2_left_tip_joint', which makes "
                          "it a robot in T3."));
    expect_remedies_work(robot, said);
  }
}

// Not one of another leg, whose anchor would be the same.
TEST(FrameCorrection, GivesEachLegItsOwnAnchor) {
  for (const std::string other : {"bar_3", "base_link", "bar_2"}) {
    const Description robot = on_link("three_rpr", "platform_2", "platform", other);
    EXPECT_EQ(sentence(robot),
              "robot.urdf fixes link 'platform_2', which closure 'platform_2 - bar_2_tip' holds, to link '" +
                  other +
                  "'; write <parent link=\"platform\"/> for joint 'platform_2_joint', which makes it a robot "
                  "in SE2.");
  }
}

TEST(FrameCorrection, ComesWithAnActuatedJointThatIsWrong) {
  Description robot = on_link("delta", "rod_2_left_tip", "rod_2_left", "rod_3_left");
  robot.change_config("crank_2_joint, crank_3_joint]", "crank_2_joint, rod_3_left_pitch_joint]");
  const std::string said = sentence(robot);
  EXPECT_TRUE(test::has(
      said,
      "write <parent link=\"rod_2_left\"/> for joint 'rod_2_left_tip_joint' and write actuated_joints: "
      "[crank_1_joint, crank_2_joint, crank_3_joint], which makes it a robot in T3."));
  expect_remedies_work(robot, said);
}

TEST(FrameCorrection, IsAFrameThatTwoClosuresHave) {
  Description robot = shipped_text("delta");
  robot.change_config("[platform_2_left, rod_2_left_tip]", "[platform_2_left, rod_3_left_tip]");
  const std::string said = sentence(robot);
  EXPECT_EQ(
      said,
      "robot.yaml names link 'rod_3_left_tip' in closure 'platform_2_left - rod_3_left_tip', which closure "
      "'platform_3_left - rod_3_left_tip' has, too; write link 'rod_2_left_tip' in the place of "
      "'rod_3_left_tip' in closure 'platform_2_left - rod_3_left_tip', which makes it a robot in T3.");
  expect_remedies_work(robot, said);
}

TEST(FrameCorrection, IsAClosureThatIsMissing) {
  Description robot = shipped_text("three_rpr");
  robot.change_config("    - {frames: [platform_2, bar_2_tip], type: revolute}\n", "");
  const std::string said = sentence(robot);
  EXPECT_EQ(said,
            "no closure of robot.yaml joins link 'bar_2_tip', which ends a chain of robot.urdf, to link "
            "'platform_2'; add {frames: [platform_2, bar_2_tip], type: revolute} to mechanism.closures, "
            "which makes it a robot in SE2.");
  expect_remedies_work(robot, said);
}

// Nothing that is written must be changed: to exchange the rod's end with that of its neighbour would load as
// well, but with another geometry.
TEST(FrameCorrection, IsAClosureThatIsMissingBeforeItIsAWrongLink) {
  for (const std::string closure : {"1b", "2a", "2b", "3a", "3b"}) {
    Description robot{test::source_file("test/data/faulty/delta_in_pairs.urdf"),
                      test::source_file("test/data/faulty/delta_in_pairs.yaml")};
    robot.change_config("    - {type: point, frames: [rodend_" + closure + ", ball_" + closure + "]}\n", "");
    const std::string said = sentence(robot);
    EXPECT_TRUE(test::has(said, "add {frames: [ball_" + closure + ", rodend_" + closure + "]"));
    EXPECT_FALSE(test::has(said, "in the place of"));
    expect_remedies_work(robot, said);
  }
}

// Either may be meant: the joint to be fixed, or the frame to be on another link.
TEST(FrameCorrection, IsListedAfterAJointThatIsOneTooMany) {
  for (const std::string leg : {"2", "3"}) {
    const std::string joint = "platform_" + leg + "_direction_joint";
    Description robot = shipped_text("spherical_3rrr");
    robot.change_urdf("<joint name=\"" + joint + "\" type=\"fixed\">",
                      "<joint name=\"" + joint + "\" type=\"continuous\">");
    const std::string said = sentence(robot);
    const std::vector<std::string> remedies = test::remedies(said);
    ASSERT_GE(remedies.size(), 2U) << said;
    EXPECT_EQ(remedies.front(), "write type=\"fixed\" for joint '" + joint + "'");
    EXPECT_EQ(remedies.back(), "write <parent link=\"platform_1\"/> for joint 'platform_" + leg + "_joint'");
    expect_remedies_work(robot, said);
  }
}

TEST(FrameCorrection, IsNoClosureWhereARodHangsLoose) {
  Description robot = shipped_text("delta");
  robot.change_config("    - {frames: [platform_2_left, rod_2_left_tip], type: spherical}\n", "");
  const std::string said = sentence(robot);
  EXPECT_TRUE(test::has(said,
                        "add {frames: [platform_2_left, rod_2_left_tip], type: point} to mechanism.closures, "
                        "which makes it a robot in T3."));
}

// Of which no leg starts there, as all actuated joints are slides on struts.
TEST(Base, IsTheRoot) {
  Description robot = shipped_text("three_rpr");
  robot.change_config("base_link: base_link", "base_link: platform");
  EXPECT_EQ(sentence(robot),
            "robot.yaml has base_link 'platform', while the tree of robot.urdf starts at link 'base_link'; "
            "write base_link: base_link, which makes it a robot in SE2.");
}

TEST(FrameCorrection, IsTheTypeOfAllClosures) {
  for (const std::string type : {"revolute", "universal"}) {
    Description robot = shipped_text("stewart");
    for (std::size_t at = 0; (at = robot.config.find("type: spherical", at)) != std::string::npos;)
      robot.config.replace(at, std::string("type: spherical").size(), "type: " + type);
    EXPECT_TRUE(test::has(sentence(robot), "by types that do not fit its joints; write type: point for"));
  }
}

TEST(FrameCorrection, IsAFixedElbow) {
  for (const std::string elbow : {"elbow_1_joint", "elbow_2_joint"}) {
    Description robot = shipped_text("five_bar");
    robot.change_urdf("<joint name=\"" + elbow + "\" type=\"continuous\">",
                      "<joint name=\"" + elbow + "\" type=\"fixed\">");
    EXPECT_TRUE(test::begins(sentence(robot), "robot.urdf fixes joint '" + elbow + "'"));
    expect_remedies_work(robot, sentence(robot));
  }
}

std::string with_origin_in(std::string urdf, const std::string& joint, const std::string& origin) {
  const std::size_t at = urdf.find("<origin", urdf.find("<joint name=\"" + joint + "\""));
  return urdf.replace(at, urdf.find("/>", at) - at, "<origin " + origin);
}

// The origin of a joint of the Delta.
Description with_origin(const std::string& joint, const std::string& origin) {
  Description robot = shipped_text("delta");
  robot.urdf = with_origin_in(robot.urdf, joint, origin);
  return robot;
}

// That of one leg is turned by degrees, on the platform or on the base.
TEST(FrameCorrection, IsAnAngleInDegrees) {
  for (const auto& [joint, degrees, radians] :
       {std::array{"platform_2_direction_joint", "120", "2.09439510239"},
        {"platform_3_direction_joint", "-120", "-2.09439510239"},
        {"leg_2_joint", "120", "2.09439510239"}}) {
    const Description robot = with_origin(joint, "rpy=\"0 0 " + std::string(degrees) + "\"");
    const std::string said = sentence(robot);
    EXPECT_EQ(said, "robot.urdf turns the origin of joint '" + std::string(joint) + "' by rpy (0, 0, " +
                        degrees + ") rad, as if in degrees; write rpy=\"0 0 " + radians +
                        "\" in the origin of joint '" + joint + "', which makes it a robot in T3.");
    expect_remedies_work(robot, said);
  }
}

// Also of a robot that loads with them.
TEST(FrameCorrection, NotesAnglesInDegrees) {
  Description robot = shipped_text("stewart");
  const std::size_t at =
      robot.urdf.find("<origin", robot.urdf.find("<joint name=\"platform_3_direction_joint\""));
  robot.urdf.replace(at, robot.urdf.find("/>", at) - at, "<origin rpy=\"0 0 60\"");
  const auto mechanism = test::load(robot);
  const auto& notes = mechanism->notes();
  EXPECT_EQ(std::count(notes.begin(), notes.end(),
                       "robot.urdf turns the origin of joint 'platform_3_direction_joint' by rpy (0, 0, 60) "
                       "rad, as if in degrees; if so, write rpy=\"0 0 1.0471975512\" in the origin of joint "
                       "'platform_3_direction_joint'."),
            1);
}

// A right angle beside one in degrees is one in radians already.
TEST(FrameCorrection, ConvertsOnlyAnglesThatAreInDegrees) {
  const std::string frame = "leg_2_joint";
  Description robot = shipped_text("spherical_3rrr");
  const std::string good = robot.urdf;
  robot.urdf = with_origin_in(good, frame, "rpy=\"2.181661564992912 0 120\"");
  ASSERT_NE(robot.urdf, good);
  const Problems problems = test::refusal(robot);
  const std::string said = problems.empty() ? test::only_warning(robot) : problems.front();
  EXPECT_TRUE(test::has(said, "by rpy (2.18166156499, 0, 120) rad, as if in degrees; "));
  const std::string remedy =
      "write rpy=\"2.18166156499 0 2.09439510239\" in the origin of joint '" + frame + "'";
  ASSERT_NE(said.find(remedy), std::string::npos) << said;
  const auto corrected = test::load(test::corrected(robot, remedy));
  const auto meant = test::load(shipped_text("spherical_3rrr"));
  for (std::size_t j = 0; j < 3; ++j)
    EXPECT_LT(
        (corrected->manipulator()->leg(j).base_point() - meant->manipulator()->leg(j).base_point()).norm(),
        1e-6);
}

// More than a turn, of radians; and 36 degrees by four digits, which are -213 degrees read as radians.
TEST(FrameCorrection, AcceptsAnglesInRadians) {
  for (const std::string angle : {"8.37758040957", "14.6607657168", "-10.4719755"}) {
    const Description robot = with_origin("leg_2_joint", "rpy=\"0 0 " + angle + "\"");
    EXPECT_EQ(test::warnings(robot), std::vector<std::string>{}) << angle;
  }
  Description five_bar = shipped_text("five_bar");
  const std::string tip = "<joint name=\"crank_2_joint\" type=\"continuous\">";
  ASSERT_NE(five_bar.urdf.find(tip), std::string::npos);
  const std::size_t origin = five_bar.urdf.find("<origin xyz=", five_bar.urdf.find(tip));
  five_bar.urdf.replace(five_bar.urdf.find("/>", origin), 0, " rpy=\"0 0 0.6283\"");
  EXPECT_EQ(test::warnings(five_bar), std::vector<std::string>{});
}

// No link is added where another axis does.
TEST(ChainCorrection, IsTheAxisOfASlide) {
  for (const auto& [name, joint, axis, wrong] : {std::array{"delta_on_slides", "slide_z", "0 0 1", "1 0 0"},
                                                 {"delta_on_slides", "slide_x", "1 0 0", "0 1 0"},
                                                 {"y_z_slides", "slide_z", "0 0 1", "1 0 0"},
                                                 {"three_rrr_on_slides", "world_y", "0 1 0", "0 0 1"}}) {
    const std::string file = "test/data/chains/" + std::string(name);
    Description robot{test::source_file(file + ".urdf"), test::source_file(file + ".yaml")};
    const std::size_t at = robot.urdf.find("<axis", robot.urdf.find("<joint name=\"" + std::string(joint)));
    ASSERT_NE(at, std::string::npos);
    robot.urdf.replace(at, robot.urdf.find("/>", at) - at, "<axis xyz=\"" + std::string(wrong) + "\"");
    const std::string said = sentence(robot);
    EXPECT_TRUE(test::has(said, "write <axis xyz=\"" + std::string(axis) + "\"/> for joint '" + joint + "'"));
    EXPECT_FALSE(test::has(said, "<link name="));
    expect_remedies_work(robot, said);
  }
}

bool has_remedy(const std::string& said, const std::string& remedy) {
  const std::vector<std::string> all = test::remedies(said);
  return std::find(all.begin(), all.end(), remedy) != all.end();
}

// A frame of the platform of one leg that is turned or moved: what would do as well may be named beside it.
TEST(FrameCorrection, IsBesideThePatternOfTheOthers) {
  const std::string turned = "rpy=\"0 0 2.09439510239\" in the origin of joint 'platform_2_direction_joint'",
                    moved = "xyz=\"0.045 0.05 0\" in the origin of joint 'platform_2_left_joint'";
  for (const auto& [joint, origin, remedy] :
       {std::array<std::string, 3>{"platform_2_direction_joint", "rpy=\"0 0 2.5\"", turned},
        {"platform_2_direction_joint", "rpy=\"0 0 0\"", turned},
        {"platform_2_left_joint", "xyz=\"0.045 0.07 0\"", moved},
        {"platform_2_left_joint", "xyz=\"0.07 0.05 0\"", moved},
        {"platform_2_left_joint", "xyz=\"0.045 0.05 0.03\"", moved}}) {
    const Description robot = with_origin(joint, origin);
    const std::string said = sentence(robot);
    EXPECT_TRUE(has_remedy(said, "write " + remedy)) << said;
    expect_remedies_work(robot, said);
  }
}

// Where no single correction is known, the pair that is no parallelogram is, or that all are.
TEST(RodPairs, AreNamedWhereTheyLetThePlatformTurn) {
  Description robot = with_origin("platform_2_left_joint", "xyz=\"0.045 0.07 0\"");
  robot.urdf = with_origin_in(robot.urdf, "platform_3_right_joint", "xyz=\"0.06 -0.05 0\"");
  std::string said = sentence(robot);
  EXPECT_TRUE(test::begins(
      said,
      "robot.urdf lets the platform turn while it moves, since rods in pairs hold its orientation only where "
      "they are parallelograms: the rods from 'rod_2_left_pitch_joint' to 'platform_2_left - rod_2_left_tip' "
      "and from 'rod_2_right_pitch_joint' to 'platform_2_right - rod_2_right_tip' are 0.8 and 0.8 m long, "
      "and their ends 0.1 and 0.12 m apart; "));
  robot = with_origin("platform_2_direction_joint", "rpy=\"0 0 2.5\"");
  robot.urdf = with_origin_in(robot.urdf, "platform_3_direction_joint", "rpy=\"0 0 -1.7\"");
  said = sentence(robot);
  EXPECT_TRUE(test::has(said, "the pairs are parallelograms, but turned against each other"));
}

// Of one leg, of two, and all of two.
TEST(FrameCorrection, IsTwoClosuresThatAreCrossed) {
  for (const std::string other :
       {"rod_2_right_tip", "rod_3_left_tip", "rod_3_right_tip", "rod_1_right_tip"}) {
    Description robot = shipped_text("delta");
    robot.config = exchanged(robot.config, "rod_2_left_tip", other);
    const std::string said = sentence(robot);
    EXPECT_TRUE(test::begins(said, "robot.yaml has the ends of closure '"));
    EXPECT_EQ(test::remedies(said).size(), 2U) << said;
    expect_remedies_work(robot, said);
  }
  Description legs = shipped_text("delta");
  legs.config = exchanged(exchanged(legs.config, "rod_2_left_tip", "rod_3_left_tip"), "rod_2_right_tip",
                          "rod_3_right_tip");
  const std::string said = sentence(legs);
  EXPECT_TRUE(has_remedy(said,
                         "write link 'platform_3_right' in the place of 'platform_2_right' in closure "
                         "'platform_2_right - rod_3_right_tip'"))
      << said;
  expect_remedies_work(legs, said);
}

// A second stage before the piston of each of these legs.
Description with_telescopes(const std::string& legs) {
  Description robot = shipped_text("three_rpr");
  for (const char leg : legs) {
    const std::string drive = std::string("drive_") + leg, stage = std::string("stage_") + leg;
    const std::string above = "<parent link=\"" + drive + "\"/>\n    <child link=\"bar_" + leg + "\"/>";
    robot.change_urdf(above, replaced(above, drive, stage));
    robot.change_urdf("</robot>",
                      "<link name=\"" + stage + "\"/><joint name=\"" + stage +
                          "\" type=\"prismatic\"><parent link=\"" + drive + "\"/><child link=\"" + stage +
                          "\"/><axis xyz=\"1 0 0\"/><limit lower=\"0\" upper=\"2\"/></joint></robot>");
  }
  return robot;
}

TEST(JointCorrection, IsASecondSlideInSeries) {
  for (const std::string legs : {"1", "2", "123"}) {
    const Description robot = with_telescopes(legs);
    const std::string said = sentence(robot);
    std::vector<std::string> expected;
    for (const char leg : legs)
      expected.push_back(std::string("write type=\"fixed\" for joint 'stage_") + leg + "'");
    EXPECT_EQ(test::remedies(said), expected) << said;
    EXPECT_TRUE(test::has(said, "joint 'stage_" + legs.substr(0, 1) + "' in series with 'strut_" +
                                    legs.substr(0, 1) + "_joint'"));
    expect_remedies_work(robot, said);
  }
}

// At the base, at the start of a rod, and at a crank.
TEST(FrameCorrection, IsAClosureOfAnotherLinkOfAFiveBar) {
  for (const auto& [frames, wrong, right] :
       {std::array<std::string, 3>{"base_link, closing_2", "base_link", "tool"},
        {"tool, base_link", "base_link", "closing_2"},
        {"tool, rod_2", "rod_2", "closing_2"},
        {"rod_1, closing_2", "rod_1", "tool"},
        {"crank_1, closing_2", "crank_1", "tool"}}) {
    Description robot = shipped_text("five_bar");
    robot.change_config("[tool, closing_2]", "[" + frames + "]");
    const std::string said = sentence(robot);
    EXPECT_EQ(test::remedies(said),
              std::vector<std::string>{"write link '" + right + "' in the place of '" + wrong +
                                       "' in closure '" + replaced(frames, ",", " -") + "'"})
        << said;
    expect_remedies_work(robot, said);
  }
}

// It has no link of its own there, and no length of another rod is offered for it.
TEST(FrameCorrection, IsTheFarEndOfARod) {
  Description robot{test::source_file("test/data/chains/three_rrr_on_slides.urdf"),
                    test::source_file("test/data/chains/three_rrr_on_slides.yaml")};
  robot.change_config("{link: rod_2, xyz: [10, 0, 0]}", "rod_2");
  EXPECT_EQ(sentence(robot),
            "robot.urdf has joint 'elbow_2_joint' where closure 'platform - rod_2' holds link 'rod_2', at "
            "its origin, so that the rod between them has length zero; give the far end of the rod: write "
            "{link: rod_2, xyz: [X, Y, Z]} in the place of rod_2 in it, or the <pose> of a <gazebo><joint>.");
  robot.change_config("}, rod_2]", "}, {link: rod_2, xyz: [10, 0, 0]}]");
  EXPECT_EQ(test::refusal(robot), Problems{});
}

// Of slides and cranks that start on one.
TEST(Home, IsInsideTheLimits) {
  for (const std::string name : {"six_pus", "linear_delta", "stewart"}) {
    const auto mechanism = test::load(shipped_text(name));
    const AssembledConfiguration at = mechanism->assembled();
    for (std::size_t j = 0; j < mechanism->manipulator()->leg_count(); ++j) {
      const JointLimits& limits = mechanism->manipulator()->leg(j).limits;
      const double q = at.q[static_cast<Eigen::Index>(j)];
      EXPECT_GT(std::min(q - limits.lower, limits.upper - q), 1e-3) << name << " " << j;
    }
  }
}

// The same robot, by its legs.
TEST(Layers, DoNotMatter) {
  Description robot = shipped_text("five_bar");
  robot.change_urdf("<origin xyz=\"9 0 0\"/>", "<origin xyz=\"9 0 0.3\"/>");
  EXPECT_TRUE(
      has_note(robot,
               "robot.urdf has the frames of closure 'tool - closing_2' 0.3 m apart along the axes of its "
               "loop, which all are parallel; they are taken as layers of one planar mechanism."));
  const auto layered = test::load(robot), flat = test::load(shipped_text("five_bar"));
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_NEAR(layered->manipulator()->leg(j).rod_length, flat->manipulator()->leg(j).rod_length, 1e-9);
    EXPECT_NEAR((layered->manipulator()->leg(j).anchor - flat->manipulator()->leg(j).anchor).head<2>().norm(),
                0.0, 1e-9);
  }
  EXPECT_NEAR((layered->assembled().pose.position - flat->assembled().pose.position).norm(), 0.0, 1e-9);
  EXPECT_EQ(test::open_loops(*layered), 0);
}

TEST(Closures, CountOnce) {
  for (const std::string again : {"[tool, closing_2]", "[closing_2, tool]"}) {
    Description robot = shipped_text("five_bar");
    const std::string closure = "    - {frames: [tool, closing_2], type: revolute}\n";
    robot.change_config(closure, closure + "    - {frames: " + again + ", type: revolute}\n");
    const std::string name = again == "[tool, closing_2]" ? "tool - closing_2" : "closing_2 - tool";
    EXPECT_TRUE(has_note(
        robot, "robot.yaml lists closure '" + name + "' twice, which counts once; leave out one entry."));
  }
}

// Names that differ in small and capital letters alone are meant.
TEST(Names, InCapitalLettersAreFound) {
  Description robot = shipped_text("three_rrr");
  robot.change_config("crank_2_joint", "CRANK_2_JOINT");
  EXPECT_TRUE(test::has(sentence(robot), "has no such joint; did you mean 'crank_2_joint'?"));
}

TEST(LooseChains, AreNoted) {
  Description robot = shipped_text("five_bar");
  robot.change_urdf(
      "</robot>",
      "<link name=\"arm\"/>" + test::moving_joint("arm_joint", "base_link", "arm", "0 0 1") + "</robot>");
  EXPECT_TRUE(has_note(robot,
                       "robot.urdf has joints that no closure puts in a loop, which are no part of the robot "
                       "here: 'arm_joint'."));
}

}  // namespace
}  // namespace parallel_aspects
