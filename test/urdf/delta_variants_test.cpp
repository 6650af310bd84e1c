// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/loops.h"
#include <array>

// Robots with a translating platform, built in other ways than the shipped Delta.
namespace parallel_aspects {
namespace {

std::string link(const std::string& name) { return "<link name=\"" + name + "\"/>\n"; }

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& origin, const std::string& axis = "0 0 1") {
  return link(child) + "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin " + origin + "/><axis xyz=\"" + axis + "\"/></joint>\n";
}

std::string frame(const std::string& name, const std::string& parent, const std::string& origin) {
  return joint(name + "_joint", "fixed", parent, name, origin);
}

const std::array<std::string, 3> yaws{"0", "2.0944", "-2.0944"};
const std::string y_as_z = " rpy=\"-1.5707963267948966 0 0\"";

// Base, and an actuated crank of 0.25 m on each leg. At zero the cranks are level and the rods hang down.
std::string cranks() {
  std::string text = link("base");
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string leg = std::to_string(k + 1);
    text += frame("leg_" + leg, "base", "rpy=\"0 0 " + yaws[k] + "\"") +
            joint("crank_" + leg, "continuous", "leg_" + leg, "arm_" + leg, "xyz=\"0.2 0 0\"", "0 1 0");
  }
  return text;
}

std::string config(const std::string& closures) {
  return "mechanism: {operational_point: platform, actuated_joints: [crank_1, crank_2, crank_3], closures: "
         "[" +
         closures + "]}";
}

void expect_delta(const Mechanism& mechanism) {
  EXPECT_EQ(mechanism.manipulator()->task_space(), TaskSpace::T3);
  EXPECT_EQ(mechanism.mobility(), 3);
  for (const Leg& leg : mechanism.manipulator()->legs()) {
    EXPECT_NEAR(std::get<RevoluteActuation>(leg.actuation).radius, 0.25, 1e-9);
    EXPECT_NEAR(leg.rod_length, 0.7, 1e-9);
    EXPECT_NEAR(leg.anchor.norm(), 0.05, 1e-9);
    EXPECT_NEAR(leg.anchor.z(), 0.0, 1e-9);
  }
  EXPECT_EQ(test::open_loops(mechanism, 0.1), 0);
}

// Clavel's parallelogram: a bar turns on the crank, two rods on the bar, and a second bar on the rods and the
// platform.
struct LoopTexts {
  std::string urdf, closures;
};

LoopTexts delta_of_revolute_joints() {
  std::string urdf = "<robot name=\"delta\">" + cranks();
  std::string closures;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string leg = std::to_string(k + 1);
    urdf +=
        joint("upper_" + leg, "continuous", "arm_" + leg, "upper_bar_" + leg, "xyz=\"0.25 0 0\"", "0 1 0") +
        joint("left_" + leg, "continuous", "upper_bar_" + leg, "left_rod_" + leg, "xyz=\"0 0.06 0\"",
              "1 0 0") +
        joint("right_" + leg, "continuous", "upper_bar_" + leg, "right_rod_" + leg, "xyz=\"0 -0.06 0\"",
              "1 0 0") +
        joint("low_" + leg, "continuous", "left_rod_" + leg, "lower_bar_" + leg, "xyz=\"0 0 -0.7\"",
              "1 0 0") +
        frame("right_tip_" + leg, "right_rod_" + leg, "xyz=\"0 0 -0.7\"") +
        frame("right_end_" + leg, "lower_bar_" + leg, "xyz=\"0 -0.12 0\"");
    closures += "{frames: [right_tip_" + leg + ", right_end_" + leg + "], type: point}, ";
    if (k == 0) {
      urdf += joint("wrist", "continuous", "lower_bar_1", "wrist_link", "xyz=\"0 -0.06 0\"", "0 1 0") +
              frame("platform", "wrist_link", "xyz=\"-0.05 0 0\"");
      continue;
    }
    urdf += frame("middle_" + leg, "lower_bar_" + leg, "xyz=\"0 -0.06 0\"" + y_as_z) +
            frame("side_" + leg, "platform", "rpy=\"0 0 " + yaws[k] + "\"") +
            frame("point_" + leg, "side_" + leg, "xyz=\"0.05 0 0\"" + y_as_z);
    closures += "{frames: [middle_" + leg + ", point_" + leg + "], type: revolute}, ";
  }
  return {urdf + "</robot>", closures};
}

TEST(DeltaVariant, HasParallelogramsOfRevoluteJoints) {
  const LoopTexts delta = delta_of_revolute_joints();
  expect_delta(*test::load(delta.urdf, config(delta.closures)));
}

// As CAD exports frames: nothing says what joint they are.
TEST(DeltaVariant, HasATiltedAxisInAParallelogram) {
  LoopTexts delta = delta_of_revolute_joints();
  const std::string right = "<child link=\"right_rod_2\"/><origin xyz=\"0 -0.06 0\"/><axis xyz=\"1 0";
  delta.urdf = test::replaced(delta.urdf, right + " 0", right + ".04 0");
  const Problems problems = test::refusal(delta.urdf, config(delta.closures));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0],
            "robot.urdf lets joint 'right_2' turn about (0.999200958722, 0.0399680383489, 0), where that of "
            "other legs turns about (1, 0, 0); write <axis xyz=\"1 0 0\"/> for joint 'right_2', which makes "
            "it a robot in T3.");
}

TEST(DeltaVariant, LeavesTheTypesOfItsClosuresOpen) {
  const LoopTexts delta = delta_of_revolute_joints();
  const std::string open =
      test::replaced(test::replaced(delta.closures, "revolute", "auto"), "point", "auto");
  const auto mechanism = test::load(delta.urdf, config(test::replaced(open, "auto_", "point_")));
  expect_delta(*mechanism);
  ASSERT_EQ(mechanism->notes().size(), 1u);
  EXPECT_EQ(mechanism->notes().front(),
            "robot.yaml leaves the type of closures open; they are taken as point ('right_tip_1 - "
            "right_end_1', 'right_tip_2 - right_end_2', 'right_tip_3 - right_end_3') and revolute ('middle_2 "
            "- point_2', 'middle_3 - point_3'), under which the mobility is the number of actuated joints.");
}

// A single rod between two universal joints whose axes are parallel in pairs.
TEST(DeltaVariant, HasSingleRodsOnUniversalJoints) {
  std::string urdf = "<robot name=\"delta\">" + cranks();
  std::string closures;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string leg = std::to_string(k + 1);
    urdf += joint("pitch_" + leg, "continuous", "arm_" + leg, "cross_" + leg, "xyz=\"0.25 0 0\"", "0 1 0") +
            joint("roll_" + leg, "continuous", "cross_" + leg, "rod_" + leg, "", "1 0 0") +
            joint("low_" + leg, "continuous", "rod_" + leg, "low_cross_" + leg, "xyz=\"0 0 -0.7\"", "1 0 0");
    if (k == 0) {
      urdf += joint("wrist", "continuous", "low_cross_1", "wrist_link", "", "0 1 0") +
              frame("platform", "wrist_link", "xyz=\"-0.05 0 0\"");
      continue;
    }
    urdf += frame("end_" + leg, "low_cross_" + leg, y_as_z) +
            frame("side_" + leg, "platform", "rpy=\"0 0 " + yaws[k] + "\"") +
            frame("point_" + leg, "side_" + leg, "xyz=\"0.05 0 0\"" + y_as_z);
    closures += "{frames: [end_" + leg + ", point_" + leg + "], type: revolute}, ";
  }
  const auto mechanism = test::load(urdf + "</robot>", config(closures));
  expect_delta(*mechanism);
}

// Three struts that meet in the operational point: the link of the point turns, but no actuated joint asks
// for that.
TEST(DeltaVariant, IsATripodWhoseStrutsMeetInAPoint) {
  std::string urdf = "<robot name=\"tripod\">" + link("base");
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string leg = std::to_string(k + 1);
    urdf += frame("leg_" + leg, "base", "rpy=\"0 0 " + yaws[k] + "\"") +
            joint("roll_" + leg, "continuous", "leg_" + leg, "cross_" + leg, "xyz=\"1 0 0\"", "1 0 0") +
            joint("pitch_" + leg, "continuous", "cross_" + leg, "tube_" + leg, "", "0 1 0") +
            joint("crank_" + leg, "prismatic", "tube_" + leg, "tip_" + leg, "", "0 0 1");
  }
  urdf += frame("platform", "tip_1", "");
  const auto mechanism = test::load(
      urdf + "</robot>",
      config("{frames: [platform, tip_2], type: spherical}, {frames: [tip_1, tip_3], type: spherical}"));
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T3);
  for (const Leg& leg : mechanism->manipulator()->legs()) {
    EXPECT_NEAR(std::get<StrutActuation>(leg.actuation).base.norm(), 1.0, 1e-9);
    EXPECT_NEAR(leg.anchor.norm(), 0.0, 1e-9);
  }
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
}

}  // namespace
}  // namespace parallel_aspects
