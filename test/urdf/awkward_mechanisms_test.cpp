// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/loops.h"
#include "support/shipped.h"
#include <cmath>

// Robots as people write them: tilted, turned round, rounded, with joints in other places than in the shipped
// files.
namespace parallel_aspects {
namespace {

using test::replaced;

struct Description {
  std::string urdf, config;
};

Description shipped_text(const std::string& robot) {
  return {test::source_file("urdf/" + robot + ".urdf"),
          test::source_file("config/robots/" + robot + ".yaml")};
}

std::shared_ptr<const Mechanism> load(const Description& description) {
  return test::load(description.urdf, description.config);
}

const RevoluteDrive& revolute(const Mechanism& mechanism, std::size_t leg) {
  return std::get<RevoluteDrive>(mechanism.manipulator()->leg(leg).drive);
}

std::string fixed_joint(const std::string& parent, const std::string& child, const std::string& origin) {
  return "<joint name=\"" + parent + "_to_" + child + "\" type=\"fixed\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin " + origin + "/></joint>";
}

std::string moving_joint(const std::string& name, const std::string& parent, const std::string& child,
                         const std::string& axis, const std::string& origin = "") {
  return "<joint name=\"" + name + "\" type=\"continuous\"><parent link=\"" + parent + "\"/><child link=\"" +
         child + "\"/><origin " + origin + "/><axis xyz=\"" + axis + "\"/></joint>";
}

TEST(AwkwardMechanism, StandsInATiltedPlane) {
  Description five_bar = shipped_text("five_bar");
  five_bar.urdf =
      replaced(five_bar.urdf, "</robot>",
               "<link name=\"wall\"/>" +
                   fixed_joint("wall", "base_link", "xyz=\"1 2 3\" rpy=\"0.7 0.3 0.2\"") + "</robot>");
  five_bar.config = replaced(five_bar.config, "base_link: base_link", "base_link: wall");
  const auto mechanism = load(five_bar);
  const Manipulator& manipulator = *mechanism->manipulator();
  const Eigen::Matrix3d turned =
      (Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()))
          .matrix();
  EXPECT_EQ(manipulator.task_space(), TaskSpace::T2);
  EXPECT_EQ(manipulator.base_frame(), "wall");
  EXPECT_NEAR(manipulator.task_frame().linear().col(2).dot(turned.col(2)), 1.0, 1e-12);
  for (const std::size_t j : {0, 1}) {
    EXPECT_NEAR(revolute(*mechanism, j).radius, j == 0 ? 8.0 : 5.0, 1e-12);
    const Eigen::Vector3d pivot = manipulator.task_frame() * revolute(*mechanism, j).center;
    EXPECT_NEAR((pivot - Eigen::Vector3d(1, 2, 3) - turned * Eigen::Vector3d(9.0 * j, 0, 0)).norm(), 0.0,
                1e-11);
  }
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, HasAxesOfMixedSign) {
  Description five_bar = shipped_text("five_bar");
  const std::string crank_2 = "<origin xyz=\"9 0 0\"/>\n    <axis xyz=\"0 0 ";
  five_bar.urdf = replaced(five_bar.urdf, crank_2 + "1", crank_2 + "-2");
  const std::string elbow_1 = "<origin xyz=\"8 0 0\"/>\n    <axis xyz=\"0 0 ";
  five_bar.urdf = replaced(five_bar.urdf, elbow_1 + "1", elbow_1 + "-1");
  const auto mechanism = load(five_bar);
  EXPECT_NEAR(revolute(*mechanism, 0).axis.z(), 1.0, 1e-12);
  EXPECT_NEAR(revolute(*mechanism, 1).axis.z(), -1.0, 1e-12);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, ReachesItsPlatformThroughLegTwo) {
  Description five_bar = shipped_text("five_bar");
  five_bar.config = replaced(five_bar.config, "operational_point: tool", "operational_point: closing_2");
  const auto mechanism = load(five_bar);
  EXPECT_EQ(mechanism->manipulator()->leg(1).rod_length, 8.0);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, IsClosedAtTheElbow) {
  Description five_bar = shipped_text("five_bar");
  // Rod 2 hangs on the tool, and the loop is cut between crank 2 and rod 2.
  five_bar.urdf = replaced(five_bar.urdf, "<parent link=\"crank_2\"/>", "<parent link=\"tool\"/>");
  five_bar.urdf =
      replaced(five_bar.urdf, "<origin xyz=\"5 0 0\"/>\n    <axis", "<origin xyz=\"0 0 0\"/>\n    <axis");
  five_bar.urdf =
      replaced(five_bar.urdf, "</robot>",
               "<link name=\"elbow\"/>" + fixed_joint("crank_2", "elbow", "xyz=\"5 0 0\"") + "</robot>");
  five_bar.config = replaced(five_bar.config, "[tool, closing_2]", "[elbow, closing_2]");
  const auto mechanism = load(five_bar);
  EXPECT_NEAR(revolute(*mechanism, 1).radius, 5.0, 1e-12);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, IsDrivenAtTheElbows) {
  Description five_bar = shipped_text("five_bar");
  five_bar.config =
      replaced(five_bar.config, "[crank_1_joint, crank_2_joint]", "[elbow_1_joint, elbow_2_joint]");
  const auto mechanism = load(five_bar);
  for (const std::size_t j : {0, 1}) {
    const auto& drive = std::get<ElbowDrive>(mechanism->manipulator()->leg(j).drive);
    EXPECT_NEAR(drive.inner_length, j == 0 ? 8.0 : 5.0, 1e-12);
    EXPECT_NEAR(drive.outer_length, j == 0 ? 5.0 : 8.0, 1e-12);
    EXPECT_NEAR(std::remainder(drive.angle_at_zero, 2.0 * EIGEN_PI), 0.0, 1e-12);
  }
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, HasAToolThatSpinsIdly) {
  Description five_bar = shipped_text("five_bar");
  five_bar.urdf = replaced(five_bar.urdf, "<joint name=\"tool_joint\" type=\"fixed\">",
                           "<joint name=\"tool_joint\" type=\"continuous\"><axis xyz=\"0 0 1\"/>");
  const auto mechanism = load(five_bar);
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T2);
  EXPECT_EQ(mechanism->mobility(), 3);
  EXPECT_EQ(mechanism->idle_freedoms(), 1);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// A wrist after the platform and a column under the base are moved by others.
TEST(AwkwardMechanism, HasSerialJointsBeforeAndAfter) {
  Description robot = shipped_text("three_rrr");
  robot.urdf =
      replaced(robot.urdf, "</robot>",
               "<link name=\"column\"/><link name=\"wrist\"/>" +
                   moving_joint("column_joint", "column", "base_link", "1 0 0", "xyz=\"0 0 5\"") +
                   moving_joint("wrist_joint", "platform", "wrist", "0 1 0", "xyz=\"3 0 0\"") + "</robot>");
  const auto mechanism = load(robot);
  EXPECT_EQ(mechanism->mobility(), 3);
  EXPECT_TRUE(mechanism->manipulator()->task_frame().isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  EXPECT_EQ(mechanism->joint_names().size(), 9u);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, HasAPlatformInTwoPiecesThatAreWelded) {
  Description robot = shipped_text("three_rrr");
  robot.urdf = replaced(
      robot.urdf,
      "<joint name=\"platform_2_joint\" type=\"fixed\">\n    <parent link=\"platform\"/>\n    <child "
      "link=\"platform_2\"/>\n    <origin xyz=\"10 0 0\"/>",
      "<joint name=\"platform_2_joint\" type=\"continuous\">\n    <parent link=\"rod_2\"/>\n    <child "
      "link=\"platform_2\"/>\n    <origin xyz=\"10 0 0\"/>\n    <axis xyz=\"0 0 1\"/>");
  robot.urdf = replaced(
      robot.urdf, "</robot>",
      "<link name=\"corner\"/>" + fixed_joint("platform_2", "corner", "xyz=\"-10 0 0\"") + "</robot>");
  robot.config =
      replaced(robot.config, "[platform_2, rod_2_tip], type: revolute", "[platform, corner], type: fixed");
  const auto mechanism = load(robot);
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SE2);
  EXPECT_NEAR((mechanism->manipulator()->leg(1).anchor - Eigen::Vector3d(10, 0, 0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, FindsTheTypeOfAWeldByItself) {
  Description robot = shipped_text("agile_eye");
  robot.config = replaced(robot.config, "type: revolute", "type: auto");
  const auto mechanism = load(robot);
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SO3);
  ASSERT_EQ(mechanism->notes().size(), 1u);
  EXPECT_NE(mechanism->notes().front().find("taken as point"), std::string::npos);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// Rods with ball joints at both ends turn about themselves.
TEST(AwkwardMechanism, HasRodsThatSpin) {
  Description robot = shipped_text("hexa");
  for (const char* leg : {"1", "2", "3", "4", "5", "6"}) {
    const std::string rod = std::string("rod_") + leg, cross = std::string("cross_") + leg;
    robot.urdf =
        replaced(robot.urdf, "<parent link=\"" + cross + "\"/>", "<parent link=\"" + rod + "_spin\"/>");
    robot.urdf = replaced(robot.urdf, "</robot>",
                          "<link name=\"" + rod + "_spin\"/>" +
                              moving_joint(rod + "_spin_joint", cross, rod + "_spin", "0 0 1") + "</robot>");
  }
  const auto mechanism = load(robot);
  EXPECT_EQ(mechanism->mobility(), 12);
  EXPECT_EQ(mechanism->idle_freedoms(), 6);
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SE3);
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
}

// The platform carries rod 2 on its ball joint, and the loop is cut in the universal joint on the crank.
TEST(AwkwardMechanism, IsClosedInAUniversalJoint) {
  Description robot = shipped_text("hexa");
  robot.urdf = replaced(robot.urdf, "<parent link=\"crank_2\"/>", "<parent link=\"platform_2\"/>");
  robot.urdf = replaced(
      robot.urdf, "<child link=\"cross_2\"/>\n    <origin xyz=\"0.25 0 0\"/>\n    <axis xyz=\"0 1 0\"/>",
      "<child link=\"cross_2\"/>\n    <origin xyz=\"0 0 0\"/>\n    <axis xyz=\"0 1 0\"/>");
  robot.urdf = replaced(robot.urdf, "<parent link=\"cross_2\"/>", "<parent link=\"spin_2\"/>");
  robot.urdf = replaced(
      robot.urdf, "</robot>",
      "<link name=\"spin_2\"/><link name=\"fork\"/>" +
          moving_joint("spin_2_joint", "cross_2", "spin_2", "0 0 1") +
          fixed_joint("crank_2", "fork", "xyz=\"0.25 0 0\" rpy=\"1.5707963267948966 0 0\"") + "</robot>");
  robot.config = replaced(robot.config, "[platform_2, rod_2_tip], type: spherical",
                          "[fork, rod_2_tip], type: universal");
  const auto mechanism = load(robot);
  EXPECT_EQ(mechanism->mobility(), 6);
  EXPECT_NEAR(mechanism->manipulator()->leg(1).rod_length, 0.6, 1e-9);
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
}

// The origins of the two joints of a universal joint are apart, but their axes meet.
TEST(AwkwardMechanism, HasUniversalJointsWhoseOriginsAreApart) {
  Description robot = shipped_text("stewart");
  robot.urdf = replaced(robot.urdf, "<origin xyz=\"1.2 0 0\"/>\n    <axis xyz=\"1 0 0\"/>",
                        "<origin xyz=\"0.9 0 0\"/>\n    <axis xyz=\"1 0 0\"/>");
  for (const char* leg : {"1", "2", "3", "4", "5", "6"}) {
    const std::string child = std::string("<child link=\"cylinder_") + leg + "\"/>\n    <origin xyz=\"";
    robot.urdf = replaced(robot.urdf, child + "0 0 0", child + "0.3 0 0");
  }
  const auto mechanism = load(robot);
  for (const Leg& leg : mechanism->manipulator()->legs())
    EXPECT_NEAR(std::get<StrutDrive>(leg.drive).base.norm(), 1.2, 1e-9);
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
}

// Four digits, as people write them, leave a Delta that is one only nearly.
TEST(AwkwardMechanism, HasRoundedAngles) {
  Description five_bar = shipped_text("five_bar");
  const std::string crank_2 =
      "<child link=\"crank_2\"/>\n    <origin xyz=\"9 0 0\"/>\n    <axis xyz=\"0 0 1\"/>";
  five_bar.urdf = replaced(five_bar.urdf, crank_2,
                           "<child link=\"crank_2\"/>\n    <origin xyz=\"9 0 0\" rpy=\"1.57075 0 0\"/>\n    "
                           "<axis xyz=\"0 -1 0\"/>");
  five_bar.urdf = replaced(five_bar.urdf, "<origin xyz=\"5 0 0\"/>\n    <axis xyz=\"0 0 1\"/>",
                           "<origin xyz=\"5 0 0\" rpy=\"-1.57075 0 0\"/>\n    <axis xyz=\"0 0 1\"/>");
  const auto mechanism = load(five_bar);
  EXPECT_NEAR(revolute(*mechanism, 1).radius, 5.0, 1e-3);
  EXPECT_NEAR(revolute(*mechanism, 1).axis.z(), -1.0, 1e-12);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// An arm of three revolute joints, orthogonal and apart, that holds the point (0, 0, 0) when it is at zero.
std::string three_revolute_arm(const std::string& leg, const std::string& yaw) {
  return "<link name=\"foot" + leg + "\"/><link name=\"a" + leg + "\"/><link name=\"b" + leg +
         "\"/><link name=\"c" + leg + "\"/><link name=\"tip" + leg + "\"/>" +
         fixed_joint("base", "foot" + leg, "rpy=\"0 0 " + yaw + "\"") +
         moving_joint("drive" + leg, "foot" + leg, "a" + leg, "0 0 1", "xyz=\"2 0.3 -0.4\"") +
         moving_joint("shoulder" + leg, "a" + leg, "b" + leg, "0 1 0", "xyz=\"-0.5 0.2 0.1\"") +
         moving_joint("elbow" + leg, "b" + leg, "c" + leg, "1 0 0", "xyz=\"-0.7 0 0.6\"") +
         fixed_joint("c" + leg, "tip" + leg, "xyz=\"-0.8 -0.5 -0.3\"");
}

TEST(RefusedMechanism, HasCuspidalLegs) {
  const Problems problems =
      test::refusal("<robot name=\"arms\"><link name=\"base\"/>" + three_revolute_arm("1", "0") +
                        three_revolute_arm("2", "2.1") + three_revolute_arm("3", "-2.1") + "</robot>",
                    "mechanism: {operational_point: tip1, actuated_joints: [drive1, drive2, drive3], "
                    "closures: [{frames: [tip1, tip2], "
                    "type: point}, {frames: [tip1, tip3], type: point}]}");
  ASSERT_EQ(problems.size(), 3u) << (problems.empty() ? "accepted" : problems.front());
  EXPECT_EQ(
      problems[0],
      "robot.urdf has a leg through 'drive1', 'shoulder1', 'elbow1' that is an arm of three revolute joints "
      "whose "
      "passive axes do not meet: such a leg is in general cuspidal, it can change its posture without a "
      "serial "
      "singularity, and working modes separate the inverse solutions only if no leg is cuspidal (Chablat and "
      "Wenger, theorem 1); it is not a distance leg and cannot be treated.");
}

// B would not be diagonal: both drives move a point of the rod that is not its end.
TEST(RefusedMechanism, HasItsOperationalPointInsideARod) {
  Description five_bar = shipped_text("five_bar");
  five_bar.urdf =
      replaced(five_bar.urdf, "</robot>",
               "<link name=\"camera\"/>" + fixed_joint("rod_1", "camera", "xyz=\"2 0.5 0\"") + "</robot>");
  five_bar.config = replaced(five_bar.config, "operational_point: tool", "operational_point: camera");
  const Problems expected{
      "robot.urdf has a leg through 'crank_2_joint', 'elbow_2_joint', 'tool - closing_2' that does not end "
      "in "
      "the operational point; move that to where the legs meet, since B would not be diagonal; it is not a "
      "distance leg "
      "and cannot be treated."};
  EXPECT_EQ(test::refusal(five_bar.urdf, five_bar.config), expected);
}

// Three legs in one place can neither hold nor drive a platform.
TEST(RefusedMechanism, HasItsLegsStackedInOnePlace) {
  Description robot = shipped_text("delta");
  robot.urdf = replaced(robot.urdf, "rpy=\"0 0 2.0943951023931953\"", "rpy=\"0 0 0\"");
  robot.urdf = replaced(robot.urdf, "rpy=\"0 0 -2.0943951023931953\"", "rpy=\"0 0 0\"");
  const Problems problems = test::refusal(robot.urdf, robot.config);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "robot.yaml drives 'crank_1_joint', 'crank_2_joint', 'crank_3_joint', but the closed mechanism "
            "of robot.urdf "
            "has mobility 4, and the platform still moves with the drives locked; list more actuated_joints, "
            "or mend "
            "closures that hold too little.");
}

TEST(RefusedMechanism, HasALegWithoutDrive) {
  Description robot = shipped_text("three_rrr");
  robot.config = replaced(robot.config, "[crank_1_joint, crank_2_joint, crank_3_joint]",
                          "[crank_1_joint, crank_2_joint]");
  robot.config = replaced(robot.config, "task_space: SE2", "task_space: T2");
  const Problems expected{
      "robot.yaml drives none of the joints 'crank_3_joint', 'elbow_3_joint', which make one leg; add one of "
      "them to "
      "actuated_joints, or take the leg out of the URDF."};
  EXPECT_EQ(test::refusal(robot.urdf, robot.config), expected);
}

TEST(RefusedMechanism, HasAStrutThatMissesItsEnds) {
  Description robot = shipped_text("bipod");
  robot.urdf = replaced(robot.urdf, "<child link=\"bar_2\"/>\n    <origin xyz=\"0 0 0\"/>",
                        "<child link=\"bar_2\"/>\n    <origin xyz=\"0 0.5 0\"/>");
  const Problems expected{
      "robot.urdf has a leg through 'pivot_2_joint', 'strut_2_joint', 'tool - bar_2_tip' that is a strut "
      "whose slide does "
      "not point from one end joint to the other; it is not a distance leg and cannot be treated."};
  EXPECT_EQ(test::refusal(robot.urdf, robot.config), expected);
}

TEST(RefusedMechanism, HasUnequalParallelRods) {
  Description robot = shipped_text("delta");
  robot.urdf = replaced(robot.urdf, "<child link=\"rod_2_left_tip\"/>\n    <origin xyz=\"0 0 -0.8\"/>",
                        "<child link=\"rod_2_left_tip\"/>\n    <origin xyz=\"0 0 -0.7\"/>");
  EXPECT_FALSE(test::refusal(robot.urdf, robot.config).empty());
}

}  // namespace
}  // namespace parallel_aspects
