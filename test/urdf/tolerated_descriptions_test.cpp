// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/loops.h"
#include "support/robots/shipped.h"
#include <cmath>

namespace parallel_aspects {
namespace {

using test::replaced;

// What real files hold and a five-bar can bear: each change leaves the robot as it is, with or without a
// note.
struct Tolerated {
  std::string name;
  std::string old;
  std::string by;
  std::string note;  // empty for none
};

void PrintTo(const Tolerated& tolerated, std::ostream* stream) { *stream << tolerated.name; }

class ToleratedDescription : public ::testing::TestWithParam<Tolerated> {};

TEST_P(ToleratedDescription, IsTheSameRobot) {
  const std::string urdf = replaced(test::source_file("urdf/five_bar.urdf"), GetParam().old, GetParam().by);
  const auto mechanism = test::load(urdf, test::source_file("config/robots/five_bar.yaml"));
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T2);
  EXPECT_NEAR(mechanism->manipulator()->leg(0).rod_length, 5.0, 1e-12);
  EXPECT_FALSE(mechanism->manipulator()->leg(0).limits.limited());
  EXPECT_EQ(test::open_loops(*mechanism), 0);
  const std::vector<std::string> expected =
      GetParam().note.empty() ? std::vector<std::string>{} : std::vector<std::string>{GetParam().note};
  EXPECT_EQ(mechanism->notes(), expected);
}

const std::string crank_1 = "<joint name=\"crank_1_joint\" type=\"continuous\">";
const std::string revolute_crank_1 = "<joint name=\"crank_1_joint\" type=\"revolute\">";

INSTANTIATE_TEST_SUITE_P(
    All, ToleratedDescription,
    ::testing::Values(
        Tolerated{"RevoluteWithoutLimits", crank_1, revolute_crank_1,
                  "robot.urdf states no limits for revolute joint 'crank_1_joint', or both as 0; it is taken "
                  "as unlimited."},
        Tolerated{"RevoluteWithEffortOnly", crank_1,
                  revolute_crank_1 + "<limit effort=\"1\" velocity=\"1\"/>",
                  "robot.urdf states no limits for revolute joint 'crank_1_joint', or both as 0; it is taken "
                  "as unlimited."},
        Tolerated{"SeveralWithoutLimits", "type=\"continuous\"", "type=\"revolute\"",
                  "robot.urdf states no limits for revolute joints 'crank_1_joint', 'elbow_1_joint', "
                  "'crank_2_joint', 'elbow_2_joint', or both as 0; they are taken as unlimited."},
        Tolerated{"ContinuousWithZeroLimits", crank_1,
                  crank_1 + "<limit lower=\"0\" upper=\"0\" effort=\"1\" velocity=\"1\"/>", ""},
        Tolerated{"LimitsInDegrees", "<joint name=\"elbow_1_joint\" type=\"continuous\">",
                  "<joint name=\"elbow_1_joint\" type=\"revolute\"><limit lower=\"-180\" upper=\"180\"/>",
                  "robot.urdf gives joint 'elbow_1_joint' limits that look like degrees; they are taken as "
                  "radians."},
        Tolerated{"ZeroAxisOnFixedJoint", "<joint name=\"tool_joint\" type=\"fixed\">",
                  "<joint name=\"tool_joint\" type=\"fixed\"><axis xyz=\"0 0 0\"/>",
                  "robot.urdf gives fixed joint 'tool_joint' a zero axis; it is not used."},
        Tolerated{"Mimic", "<joint name=\"elbow_1_joint\" type=\"continuous\">",
                  "<joint name=\"elbow_1_joint\" type=\"continuous\"><mimic joint=\"crank_1_joint\"/>",
                  "robot.urdf lets joint 'elbow_1_joint' mimic another joint; that is not used, the loop "
                  "closures decide."},
        Tolerated{"ForeignTags", "<link name=\"closing_2\"/>",
                  "<link name=\"closing_2\"/><gazebo reference=\"tool\"><mu1>0.2</mu1></gazebo><ros2_control "
                  "name=\"x\"/><unknown/>",
                  ""},
        Tolerated{"NamesBeyondAscii", "rod_2", "Stößel_ロッド", ""},
        Tolerated{"ZeroInertia", "<link name=\"closing_2\"/>",
                  "<link name=\"closing_2\"><inertial><mass value=\"0\"/><inertia ixx=\"0\" ixy=\"0\" "
                  "ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial></link>",
                  ""},
        Tolerated{"ShapesThatCannotBe", "<link name=\"closing_2\"/>",
                  "<link name=\"closing_2\"><visual><origin xyz=\"0 nan 0\"/><geometry><box size=\"0 1 "
                  "1\"/></geometry></visual><collision><geometry><cylinder radius=\"-0.1\" "
                  "length=\"1\"/></geometry></collision><visual><geometry><mesh "
                  "filename=\"\"/></geometry></visual></link>",
                  "robot.urdf has shapes that cannot be, <origin xyz='0 nan 0'> in link 'closing_2', <box "
                  "size='0 1 1'> in link 'closing_2', <mesh filename=''> in link 'closing_2', <cylinder "
                  "radius='-0.1'> in link 'closing_2'; they are not used, as kinematics needs none."},
        Tolerated{"WhatUrdfdomRefuses", "<link name=\"closing_2\"/>",
                  "<material/><link name=\"closing_2\"><visual><geometry/></visual><inertial><mass "
                  "value=\"heavy\"/></inertial><collision><geometry><mesh "
                  "filename=\"package://gone/rod.stl\"/></geometry></collision></link>",
                  ""},
        Tolerated{"AxisThatIsNotUnit", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 17\"/>", ""}),
    [](const ::testing::TestParamInfo<Tolerated>& tested) { return tested.param.name; });

// Zero is on a limit of the crank and outside those of the elbow.
TEST(Limits, ComeFromTheUrdf) {
  std::string urdf = test::source_file("urdf/five_bar.urdf");
  urdf = replaced(urdf, crank_1,
                  revolute_crank_1 + "<limit lower=\"0\" upper=\"2\" effort=\"1\" velocity=\"1.5\"/>");
  urdf = replaced(urdf, "<joint name=\"elbow_1_joint\" type=\"continuous\">",
                  "<joint name=\"elbow_1_joint\" type=\"revolute\"><limit lower=\"0.5\" upper=\"3\" "
                  "effort=\"1\" velocity=\"0\"/>");
  const auto mechanism = test::load(urdf, test::source_file("config/robots/five_bar.yaml"));
  const JointLimits& driven = mechanism->manipulator()->leg(0).limits;
  EXPECT_EQ(driven.lower, 0.0);
  EXPECT_EQ(driven.upper, 2.0);
  EXPECT_EQ(driven.velocity, 1.5);
  EXPECT_TRUE(std::isinf(mechanism->joint_limits()[1].velocity)) << "0 is none";
  EXPECT_EQ(mechanism->manipulator()->leg(1).limits.velocity, 2.0) << "of the shipped robot";
  EXPECT_FALSE(mechanism->manipulator()->leg(1).limits.limited());
  EXPECT_EQ(mechanism->joint_limits()[1].lower, 0.5);
  EXPECT_EQ(mechanism->joint_limits()[1].upper, 3.0);
  const AssembledConfiguration assembled = mechanism->assembled();
  EXPECT_TRUE(driven.contain(assembled.q[0]));
  Eigen::VectorXd joints(4);
  ASSERT_TRUE(mechanism->complete(assembled.pose, assembled.q, joints));
  EXPECT_TRUE(mechanism->joint_limits()[1].contain(joints[1])) << joints[1];
}

// Elbow 1 bends to one side only: half of the working modes ask for what it cannot do.
TEST(Limits, OfPassiveJointsAreDistinguished) {
  std::string urdf = test::source_file("urdf/five_bar.urdf");
  urdf = replaced(urdf, "<joint name=\"elbow_1_joint\" type=\"continuous\">",
                  "<joint name=\"elbow_1_joint\" type=\"revolute\"><limit lower=\"0\" upper=\"3\" "
                  "effort=\"1\" velocity=\"0\"/>");
  const auto mechanism = test::load(urdf, test::source_file("config/robots/five_bar.yaml"));
  Pose pose;
  pose.position << 4.5, 8.0, 0.0;
  Eigen::VectorXd joints(4);
  for (const InverseSolution& solution : inverse_in_all_modes(*mechanism->manipulator(), pose)) {
    ASSERT_TRUE(mechanism->complete(pose, solution.q, joints));
    const auto outside = mechanism->joint_outside_limits(joints);
    ASSERT_EQ(outside.has_value(), solution.mode.sign(0) < 0) << joints.transpose();
    if (outside.has_value()) {
      EXPECT_EQ(mechanism->joint_names()[*outside], "elbow_1_joint");
    }
  }
  joints << 0.0, 3.0 + 1e-12, 0.0, 0.0;
  EXPECT_FALSE(mechanism->joint_outside_limits(joints));
  joints[3] = std::nan("");
  EXPECT_EQ(mechanism->joint_outside_limits(joints), std::optional<std::size_t>(3));
}

// The closures ask for an elbow that its limits forbid.
TEST(Limits, MayKeepTheLoopsOpen) {
  std::string urdf = test::source_file("urdf/bipod.urdf");
  urdf = replaced(urdf, "lower=\"4\" upper=\"9\"", "lower=\"20\" upper=\"30\"");
  EXPECT_EQ(
      test::refusal(urdf, test::source_file("config/robots/bipod.yaml")),
      Problems{"robot.urdf cannot be closed as robot.yaml asks: the frames of closure 'tool - bar_2_tip' "
               "come no nearer than 9 m; check the lengths, the joint limits and the frames of its loop."});
}

// As older editors save it; a name in the YAML is one in the URDF all the same.
TEST(ToleratedDescription, MayBeInLatin1AndHaveADoctype) {
  const auto named = [](const std::string& name) {
    return "<!DOCTYPE robot [<!ENTITY a \"a\">]>\n" +
           replaced(test::source_file("urdf/five_bar.urdf")
                        .substr(test::source_file("urdf/five_bar.urdf").find("<robot")),
                    "\"crank_1_joint\"", "\"" + name + "\"");
  };
  const std::string config =
      replaced(test::source_file("config/robots/five_bar.yaml"), "crank_1_joint", "moteur_\u00e9");
  for (const std::string name : {"moteur_\xe9", "moteur_\u00e9"}) {
    const auto mechanism = test::load(named(name), config);
    EXPECT_EQ(mechanism->manipulator()->leg(0).actuated_joint, "moteur_\u00e9");
    EXPECT_TRUE(mechanism->notes().empty());
  }
}

}  // namespace
}  // namespace parallel_aspects
