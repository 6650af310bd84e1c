// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/setup.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include "support/texts.h"
#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

// What a URDF leaves open: which joints are actuated, and how links that it welds move.
namespace parallel_aspects {
namespace {

using test::Description;
using test::replaced;
using test::shipped_text;

std::string transmission(const std::string& joint,
                         const std::string& interface = "hardware_interface/EffortJointInterface") {
  return "<transmission name=\"of_" + joint +
         "\"><type>transmission_interface/SimpleTransmission</type><joint name=\"" + joint +
         "\"><hardwareInterface>" + interface + "</hardwareInterface></joint></transmission>";
}

std::string commanded(const std::string& joint) {
  return "<joint name=\"" + joint +
         "\"><command_interface name=\"position\"/><state_interface name=\"position\"/></joint>";
}

std::string reported(const std::string& joint) {
  return "<joint name=\"" + joint + "\"><state_interface name=\"position\"/></joint>";
}

// A shipped robot whose YAML does not list the actuated joints.
Description without_list(const std::string& robot, const std::string& urdf_end) {
  Description text = shipped_text(robot);
  text.change_urdf("</robot>", urdf_end + "</robot>");
  text.config = std::regex_replace(text.config, std::regex("  actuated_joints:[^\n]*\n"), "");
  return text;
}

std::vector<std::string> actuated_joints(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const Leg& leg : mechanism.manipulator()->legs()) names.push_back(leg.actuated_joint);
  return names;
}

bool has_note(const Mechanism& mechanism, const std::string& note) {
  const auto& notes = mechanism.notes();
  return std::find(notes.begin(), notes.end(), note) != notes.end();
}

const std::vector<std::string> cranks{"crank_1_joint", "crank_2_joint", "crank_3_joint"};

// Gazebo asks for a transmission of every joint that it is to hold.
TEST(ActuatedJoints, AreFoundAmongTransmissionsOfPassiveOnes) {
  const auto delta = test::shipped("delta");
  std::string transmissions;
  for (const std::string& joint : delta->joint_names()) transmissions += transmission(joint);
  const auto mechanism = test::load(without_list("delta", transmissions));
  EXPECT_EQ(actuated_joints(*mechanism), cranks);
  EXPECT_TRUE(
      has_note(*mechanism,
               "Of the joints that have a <transmission> in robot.urdf, those are taken as actuated under "
               "which the mobility is their number: 'crank_1_joint', 'crank_2_joint', 'crank_3_joint'."));
}

// Six of a planar robot: so many would be a hexapod's.
TEST(ActuatedJoints, AreThoseOfAnEqualPlaceInEachLeg) {
  const auto mechanism =
      test::load(without_list("five_bar", transmission("elbow_1_joint") + transmission("crank_2_joint") +
                                              transmission("crank_1_joint")));
  EXPECT_EQ(actuated_joints(*mechanism), (std::vector<std::string>{"crank_2_joint", "crank_1_joint"}));
}

TEST(ActuatedJoints, AreThoseWithCommandInterfaces) {
  const auto delta = test::shipped("delta");
  std::string interfaces = "<ros2_control name=\"robot\" type=\"system\">";
  for (const std::string& joint : delta->joint_names())
    interfaces += joint.find("crank") == 0 ? commanded(joint) : reported(joint);
  const auto mechanism =
      test::load(without_list("delta", interfaces + "</ros2_control>" + transmission("wrist_yaw_joint")));
  EXPECT_EQ(actuated_joints(*mechanism), cranks);
  EXPECT_TRUE(has_note(*mechanism,
                       "The actuated joints are those that have a command interface of <ros2_control> in "
                       "robot.urdf: 'crank_1_joint', 'crank_2_joint', 'crank_3_joint'."));
}

TEST(ActuatedJoints, AreNotThoseThatOnlyReport) {
  const auto mechanism = test::load(
      without_list("five_bar", transmission("crank_1_joint") + transmission("crank_2_joint") +
                                   transmission("elbow_1_joint", "hardware_interface/JointStateInterface")));
  EXPECT_EQ(actuated_joints(*mechanism), (std::vector<std::string>{"crank_1_joint", "crank_2_joint"}));
}

TEST(ActuatedJoints, OfTheListWin) {
  Description text = shipped_text("five_bar");
  text.change_urdf("</robot>", transmission("elbow_1_joint") + "</robot>");
  EXPECT_EQ(actuated_joints(*test::load(text)), (std::vector<std::string>{"crank_1_joint", "crank_2_joint"}));
}

// Either pair of a five-bar may be actuated; whoever lists one is understood.
TEST(ActuatedJoints, AreAskedForWhereTwoChoicesFit) {
  const Description text =
      without_list("five_bar", transmission("crank_1_joint") + transmission("crank_2_joint") +
                                   transmission("elbow_1_joint") + transmission("elbow_2_joint"));
  test::expect_refusal(
      text,
      "robot.yaml does not say mechanism.actuated_joints, and 4 joints have a <transmission> in robot.urdf, "
      "'crank_1_joint', 'crank_2_joint', 'elbow_1_joint', 'elbow_2_joint'; the mobility fits [crank_1_joint, "
      "crank_2_joint] and [elbow_1_joint, elbow_2_joint], so list those that are actuated.");
  for (const std::string list : {"[crank_1_joint, crank_2_joint]", "[elbow_1_joint, elbow_2_joint]"})
    EXPECT_EQ(test::load(text.urdf, replaced(text.config, "mechanism:\n",
                                             "mechanism:\n  actuated_joints: " + list + "\n"))
                  ->mobility(),
              2);
}

std::string detachable(const std::string& parent, const std::string& child) {
  return "<gazebo><plugin filename=\"x\" name=\"gz::sim::systems::DetachableJoint\"><parent_link>" + parent +
         "</parent_link><child_model>robot</child_model><child_link>" + child +
         "</child_link></plugin></gazebo>";
}

std::shared_ptr<const Mechanism> welded_five_bar(const std::string& weld) {
  return test::load(
      test::replaced(test::source_file("test/data/closed_five_bar.urdf"), "<!-- closure -->", weld),
      "mechanism: {operational_point: tip_1, actuated_joints: [mot_1, mot_2]}");
}

// The origin of rod 1 is its elbow, 2.8 m from where the rods meet.
TEST(Weld, IsReadAlikeInAllWaysOfWritingIt) {
  for (const std::string& weld :
       {detachable("tip_1", "tip_2"), detachable("tip_2", "tip_1"), detachable("rod_1", "tip_2"),
        detachable("tip_2", "rod_1"), detachable("rod_2", "tip_1"),
        std::string("<gazebo><joint name=\"a\" "
                    "type=\"fixed\"><parent>rod_1</parent><child>tip_2</child></joint></gazebo>"),
        std::string("<gazebo><joint name=\"a\" "
                    "type=\"fixed\"><parent>tip_2</parent><child>rod_1</child></joint></gazebo>"),
        std::string("<loop_joint name=\"a\" type=\"fixed\"><link1 link=\"rod_1\" xyz=\"2 2 0\"/><link2 "
                    "link=\"rod_2\" xyz=\"-2 2 0\"/></loop_joint>")}) {
    const auto mechanism = welded_five_bar(weld);
    ASSERT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T2) << weld;
    for (const Leg& leg : mechanism->manipulator()->legs()) EXPECT_NEAR(leg.rod_length, std::sqrt(8.0), 1e-9);
    EXPECT_EQ(test::open_loops(*mechanism), 0) << weld;
  }
}

TEST(Weld, SaysWhatWasMadeOfItsOffset) {
  EXPECT_EQ(welded_five_bar(detachable("rod_1", "tip_2"))->notes().back(),
            "The rigid closures of robot.urdf would hold the robot still, with 'tip_2' at xyz [2, 2, 0] m of "
            "'rod_1'; they are taken as point at the origin of 'tip_2', under which the mobility is the "
            "number of actuated joints.");
}

// A rod that is drawn in two halves.
TEST(Weld, StaysRigidWhereThatMakesAManipulator) {
  std::string urdf = test::source_file("test/data/closed_five_bar.urdf");
  urdf = replaced(urdf, "<!-- closure -->",
                  "<link name=\"half\"/>" + test::moving_joint("pin", "tip_1", "half", "0 0 1") +
                      detachable("half", "rod_2"));
  const auto mechanism =
      test::load(urdf, "mechanism: {operational_point: tip_1, actuated_joints: [mot_1, mot_2]}");
  EXPECT_NEAR(mechanism->manipulator()->leg(1).rod_length, std::sqrt(8.0), 1e-9);
  EXPECT_EQ(mechanism->notes().back(),
            "The rigid closures of robot.urdf are taken as fixed, as they are written, with 'rod_2' at xyz "
            "[2, -2, 0] m of 'half'.");
}

// Empty links at the ends of the legs, drawn some millimetres off the platform that they are welded to.
TEST(Weld, SaysHowFarEndsAreApart) {
  std::string welds;
  for (int i = 2; i <= 6; ++i)
    welds += "<gazebo><joint name=\"hold_" + std::to_string(i) +
             "\" type=\"fixed\"><parent>plate</parent><child>weld_" + std::to_string(i) +
             "</child></joint></gazebo>";
  const auto mechanism = test::load(
      replaced(test::source_file("test/data/described/open_hexapod.urdf"), "</robot>", welds + "</robot>"),
      "mechanism: {operational_point: plate, actuated_joints: [strut_1, strut_2, strut_3, strut_4, strut_5, "
      "strut_6]}");
  const auto& notes = mechanism->notes();
  const std::string words =
      "The rigid closures of robot.urdf are taken as fixed, as they are written, which holds ends apart as "
      "they are drawn while all joints are zero: 'weld_2' and 'plate' by 1.77 mm, 'weld_3' and 'plate' by "
      "2.78 mm, 'weld_4' and 'plate' by 3.83 mm, 'weld_5' and 'plate' by 3.38 mm, 'weld_6' and 'plate' by "
      "2.19 mm; if they are to meet, write closures: [{frames: [plate, weld_2], type: fixed}, {frames: "
      "[plate, weld_3], type: fixed}, {frames: [plate, weld_4], type: fixed}, {frames: [plate, weld_5], "
      "type: fixed}, {frames: [plate, weld_6], type: fixed}] under mechanism in robot.yaml.";
  EXPECT_NE(std::find(notes.begin(), notes.end(), words), notes.end()) << ::testing::PrintToString(notes);
}

// A planar leg that is closed at zero: crank up 3 m, rod inwards to (x, y) of the base.
std::string leg(const std::string& number, const std::string& base, const std::string& tip) {
  return "<link name=\"crank_" + number + "\"/><link name=\"rod_" + number + "\"/><link name=\"tip_" +
         number + "\"/>" +
         test::moving_joint("motor_" + number, "base", "crank_" + number, "0 0 1", "xyz=\"" + base + "\"") +
         test::moving_joint("elbow_" + number, "crank_" + number, "rod_" + number, "0 0 1", "xyz=\"0 3 0\"") +
         test::fixed_joint("rod_" + number, "tip_" + number, "xyz=\"" + tip + "\"");
}

// Rods 2 and 3 end 0.2 m from the corners of the platform that they are welded to, and carry more: the joint
// may be at either.
Description uncertain() {
  const std::string urdf = "<robot name=\"robot\"><link name=\"base\"/>" + leg("1", "0 0 0", "2 1 0") +
                           leg("2", "8 0 0", "-3 1 0") + leg("3", "4 8 0", "0.5 -4 0") +
                           "<link name=\"platform\"/>" +
                           test::moving_joint("pin", "tip_1", "platform", "0 0 1") +
                           "<link name=\"corner_2\"/><link name=\"corner_3\"/>" +
                           test::fixed_joint("platform", "corner_2", "xyz=\"3 0.2 0\"") +
                           test::fixed_joint("platform", "corner_3", "xyz=\"2.3 3 0\"") +
                           "<link name=\"cap_2\"/><link name=\"cap_3\"/>" +
                           test::fixed_joint("tip_2", "cap_2", "") + test::fixed_joint("tip_3", "cap_3", "") +
                           detachable("corner_2", "tip_2") + detachable("corner_3", "tip_3") + "</robot>";
  return {urdf, "mechanism: {operational_point: platform, actuated_joints: [motor_1, motor_2, motor_3]}"};
}

TEST(Weld, IsAskedForWhereTwoRobotsFit) {
  const Description text = uncertain();
  const Problems problems = test::refusal(text);
  ASSERT_EQ(problems.size(), 1U);
  const std::string& message = problems.front();
  EXPECT_TRUE(test::has(message, "and is a manipulator with a joint at either origin"));
  const std::string start = "say which is meant, as by ";
  const std::size_t at = message.find(start), end = message.find(" under mechanism in robot.yaml.");
  ASSERT_NE(at, std::string::npos) << message;
  ASSERT_NE(end, std::string::npos) << message;
  const std::string closures = message.substr(at + start.size(), end - at - start.size());
  const auto mechanism = test::load(text.urdf, replaced(text.config, "}", ", " + closures + "}"));
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SE2);
  EXPECT_EQ(test::open_loops(*mechanism, 0.05), 0);
}

// The option that setup names, as it stands.
TEST(Weld, IsAskedForBySetupWithAnOption) {
  const std::string urdf = uncertain().urdf;
  const SetupControl patient{1000000};
  const SetupResult asked = set_up(urdf, "robot.urdf", "robot.yaml", {}, patient);
  ASSERT_FALSE(asked.problems.empty());
  const std::string start = "as by --closures '";
  const std::size_t at = asked.problems.front().find(start);
  ASSERT_NE(at, std::string::npos) << asked.problems.front();
  const std::string rest = asked.problems.front().substr(at + start.size());
  std::istringstream option(rest.substr(0, rest.find('\'')));
  SetupAnswers answers;
  for (std::string pair; option >> pair;) {
    const std::size_t middle = pair.find('=');
    answers.closures.push_back({pair.substr(0, middle), pair.substr(middle + 1)});
  }
  const SetupResult found = set_up(urdf, "robot.urdf", "robot.yaml", answers, patient);
  ASSERT_TRUE(found.mechanism) << asked.problems.front();
  EXPECT_EQ(found.mechanism->manipulator()->task_space(), TaskSpace::SE2);
}

}  // namespace
}  // namespace parallel_aspects
