// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/descriptions.h"

// Robots that cannot be treated, each with the message that says why.
namespace parallel_aspects {
namespace {

using test::Description;
using test::fixed_joint;
using test::moving_joint;
using test::shipped_text;

// The same with the first crank's rod actuated at its elbow, and a point beside the ball.
TEST(RefusedMechanism, HasItsOperationalPointBesideTheBallOfADrivenElbow) {
  Description five_bar = test::five_bar_with_still_joints();
  five_bar.change_urdf("</robot>", "<link name=\"camera\"/>" +
                                       fixed_joint("ball_3", "camera", "xyz=\"0.1 0 0\"") + "</robot>");
  five_bar.change_config("operational_point: tool", "operational_point: camera");
  five_bar.change_config("[crank_1_joint, crank_2_joint]", "[elbow_1_joint, crank_2_joint]");
  test::expect_refusal(five_bar,
                       "robot.yaml has operational_point 'camera', but the legs of robot.urdf meet in link "
                       "'ball_3'; write operational_point: ball_3, which makes it a robot in T2.");
}

TEST(RefusedMechanism, DrivesAJointThatMimicsAnother) {
  Description five_bar = shipped_text("five_bar");
  five_bar.change_urdf("<joint name=\"crank_2_joint\" type=\"continuous\">",
                       "<joint name=\"crank_2_joint\" type=\"continuous\"><mimic joint=\"crank_1_joint\"/>");
  test::expect_refusal(five_bar,
                       "robot.yaml names joint 'crank_2_joint' in mechanism.actuated_joints, but robot.urdf "
                       "lets that joint mimic another; actuate the other one, or take out the <mimic>.");
}

// All axes are parallel, so that nothing can leave the plane, whatever the robot is called.
TEST(RefusedMechanism, IsPlanarThoughItIsCalledADelta) {
  Description robot = shipped_text("three_rrr");
  robot.change_urdf("<robot name=\"three_rrr\"", "<robot name=\"delta\"");
  robot.change_config("name: three_rrr", "name: delta");
  EXPECT_EQ(test::load(robot)->manipulator()->task_space(), TaskSpace::SE2);
  robot.change_config("task_space: SE2", "task_space: T3");
  test::expect_refusal(robot,
                       "robot.yaml states mechanism.task_space T3, but the platform moves in SE2; correct it "
                       "or leave it out.");
}

// An arm of three revolute joints, orthogonal and apart, that holds the point (0, 0, 0) when it is at zero.
std::string three_revolute_arm(const std::string& leg, const std::string& yaw) {
  return "<link name=\"foot" + leg + "\"/><link name=\"a" + leg + "\"/><link name=\"b" + leg +
         "\"/><link name=\"c" + leg + "\"/><link name=\"tip" + leg + "\"/>" +
         fixed_joint("base", "foot" + leg, "rpy=\"0 0 " + yaw + "\"") +
         moving_joint("motor" + leg, "foot" + leg, "a" + leg, "0 0 1", "xyz=\"2 0.3 -0.4\"") +
         moving_joint("shoulder" + leg, "a" + leg, "b" + leg, "0 1 0", "xyz=\"-0.5 0.2 0.1\"") +
         moving_joint("elbow" + leg, "b" + leg, "c" + leg, "1 0 0", "xyz=\"-0.7 0 0.6\"") +
         fixed_joint("c" + leg, "tip" + leg, "xyz=\"-0.8 -0.5 -0.3\"");
}

TEST(RefusedMechanism, HasCuspidalLegs) {
  EXPECT_EQ(
      test::refusal("<robot name=\"arms\"><link name=\"base\"/>" + three_revolute_arm("1", "0") +
                        three_revolute_arm("2", "2.1") + three_revolute_arm("3", "-2.1") + "</robot>",
                    "mechanism: {operational_point: tip1, actuated_joints: [motor1, motor2, motor3], "
                    "closures: [{frames: [tip1, tip2], type: point}, {frames: [tip1, tip3], type: point}]}"),
      Problems{"robot.urdf has 3 legs, as that through 'motor1', 'shoulder1', 'elbow1', each of which is an "
               "arm of three revolute joints whose passive axes do not meet: such a leg is in general "
               "cuspidal, it can change its posture without a serial singularity, and working modes separate "
               "the inverse solutions only if no leg is cuspidal (Chablat and Wenger, theorem 1); they are "
               "no distance legs and cannot be treated."});
}

// B would not be diagonal: both actuated joints move a point of the rod that is not its end.
TEST(RefusedMechanism, HasItsOperationalPointInsideARod) {
  Description five_bar = shipped_text("five_bar");
  five_bar.change_urdf(
      "</robot>", "<link name=\"camera\"/>" + fixed_joint("rod_1", "camera", "xyz=\"2 0.5 0\"") + "</robot>");
  five_bar.change_config("operational_point: tool", "operational_point: camera");
  test::expect_refusal(five_bar,
                       "robot.yaml has operational_point 'camera', but the legs of robot.urdf meet in link "
                       "'tool'; write operational_point: tool, which makes it a robot in T2.");
}

// Three legs in one place can neither hold nor move a platform.
TEST(RefusedMechanism, HasItsLegsStackedInOnePlace) {
  Description robot = shipped_text("delta");
  robot.change_urdf("rpy=\"0 0 2.0943951023931953\"", "rpy=\"0 0 0\"");
  robot.change_urdf("rpy=\"0 0 -2.0943951023931953\"", "rpy=\"0 0 0\"");
  test::expect_refusal(
      robot,
      "robot.yaml actuates 'crank_1_joint', 'crank_2_joint', 'crank_3_joint', but the closed mechanism of "
      "robot.urdf has mobility 4, and the platform still moves with the actuated joints locked; list more "
      "actuated_joints, or correct closures that hold too little.");
}

TEST(RefusedMechanism, HasALegWithoutDrive) {
  Description robot = shipped_text("three_rrr");
  robot.change_config("[crank_1_joint, crank_2_joint, crank_3_joint]", "[crank_1_joint, crank_2_joint]");
  robot.change_config("task_space: SE2", "task_space: T2");
  test::expect_refusal(robot,
                       "robot.yaml actuates none of the joints 'crank_3_joint', 'elbow_3_joint', which make "
                       "one leg; add one of them to actuated_joints, or take the leg out of the URDF.");
}

TEST(RefusedMechanism, HasAStrutThatMissesItsEnds) {
  Description robot = shipped_text("bipod");
  robot.change_urdf("<child link=\"bar_2\"/>\n    <origin xyz=\"0 0 0\"/>",
                    "<child link=\"bar_2\"/>\n    <origin xyz=\"0 0.5 0\"/>");
  test::expect_refusal(robot,
                       "robot.urdf has a leg through 'pivot_2_joint', 'strut_2_joint', 'tool - bar_2_tip' "
                       "that is a strut whose slide does not point from one end joint to the other; it is "
                       "not a distance leg and cannot be treated.");
}

TEST(RefusedMechanism, HasUnequalParallelRods) {
  Description robot = shipped_text("delta");
  robot.change_urdf("<child link=\"rod_2_left_tip\"/>\n    <origin xyz=\"0 0 -0.8\"/>",
                    "<child link=\"rod_2_left_tip\"/>\n    <origin xyz=\"0 0 -0.7\"/>");
  EXPECT_FALSE(test::refusal(robot).empty());
}

}  // namespace
}  // namespace parallel_aspects
