// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/loops.h"
#include "support/robots/shipped.h"
#include <cmath>

namespace parallel_aspects {
namespace {

const std::string listed_joints = "mechanism: {operational_point: tip_1, actuated_joints: [mot_1, mot_2]}\n";

std::string closed_by(const std::string& closure) {
  return test::replaced(test::source_file("test/data/closed_five_bar.urdf"), "<!-- closure -->", closure);
}

void expect_five_bar(const Mechanism& mechanism) {
  ASSERT_EQ(mechanism.manipulator()->task_space(), TaskSpace::T2);
  for (const Leg& leg : mechanism.manipulator()->legs()) {
    EXPECT_NEAR(std::get<RevoluteActuation>(leg.actuation).radius, 3.0, 1e-9);
    EXPECT_NEAR(leg.rod_length, std::sqrt(8.0), 1e-9);
  }
  EXPECT_EQ(test::open_loops(mechanism), 0);
}

struct Dialect {
  std::string name;
  std::string urdf;
  std::string config;
  std::string note;
};

void PrintTo(const Dialect& dialect, std::ostream* stream) { *stream << dialect.name; }

class ClosureDialect : public ::testing::TestWithParam<Dialect> {};

TEST_P(ClosureDialect, ClosesTheFiveBar) {
  const auto mechanism = test::load(closed_by(GetParam().urdf), GetParam().config);
  expect_five_bar(*mechanism);
  ASSERT_FALSE(mechanism->notes().empty());
  EXPECT_EQ(mechanism->notes().front(), GetParam().note);
}

INSTANTIATE_TEST_SUITE_P(
    All, ClosureDialect,
    ::testing::Values(
        Dialect{"GazeboRevolute",
                R"(<gazebo><joint name="loop" type="revolute"><parent>rod_1</parent><child>rod_2</child>
                   <pose>-2 2 0 0 0 0</pose><axis><xyz>0 0 1</xyz></axis></joint></gazebo>)",
                listed_joints, "The closures are those that <gazebo><joint> describes, 1 in all."},
        Dialect{
            "GazeboBall",
            R"(<gazebo><joint name="loop" type="ball"><parent>robot::tip_1</parent><child>tip_2</child></joint>
                   </gazebo>)",
            listed_joints, "The closures are those that <gazebo><joint> describes, 1 in all."},
        // Tip 2 is turned against the plane, so that neither pose nor axis would fit in its own frame.
        Dialect{"GazeboWithFramesOfSdf",
                R"(<gazebo><joint name="loop" type="revolute"><parent>rod_1</parent><child>tip_2</child>
                   <pose relative_to="rod_2">-2 2 0 0.5 0.6 0.7</pose><axis><xyz>0 0 1</xyz>
                   <use_parent_model_frame>1</use_parent_model_frame></axis></joint></gazebo>)",
                listed_joints, "The closures are those that <gazebo><joint> describes, 1 in all."},
        Dialect{"GazeboAxisOfTheModel",
                R"(<gazebo><joint name="loop" type="revolute"><parent>rod_1</parent><child>tip_2</child>
                   <axis><xyz expressed_in="__model__">0 0 -1</xyz></axis></joint></gazebo>)",
                listed_joints, "The closures are those that <gazebo><joint> describes, 1 in all."},
        Dialect{"GazeboHoldsTheBaseToo",
                R"(<gazebo><joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>
                   <joint name="loop" type="ball"><parent>tip_1</parent><child>tip_2</child></joint></gazebo>)",
                listed_joints, "The closures are those that <gazebo><joint> describes, 1 in all."},
        Dialect{"GazeboHoldsTheBaseAlone",
                R"(<gazebo><joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>
                   </gazebo><loop_joint name="loop" type="spherical"><link1 link="rod_1" xyz="2 2 0"/>
                   <link2 link="rod_2" xyz="-2 2 0"/></loop_joint>)",
                listed_joints, "The closures are those that <loop_joint> describes, 1 in all."},
        Dialect{"ClosingFrames",
                R"(<link name="closing_tip_1"/><link name="closing_tip_2"/>
                   <joint name="c1" type="fixed"><parent link="tip_1"/><child link="closing_tip_1"/></joint>
                   <joint name="c2" type="fixed"><parent link="tip_2"/><child link="closing_tip_2"/></joint>)",
                listed_joints, "The closures are those that closing frames describes, 1 in all."},
        Dialect{"ClosingFramesByLetter",
                R"(<link name="closing_tip_A"/><link name="closing_tip_B"/>
                   <joint name="c1" type="fixed"><parent link="tip_1"/><child link="closing_tip_B"/></joint>
                   <joint name="c2" type="fixed"><parent link="tip_2"/><child link="closing_tip_A"/></joint>)",
                listed_joints, "The closures are those that closing frames describes, 1 in all."},
        Dialect{"GepettoFile", "",
                "closed_loop: [[tip_1, tip_2_joint]]\ntype: [3d]\nname_mot: mot\n"
                "mechanism: {operational_point: tip_1}\n",
                "The closures are those that closed_loop describes, 1 in all."},
        Dialect{"GepettoFileWithListOfMotors", "",
                "closed_loop: [['tip_2', 'tip_1']]\ntype: ['3d']\nname_mot: ['mot_1', 'mot_2']\n"
                "joint_name: []\njoint_type: []\nmechanism: {operational_point: tip_1}\n",
                "The closures are those that closed_loop describes, 1 in all."},
        Dialect{
            "Constraint",
            R"(<constraint name="loop" type="spherical_joint"><parent link="rod_1"/><parent_origin xyz="2 2 0"/>
                   <child link="rod_2"/><child_origin xyz="-2 2 0" rpy="1 2 3"/></constraint>)",
            listed_joints, "The closures are those that <constraint> describes, 1 in all."},
        Dialect{
            "ConstraintWithAxes",
            R"(<constraint name="loop" type="revolute_joint"><parent link="rod_1"/><parent_origin xyz="2 2 0"/>
                   <parent_axis xyz="0 0 1"/><child link="rod_2"/><child_origin xyz="-2 2 0" rpy="1.570796326794897 0 0"/>
                   <child_axis xyz="0 1 0"/></constraint>)",
            listed_joints, "The closures are those that <constraint> describes, 1 in all."},
        Dialect{
            "DetachableJoint",
            R"(<gazebo><plugin filename="x" name="gz::sim::systems::DetachableJoint"><parent_link>tip_1</parent_link>
                   <child_model>robot</child_model><child_link>tip_2</child_link></plugin></gazebo>)",
            listed_joints, "The closures are those that DetachableJoint describes, 1 in all."},
        Dialect{"DetachableJointBesideAGripper",
                R"(<gazebo><plugin filename="gz-sim-detachable-joint-system" name="a::DetachableJoint">
                   <parent_link>tip_1</parent_link><child_model>pickup_box</child_model><child_link>link</child_link>
                   </plugin><plugin filename="libgz-sim-detachable-joint-system.so" name="b"><parent_link>tip_1
                   </parent_link><child_model>spawned_as_this</child_model><child_link>tip_2</child_link></plugin>
                   </gazebo>)",
                listed_joints, "The closures are those that DetachableJoint describes, 1 in all."},
        Dialect{"LoopJointWithType",
                R"(<loop_joint name="loop" type="spherical"><link1 link="rod_1" rpy="0 0 0" xyz="2 2 0"/>
                   <link2 link="rod_2" rpy="0 0 0" xyz="-2 2 0"/></loop_joint>)",
                listed_joints, "The closures are those that <loop_joint> describes, 1 in all."},
        Dialect{"LoopJointAsTheManualOfIsaacSimHasIt",
                R"(<loop_joint name="loop" type="spherical"><link1 link="rod_1" rpy="0 0 0" xyz="2 2 0"/>
                   <link1 link="rod_2" rpy="0 0 0" xyz="-2 2 0"/></loop_joint>)",
                listed_joints, "The closures are those that <loop_joint> describes, 1 in all."},
        Dialect{"LoopJointWithParentAndChild",
                R"(<loop_joint name="loop" type="revolute"><parent link="rod_1"/><child link="tip_2"/>
                   <parent_origin xyz="2 2 0"/><child_origin xyz="0 0 0"/><axis xyz="0 0 1" frame="parent"/>
                   </loop_joint>)",
                listed_joints, "The closures are those that <loop_joint> describes, 1 in all."},
        Dialect{"LoopJointWithAxis",
                R"(<loop_joint name="loop"><link1 link="rod_1" xyz="2 2 0"/><link2 link="rod_2" xyz="-2 2 0"/>
                   <axis xyz="0 0 1"/></loop_joint>)",
                listed_joints, "The closures are those that <loop_joint> describes, 1 in all."},
        Dialect{"DrakeBallConstraint",
                R"(<drake:ball_constraint><drake:ball_constraint_body_A name="rod_1"/>
                   <drake:ball_constraint_body_B name="rod_2"/><drake:ball_constraint_p_AP value="2 2 0"/>
                   <drake:ball_constraint_p_BQ value="-2 2 0"/></drake:ball_constraint>)",
                listed_joints, "The closures are those that <drake:ball_constraint> describes, 1 in all."},
        Dialect{"OfAnMjcf",
                R"(<loop_closure name="loop" in="&lt;equality&gt;" type="ball">
                   <end link="rod_1" xyz="2 2 0"/><end link="rod_2" xyz="-2 2 0"/></loop_closure>)",
                listed_joints, "The closures are those that <equality> describes, 1 in all."},
        Dialect{"OfAnSdf",
                R"(<loop_closure name="loop" in="the SDF" type="revolute">
                   <end link="rod_1" xyz="2 2 0"/><end link="rod_2" xyz="-2 2 0"/></loop_closure>)",
                listed_joints, "The closures are those that the SDF describes, 1 in all."},
        Dialect{"LoopClosuresFile", "",
                "closures: [{link_a: rod_1, link_b: rod_2, point: [2, 5, 0], axis: [0, 0, 1]}]\n"
                "dependent: [elbow_1, elbow_2]\nindependent: [mot_1, mot_2]\n"
                "mechanism: {operational_point: tip_1}\n",
                "The closures are those that loop_closures.yaml describes, 1 in all."},
        Dialect{"LoopClosuresFileWithDependentJointsAlone", "",
                "closures: [{link_a: rod_2, link_b: tip_1, point: [2.0, 5.0, 0.0]}]\n"
                "dependent: [elbow_1, elbow_2]\nmechanism: {operational_point: tip_1}\n",
                "The closures are those that loop_closures.yaml describes, 1 in all."}),
    [](const ::testing::TestParamInfo<Dialect>& tested) { return tested.param.name; });

TEST(ClosureDialects, AreOverruledByTheList) {
  const auto mechanism = test::load(
      closed_by(
          R"(<loop_joint name="wrong" type="spherical"><link1 link="rod_1"/><link2 link="rod_2"/></loop_joint>)"),
      "mechanism: {operational_point: tip_1, actuated_joints: [mot_1, mot_2], closures: [{frames: [tip_1, "
      "tip_2]}]}");
  expect_five_bar(*mechanism);
  ASSERT_EQ(mechanism->notes().size(), 1u);
  EXPECT_EQ(mechanism->notes().front(),
            "robot.yaml leaves the type of closures open; they are taken as point, under which the mobility "
            "is the number of actuated joints.");
}

TEST(ClosureDialects, LeaveTheDrivesToTransmissions) {
  const auto mechanism =
      test::load(closed_by(R"(<transmission name="a"><joint name="mot_2"/></transmission>
                   <transmission name="b"><joint name="mot_1"/></transmission>)"),
                 "mechanism: {operational_point: tip_1, closures: [{frames: [tip_1, tip_2], type: point}]}");
  expect_five_bar(*mechanism);
  EXPECT_EQ(mechanism->manipulator()->leg(0).actuated_joint, "mot_2");
  EXPECT_EQ(mechanism->notes().front(),
            "The actuated joints are those that have a <transmission> in robot.urdf: 'mot_2', 'mot_1'.");
}

struct BadDialect {
  std::string urdf;
  std::string config;
  std::string message;
};

void PrintTo(const BadDialect& bad, std::ostream* stream) { *stream << bad.message; }

class BadClosureDialect : public ::testing::TestWithParam<BadDialect> {};

TEST_P(BadClosureDialect, IsRefused) {
  const Problems expected{GetParam().message};
  EXPECT_EQ(test::refusal(closed_by(GetParam().urdf), GetParam().config), expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadClosureDialect,
    ::testing::Values(
        BadDialect{"", "closures: [{link_a: rod_1, link_b: rod_9, point: [2, 5, 0]}]\n" + listed_joints,
                   "robot.yaml in closures[0] names link 'rod_9', but robot.urdf has no such link; did you "
                   "mean 'rod_1'?"},
        BadDialect{"", "closures: [{link_a: rod_1, link_b: rod_2, point: [2, 5]}]\n" + listed_joints,
                   "robot.yaml in closures[0] has a point or an axis that is not three finite numbers, or "
                   "zero; write three each, in the frame of the root link while all joints are zero."},
        BadDialect{"", "closures: [rod_1]\ndependent: []\n" + listed_joints,
                   "robot.yaml in closures[0] is no map; write {link_a: LINK, link_b: LINK, point: [x, y, "
                   "z], axis: [x, y, z]}."},
        BadDialect{
            R"(<loop_closure in="the SDF" type="ball"><end link="rod_1" xyz="0 0"/><end link="rod_2"/>
                   </loop_closure>)",
            listed_joints,
            "robot.urdf has a <loop_closure> '' without a type or two ends; use <loop_joint> in its place."},
        BadDialect{
            R"(<gazebo><joint name="loop" type="ball"><parent>rod_1</parent><child>rod_3</child></joint></gazebo>)",
            listed_joints,
            "robot.urdf has a <gazebo> joint 'loop' that names link 'rod_3', but robot.urdf has no such "
            "link; did you mean 'rod_1'?"},
        BadDialect{
            R"(<gazebo><joint name="loop" type="screw"><parent>tip_1</parent><child>tip_2</child></joint></gazebo>)",
            listed_joints,
            "robot.urdf has a <gazebo> joint 'loop' that has the type 'screw', which cannot close a loop; "
            "use revolute, ball, universal or fixed."},
        BadDialect{
            R"(<gazebo><joint name="loop" type="ball"><parent>tip_1</parent><child>tip_2</child>
                      <pose>0 0 nan</pose></joint></gazebo>)",
            listed_joints,
            "robot.urdf has a <gazebo> joint 'loop' that has a pose that is not a list of finite numbers; "
            "give six, or leave it out for zeros."},
        BadDialect{
            R"(<gazebo><joint name="loop" type="revolute"><parent>tip_1</parent><child>tip_2</child>
                      <axis><xyz>0 0 0</xyz></axis></joint></gazebo>)",
            listed_joints,
            "robot.urdf has a <gazebo> joint 'loop' that has an <axis> that is not three finite numbers, or "
            "zero; give the direction of the joint."},
        BadDialect{
            R"(<gazebo><joint name="loop" type="ball"><parent>tip_1</parent><child>tip_2</child>
                      <pose relative_to="tip_3">0 0 0 0 0 0</pose></joint></gazebo>)",
            listed_joints,
            "robot.urdf has a <gazebo> joint 'loop' that names link 'tip_3', but robot.urdf has no such "
            "link; did you mean 'tip_1'?"},
        BadDialect{
            R"(<loop_joint name="loop" type="prismatic"><link1 link="tip_1"/><link2 link="tip_2"/>
                      </loop_joint>)",
            listed_joints,
            "robot.urdf has a <loop_joint> 'loop' that has a type or an axis that cannot close a loop; use "
            "spherical, revolute, universal or fixed, and an axis of three numbers."},
        BadDialect{
            R"(<constraint name="loop" type="planar_joint"><parent link="tip_1"/><child link="tip_2"/>
                      </constraint>)",
            listed_joints,
            "robot.urdf has a <constraint> 'loop' that has the type 'planar_joint', which cannot close a "
            "loop; use spherical_joint, revolute_joint, universal_joint or fixed_joint."},
        BadDialect{
            R"(<drake:ball_constraint><drake:ball_constraint_body_A name="tip_1"/>
                      <drake:ball_constraint_body_B name="tip_2"/><drake:ball_constraint_p_AP value="0 0"/>
                      <drake:ball_constraint_p_BQ value="0 0 0"/></drake:ball_constraint>)",
            listed_joints,
            "robot.urdf has a <drake:ball_constraint> that has a drake:ball_constraint_p_AP that is not "
            "three finite numbers; write three."},
        BadDialect{R"(<gazebo><plugin filename="x" name="DetachableJoint"><parent_link>tip_1</parent_link>
                      <child_model>closed_five_bar</child_model><child_link>tip_3</child_link></plugin></gazebo>)",
                   listed_joints,
                   "robot.urdf has a DetachableJoint plugin that names link 'tip_3', but robot.urdf has no "
                   "such link; did you mean 'tip_1'?"},
        BadDialect{
            R"(<link name="closing_tip_1"/>
                      <joint name="c1" type="fixed"><parent link="tip_1"/><child link="closing_tip_1"/></joint>)",
            listed_joints,
            "robot.urdf has the closing frame 'closing_tip_1' but no 'closing_tip_2'; add it, or list the "
            "closures in robot.yaml."},
        BadDialect{"", "closed_loop: [[tip_1]]\n" + listed_joints,
                   "robot.yaml has a closed_loop[0] that is not a pair; name two links or joints."},
        BadDialect{"",
                   "closed_loop: [[tip_1, tip_2]]\nname_mot: [mot_1, motor]\n"
                   "mechanism: {operational_point: tip_1}\n",
                   "robot.yaml has 'motor' in name_mot, but robot.urdf has no movable joint with that in its "
                   "name; correct it, or list mechanism.actuated_joints."},
        BadDialect{
            "",
            "closed_loop: [[tip_1, tip_2]]\njoint_name: [elbow_1]\njoint_type: [SPHERICAL]\n" + listed_joints,
            "robot.yaml replaces joint 'elbow_1' by a joint of another type in joint_name, which is not "
            "read; write two or three revolute joints in its place into robot.urdf."},
        BadDialect{
            R"(<transmission name="a"><joint name="mot_1"/></transmission>
                      <transmission name="b"><joint name="mot_3"/></transmission>)",
            "mechanism: {operational_point: tip_1, closures: [{frames: [tip_1, tip_2]}]}",
            "robot.urdf actuates joint 'mot_3' in a <transmission>, but robot.urdf has no such joint; did "
            "you mean 'mot_2'?"},
        BadDialect{"", "closed_loop: [[tip_1, tip_2]]\ntype: 4d\n" + listed_joints,
                   "robot.yaml gives closed_loop[0] the type '4d'; write 3d or 6d for each, or leave out the "
                   "types."},
        BadDialect{R"(<transmission name="a"><joint name="mot_1"/></transmission>)",
                   "mechanism: {operational_point: tip_1, closures: [{frames: [tip_1, tip_2], type: point}]}",
                   "robot.yaml actuates none of the joints 'mot_2', 'elbow_2', which make one leg; add one "
                   "of them to actuated_joints, or take the leg out of the URDF."},
        BadDialect{R"(<transmission name="a"><joint name="mot_1"/><joint name="mot_2"/></transmission>
                      <transmission name="b"><joint name="elbow_1"/><joint name="elbow_2"/></transmission>)",
                   "mechanism: {operational_point: tip_1, closures: [{frames: [tip_1, tip_2]}]}",
                   "robot.yaml does not say mechanism.actuated_joints, and 4 joints have a <transmission> in "
                   "robot.urdf, 'mot_1', 'mot_2', 'elbow_1', 'elbow_2'; the mobility fits [mot_1, mot_2] and "
                   "[elbow_1, elbow_2], so list those that are actuated."}));

}  // namespace
}  // namespace parallel_aspects
