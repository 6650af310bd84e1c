// SPDX-License-Identifier: BSD-3-Clause
// Each refusal names what is wrong, and the remedy that it names works to the letter.
#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/texts.h"
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace parallel_aspects {
namespace {

using test::Description;
using test::moving_joint;
using test::replaced;
using test::shipped_text;

Description faulty(const std::string& name) {
  return {test::source_file("test/data/faulty/" + name + ".urdf"),
          test::source_file("test/data/faulty/" + name + ".yaml")};
}

using test::refusal;

TEST(Diagnosis, IsAFourBar) {
  const std::string start = "robot.urdf is a linkage of one degree of freedom, as a four-bar, and its ";
  const std::string end =
      " is on neither; of those only a platform on a slide (T1) or on a hinge (R1) of the base, which one "
      "leg moves, is treated.";
  for (const std::string link : {"coupler", "tip"}) {
    Description four_bar = faulty("four_bar");
    four_bar.change_config("point: coupler", "point: " + link);
    EXPECT_EQ(refusal(four_bar), Problems{start + "operational_point '" + link + "'" + end});
    four_bar.change_config("[crank_joint]", "[crank_joint, rocker_joint]");
    EXPECT_EQ(refusal(four_bar), Problems{start + "operational_point '" + link + "'" + end});
  }
  for (const std::string link : {"rocker", "rocker_tip"}) {
    Description four_bar = faulty("four_bar");
    four_bar.change_config("point: coupler", "point: " + link);
    EXPECT_EQ(test::load(four_bar)->manipulator()->task_space(), TaskSpace::R1) << link;
  }
}

// Two legs of a five-bar hold a platform that can only slide; one alone would be a robot in T1.
TEST(Diagnosis, IsASliderThatTwoLegsHold) {
  Description robot = faulty("held_slider");
  test::expect_refusal(robot,
                       "robot.urdf joins the platform to the base by the chain of 'h0', without actuated "
                       "joint, which lets it move in 1 way only, while 2 joints are actuated; give the chain "
                       "the joints that it lacks, or hang the platform on a leg.");
  robot.change_config("[q1, q3]", "[q1]");
  test::expect_refusal(robot,
                       "robot.urdf is a linkage of one degree of freedom, whose operational_point 'stage' "
                       "moves on slide 'h0' and is held by several legs; of those only a platform on a slide "
                       "(T1) or on a hinge (R1) of the base, which one leg moves, is treated.");
  robot.change_config(", {type: revolute, frames: [stage, rodB_end]}", "");
  EXPECT_EQ(test::load(robot)->manipulator()->task_space(), TaskSpace::T1);
}

// Which may be meant, so that it loads.
TEST(Diagnosis, MayBeALinkThatTwoClosuresHold) {
  for (const std::string robot : {"stewart", "three_rpr", "spherical_3rrr"}) {
    Description description = shipped_text(robot);
    const auto about_links = [&] {
      std::vector<std::string> found;
      const auto loaded = test::load(description);
      for (const std::string& note : loaded->notes())
        if (note.find(" closures, and '") != std::string::npos) found.push_back(note);
      return found;
    };
    EXPECT_TRUE(about_links().empty()) << robot;
    const std::size_t start = description.config.find("{frames: [platform_3");
    ASSERT_NE(start, std::string::npos) << robot;
    description.config.replace(start, 20, "{frames: [platform_2");
    const std::string last = robot == "stewart"     ? "piston_3_tip"
                             : robot == "three_rpr" ? "bar_3_tip"
                                                    : "rod_3_tip";
    EXPECT_EQ(about_links(),
              std::vector<std::string>{"Link 'platform_2' is in two closures, and 'platform_3' of the same "
                                       "body in none; where each joint has its own link, write link "
                                       "'platform_3' in the place of 'platform_2' in closure 'platform_2 - " +
                                       last + "'."})
        << robot;
  }
}

// All four sides of a parallelogram move along circles, but for a moment along lines.
TEST(Diagnosis, IsAParallelogram) {
  Description four_bar = faulty("four_bar");
  four_bar.change_urdf("xyz=\"3.5 0 0\"", "xyz=\"3 0 0\"");
  four_bar.change_urdf("xyz=\"2 0 0\"", "xyz=\"1 0 0\"");
  const Problems problems = refusal(four_bar);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(test::begins(problems[0], "robot.urdf is a linkage of one degree of freedom, as a four-bar"));
}

// A crank on a slide is one, and its slider is a platform.
TEST(Diagnosis, IsTheOperationalPointOfASliderCrank) {
  Description slider = faulty("slider_crank");
  test::expect_refusal(slider,
                       "robot.yaml has operational_point 'rod', but the legs of robot.urdf meet in link "
                       "'slider'; write operational_point: slider, which makes it a robot in T1.");
  slider.change_config("operational_point: rod", "operational_point: slider");
  EXPECT_EQ(test::load(slider)->manipulator()->task_space(), TaskSpace::T1);
}

TEST(Diagnosis, IsAnOperationalPointBesideTheJointsOfAHub) {
  Description robot = faulty("hub");
  test::expect_refusal(robot,
                       "robot.yaml has operational_point 'camera', but the legs of robot.urdf meet in link "
                       "'hub'; write operational_point: hub, which makes it a robot in T2.");
  robot.change_config("operational_point: camera", "operational_point: hub");
  EXPECT_EQ(test::load(robot)->manipulator()->task_space(), TaskSpace::T2);
}

// On one hinge, by one strut.
TEST(Diagnosis, IsNotABoomThatAPistonTurns) {
  EXPECT_EQ(test::load(faulty("boom"))->manipulator()->task_space(), TaskSpace::R1);
}

TEST(Diagnosis, IsASerialArm) {
  test::expect_refusal(faulty("serial_arm"),
                       "robot.urdf is a serial arm, one chain of 3 joints from link 'base' to link 'c' "
                       "without a loop; only the "
                       "command `aspects` treats serial arms, with a YAML as `aspects setup` writes it.");
}

// A parallel robot is an open tree, too, until its loops are described.
TEST(Diagnosis, IsNoSerialArmWhereLoopsAreNotDescribed) {
  Description robot = shipped_text("five_bar");
  robot.change_config("  closures:\n    - {frames: [tool, closing_2], type: revolute}\n", "");
  test::expect_refusal(robot,
                       "robot.yaml has no mechanism.closures, and robot.urdf is an open tree without them; "
                       "list the frames that each loop holds together.");
}

// On a turntable, whose joint is actuated like the others.
Description on_turntable(Description robot, const std::string& base) {
  robot.change_urdf("</robot>",
                    "<link name=\"ground\"/>" + moving_joint("turn", "ground", base, "0 0 1") + "</robot>");
  robot.change_config("  base_link: " + base + "\n", "");
  return robot;
}

TEST(Diagnosis, IsATurntableBelowTheLoops) {
  Description robot = on_turntable(shipped_text("delta"), "base_link");
  test::expect_refusal(robot,
                       "robot.yaml has base_link 'ground', but joint 'turn' moves all loops of robot.urdf; "
                       "write base_link: base_link.");
  Description actuated = robot;
  actuated.config = replaced(robot.config, "[crank_1_joint, crank_2_joint, crank_3_joint]",
                             "[crank_1_joint, crank_2_joint, turn]");
  test::expect_refusal(
      actuated,
      "robot.yaml has base_link 'ground', but joint 'turn' moves all loops of robot.urdf; write base_link: "
      "base_link and actuated_joints: [crank_1_joint, crank_2_joint]; then robot.yaml does not list joint "
      "'crank_3_joint' in actuated_joints; write actuated_joints: [crank_1_joint, crank_2_joint, "
      "crank_3_joint], which makes it a robot in T3.");
  robot.change_config("mechanism:\n", "mechanism:\n  base_link: base_link\n");
  EXPECT_EQ(test::load(robot)->manipulator()->task_space(), TaskSpace::T3);
}

TEST(Diagnosis, IsAWristAfterThePlatform) {
  Description robot = shipped_text("three_rrr");
  robot.change_urdf("</robot>", "<link name=\"gripper\"/>" +
                                    moving_joint("wrist", "platform", "gripper", "0 0 1") + "</robot>");
  robot.change_config("operational_point: platform", "operational_point: gripper");
  test::expect_refusal(robot,
                       "robot.yaml has operational_point 'gripper', which joint 'wrist' moves against all "
                       "loops of robot.urdf; write operational_point: platform.");
}

TEST(Diagnosis, IsAnActuatedJointOutsideOfTheLoops) {
  Description robot = shipped_text("three_rrr");
  robot.change_urdf("</robot>", "<link name=\"fan\"/>" +
                                    moving_joint("fan_joint", "base_link", "fan", "0 0 1") + "</robot>");
  robot.change_config("crank_3_joint]", "fan_joint]");
  test::expect_refusal(robot,
                       "robot.yaml actuates joint 'fan_joint', which is in no loop of robot.urdf; write "
                       "actuated_joints: [crank_1_joint, crank_2_joint]; then robot.yaml does not list joint "
                       "'crank_3_joint' in actuated_joints; write actuated_joints: [crank_1_joint, "
                       "crank_2_joint, crank_3_joint], which makes it a robot in SE2.");
}

// The axis of one joint of a robot in the plane.
TEST(Diagnosis, IsATiltedAxis) {
  Description robot = shipped_text("five_bar");
  const std::string elbow = "<child link=\"rod_2\"/>\n    <origin xyz=\"5 0 0\"/>\n    ";
  robot.change_urdf(elbow + "<axis xyz=\"0 0 1\"/>", elbow + "<axis xyz=\"0.05 0 1\"/>");
  test::expect_refusal(robot,
                       "robot.urdf turns the axis of joint 'elbow_2_joint' 0.05 rad away from the direction "
                       "that the axes of the other joints share, so that the loops hold too much; write "
                       "<axis xyz=\"0 0 1\"/> for joint 'elbow_2_joint', which makes it a robot in T2.");
}

// A frame that is turned takes all with it that hangs on it.
TEST(Diagnosis, IsATiltedFrame) {
  Description robot = shipped_text("three_rrr");
  const std::size_t at = robot.urdf.find("<joint name=\"elbow_1_joint\"");
  ASSERT_NE(at, std::string::npos);
  const std::size_t origin = robot.urdf.find("/>", robot.urdf.find("<origin", at));
  robot.urdf.insert(origin, " rpy=\"0.04 0 0\"");
  test::expect_refusal(robot,
                       "robot.urdf turns the origin of joint 'elbow_1_joint' by rpy (0.04, 0, 0), where that "
                       "of other legs has (0, 0, 0); write rpy=\"0 0 0\" in the origin of joint "
                       "'elbow_1_joint', which makes it a robot in SE2.");
  robot.change_urdf(" rpy=\"0.04 0 0\"", " rpy=\"0 0 0\"");
  EXPECT_EQ(test::load(robot)->manipulator()->task_space(), TaskSpace::SE2);
}

TEST(Diagnosis, IsAnAxisThatMissesTheCentre) {
  Description robot = shipped_text("spherical_3rrr");
  const std::string elbow = "<child link=\"rod_1\"/>\n    <origin xyz=\"";
  robot.change_urdf(elbow + "0 0 0\"", elbow + "0.02 0 0\"");
  test::expect_refusal(robot,
                       "robot.urdf puts the origin of joint 'elbow_1_joint' at (0.02, 0, 0) m, where that of "
                       "other legs has (0, 0, 0) m; write xyz=\"0 0 0\" in the origin of joint "
                       "'elbow_1_joint', which makes it a robot in SO3.");
}

// Zero is stretched, and a limit of the elbows.
TEST(Assembly, IsNotTakenStretchedAtALimit) {
  for (const std::string robot : {"five_bar", "three_rrr"})
    for (const std::string limits : {"lower=\"0\" upper=\"2.9\"", "lower=\"-2.9\" upper=\"0\"",
                                     "lower=\"-0.001\" upper=\"2.9\"", "lower=\"0\" upper=\"0.8\""}) {
      Description description = shipped_text(robot);
      for (const std::string joint : {"elbow_1_joint", "elbow_2_joint"})
        description.change_urdf("<joint name=\"" + joint + "\" type=\"continuous\">",
                                "<joint name=\"" + joint + "\" type=\"revolute\"><limit " + limits + "/>");
      const auto mechanism = test::load(description);
      const AssembledConfiguration at = mechanism->assembled();
      Eigen::VectorXd joints(static_cast<Eigen::Index>(mechanism->joint_names().size()));
      ASSERT_TRUE(mechanism->complete(at.pose, at.q, joints));
      for (std::size_t k = 0; k < mechanism->joint_names().size(); ++k) {
        const JointLimits& range = mechanism->joint_limits()[k];
        const double value = joints[static_cast<Eigen::Index>(k)];
        if (!range.limited()) continue;
        EXPECT_GT(std::min(value - range.lower, range.upper - value), 1e-3)
            << robot << " " << limits << " " << mechanism->joint_names()[k];
        EXPECT_GT(std::abs(std::sin(value)), 0.02);
      }
    }
}

TEST(Diagnosis, IsAnActuatedJointThatIsLocked) {
  Description robot = shipped_text("five_bar");
  const std::string joint = "<joint name=\"crank_1_joint\" type=\"";
  robot.change_urdf(joint + "continuous\">", joint + "revolute\"><limit lower=\"1\" upper=\"1\"/>");
  const auto notes = test::load(robot)->notes();
  EXPECT_EQ(
      std::count(notes.begin(), notes.end(),
                 "robot.urdf lets actuated joint 'crank_1_joint' move by only 0 rad, which leaves next to "
                 "nothing for a map; widen its limits, or fix the joint and take it out of actuated_joints."),
      1);
}

struct Range {
  const char *lower, *upper;  // [rad]
};

struct Ranges {
  Range left_motor, right_motor, left_elbow, right_elbow;
};

void set_range(Description& robot, const std::string& joint, const Range& range) {
  const std::size_t from = robot.urdf.find("lower=", robot.urdf.find("<joint name=\"" + joint + "\""));
  robot.urdf.replace(from, robot.urdf.find(" effort", from) - from,
                     std::string("lower=\"") + range.lower + "\" upper=\"" + range.upper + "\"");
}

Description symmetric_five_bar(const Ranges& ranges) {
  Description robot = faulty("symmetric_five_bar");
  set_range(robot, "left_motor", ranges.left_motor);
  set_range(robot, "right_motor", ranges.right_motor);
  set_range(robot, "left_elbow", ranges.left_elbow);
  set_range(robot, "right_elbow", ranges.right_elbow);
  return robot;
}

// Zero is stretched, and on limits where a range begins there; some leave less than 1 % of the
// configurations.
TEST(Assembly, IsFoundWhereTheHomeConfigurationIsSingular) {
  const Range turn{"-3.14", "3.14"}, half{"-1.5708", "1.5708"}, left{"1.5708", "4.7124"},
      quarter{"0", "1.5708"}, up{"0", "3.1416"}, some_up{"0", "2.6"}, some_down{"-2.6", "0"},
      some{"-2.6", "2.6"};
  std::vector<Ranges> all{{half, quarter, some_down, some},
                          {quarter, quarter, some_down, up},
                          {left, half, up, some_up},
                          {left, quarter, up, some_up},
                          {left, quarter, some_up, up}};
  for (const char* most : {"6.28", "6.0"}) all.push_back({left, {"0", most}, some_up, turn});
  for (const char* most : {"6.28", "6.0", "3.1416"}) {
    const Range from_zero{"0", most};
    all.push_back({from_zero, turn, turn, turn});
    all.push_back({from_zero, half, up, up});
    all.push_back({from_zero, half, some_up, up});
  }
  for (const Ranges& ranges : all) {
    const Description robot = symmetric_five_bar(ranges);
    EXPECT_EQ(refusal(robot), Problems{}) << robot.urdf;
  }
}

// No configuration is within these ranges.
TEST(Assembly, IsSaidToBeImpossibleWhereItIs) {
  const Description robot =
      symmetric_five_bar({{"1.5708", "4.7124"}, {"0", "1.5708"}, {"0", "2.6"}, {"0", "2.6"}});
  const Problems problems = refusal(robot);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(test::begins(problems[0],
                           "robot.urdf cannot be closed as robot.yaml asks: the frames of closure 'tool - "
                           "right_end' come no nearer than "));
}

TEST(Assembly, IsFoundOfASliderInLineWithItsCrank) {
  for (const char* beside : {"0 0 0", "0 0.0001 0", "0 0.01 0"}) {
    Description slider = faulty("in_line_slider");
    slider.change_urdf("<origin xyz=\"0 0 0\"/>", std::string("<origin xyz=\"") + beside + "\"/>");
    const auto mechanism = test::load(slider);
    EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T1) << beside;
    EXPECT_LT(mechanism->assembled().pose.position.x(), 0.55) << beside;  // stretched at 0.6
  }
}

// An axis that is not along those of the joints, where it is open which of them are actuated.
TEST(Diagnosis, IsARevoluteClosureWhereBallsFit) {
  Description robot = shipped_text("five_bar");
  robot.config =
      "mechanism:\n  operational_point: tool\n  closures:\n    - {frames: [{link: tool, rpy: [1.5707963, 0, "
      "0]}, {link: closing_2, rpy: [1.5707963, 0, 0]}], type: revolute}\n";
  std::string drives;
  for (const char* joint : {"crank_1_joint", "elbow_1_joint", "crank_2_joint", "elbow_2_joint"})
    drives +=
        std::string("<transmission name=\"of_") + joint + "\"><joint name=\"" + joint + "\"/></transmission>";
  robot.change_urdf("</robot>", drives + "</robot>");
  test::expect_refusal(
      robot,
      "robot.yaml closes loops of robot.urdf by types that leave it one degree of freedom, as their axes are "
      "not along those of its joints; write type: point for 'tool - closing_2', which leaves it 2.");
  robot.change_config("type: revolute", "type: point");
  const Problems next = refusal(robot);
  ASSERT_EQ(next.size(), 1U);
  EXPECT_TRUE(test::has(next[0], "the mobility fits [crank_1_joint, crank_2_joint] and"));
}

// Whatever ends are exchanged, that is no mistake of the description.
TEST(Diagnosis, IsAPlatformThatNoPoseHolds) {
  test::expect_refusal(
      faulty("singular_hexapod"),
      "robot.urdf is assembled, but singular in every pose: det A is zero to rounding in all 12 random poses "
      "that were tried, so that its actuated joints never hold operational_point 'plate'; change the places "
      "of the joints on base or platform, which are, for instance, two similar hexagons joined corner to "
      "corner, or struts that stay parallel.");
}

// Of the closures with an axis in the frame of the model.
std::string with_axes_of_links(std::string urdf, const std::vector<std::string>& links) {
  const std::string stated = "<xyz>0 0 1</xyz><use_parent_model_frame>1</use_parent_model_frame>";
  for (const std::string& link : links)
    urdf.replace(urdf.find(stated), stated.size(), "<xyz expressed_in=\"" + link + "\">0 0 1</xyz>");
  return urdf;
}

// A mistake in one leg is made in every leg, and in none that has no such closure.
TEST(Diagnosis, IsTheFrameOfTheAxesOfLikeClosures) {
  Description robot = faulty("upright_three_rrr");
  test::expect_refusal(
      robot,
      "robot.urdf states axes for 'wrist_2', 'wrist_3' about which their links do not turn; write <axis><xyz "
      "expressed_in=\"lower_2\">0 0 1</xyz></axis> for 'wrist_2', <axis><xyz expressed_in=\"lower_3\">0 0 "
      "1</xyz></axis> for 'wrist_3', which makes it a robot in SE2.");
  const std::string both = robot.urdf;
  robot.urdf = with_axes_of_links(both, {"lower_2"});
  test::expect_refusal(
      robot,
      "robot.urdf states axes for 'wrist_3' about which their links do not turn; write <axis><xyz "
      "expressed_in=\"lower_3\">0 0 1</xyz></axis> for 'wrist_3', which makes it a robot in SE2.");
  robot.urdf = with_axes_of_links(both, {"lower_2", "lower_3"});
  EXPECT_EQ(test::load(robot)->manipulator()->task_space(), TaskSpace::SE2);
  Description delta = faulty("delta_of_parallelograms");
  const Problems said = refusal(delta);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(
      test::begins(said[0], "robot.urdf states axes for 'close_1', 'close_2', 'close_3' about which"));
  delta.urdf = with_axes_of_links(delta.urdf, {"foot_1", "foot_2", "foot_3"});
  EXPECT_EQ(test::load(delta)->manipulator()->task_space(), TaskSpace::T3);
}

}  // namespace
}  // namespace parallel_aspects
