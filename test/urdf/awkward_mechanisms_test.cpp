// SPDX-License-Identifier: BSD-3-Clause
#include "model/spherical_links.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include "support/descriptions.h"
#include "support/texts.h"
#include <cmath>
#include <iomanip>
#include <regex>
#include <sstream>

// Robots as people write them: tilted, turned round, rounded, with joints in other places than in the shipped
// files.
namespace parallel_aspects {
namespace {

using test::Description;
using test::fixed_joint;
using test::moving_joint;
using test::replaced;
using test::shipped_text;

const RevoluteActuation& revolute(const Mechanism& mechanism, std::size_t leg) {
  return std::get<RevoluteActuation>(mechanism.manipulator()->leg(leg).actuation);
}

TEST(AwkwardMechanism, StandsInATiltedPlane) {
  Description five_bar = shipped_text("five_bar");
  five_bar.change_urdf("</robot>", "<link name=\"wall\"/>" +
                                       fixed_joint("wall", "base_link", "xyz=\"1 2 3\" rpy=\"0.7 0.3 0.2\"") +
                                       "</robot>");
  five_bar.change_config("base_link: base_link", "base_link: wall");
  const auto mechanism = test::load(five_bar);
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
  five_bar.change_urdf(crank_2 + "1", crank_2 + "-2");
  const std::string elbow_1 = "<origin xyz=\"8 0 0\"/>\n    <axis xyz=\"0 0 ";
  five_bar.change_urdf(elbow_1 + "1", elbow_1 + "-1");
  const auto mechanism = test::load(five_bar);
  EXPECT_NEAR(revolute(*mechanism, 0).axis.z(), 1.0, 1e-12);
  EXPECT_NEAR(revolute(*mechanism, 1).axis.z(), -1.0, 1e-12);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, ReachesItsPlatformThroughLegTwo) {
  Description five_bar = shipped_text("five_bar");
  five_bar.change_config("operational_point: tool", "operational_point: closing_2");
  const auto mechanism = test::load(five_bar);
  EXPECT_EQ(mechanism->manipulator()->leg(1).rod_length, 8.0);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, IsClosedAtTheElbow) {
  Description five_bar = shipped_text("five_bar");
  // Rod 2 is attached to the tool, and the loop is cut between crank 2 and rod 2.
  five_bar.change_urdf("<parent link=\"crank_2\"/>", "<parent link=\"tool\"/>");
  five_bar.change_urdf("<origin xyz=\"5 0 0\"/>\n    <axis", "<origin xyz=\"0 0 0\"/>\n    <axis");
  five_bar.change_urdf(
      "</robot>", "<link name=\"elbow\"/>" + fixed_joint("crank_2", "elbow", "xyz=\"5 0 0\"") + "</robot>");
  five_bar.change_config("[tool, closing_2]", "[elbow, closing_2]");
  const auto mechanism = test::load(five_bar);
  EXPECT_NEAR(revolute(*mechanism, 1).radius, 5.0, 1e-12);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, IsDrivenAtTheElbows) {
  Description five_bar = shipped_text("five_bar");
  five_bar.change_config("[crank_1_joint, crank_2_joint]", "[elbow_1_joint, elbow_2_joint]");
  const auto mechanism = test::load(five_bar);
  for (const std::size_t j : {0, 1}) {
    const auto& actuation = std::get<ElbowActuation>(mechanism->manipulator()->leg(j).actuation);
    EXPECT_NEAR(actuation.inner_length, j == 0 ? 8.0 : 5.0, 1e-12);
    EXPECT_NEAR(actuation.outer_length, j == 0 ? 5.0 : 8.0, 1e-12);
    EXPECT_NEAR(std::remainder(actuation.angle_at_zero, 2.0 * EIGEN_PI), 0.0, 1e-12);
  }
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// The file is read from its end, so that children come before parents and joints before links.
TEST(AwkwardMechanism, HasItsElementsInAnyOrder) {
  Description five_bar = shipped_text("five_bar");
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(five_bar.urdf.c_str()), tinyxml2::XML_SUCCESS);
  auto* robot = document.FirstChildElement("robot");
  auto* last = robot->LastChild();
  while (robot->FirstChild() != last) robot->InsertAfterChild(last, robot->FirstChild());
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  const auto mechanism = test::load(printer.CStr(), five_bar.config);
  const std::vector<std::string> expected{"elbow_2_joint", "crank_2_joint", "elbow_1_joint", "crank_1_joint"};
  EXPECT_EQ(mechanism->joint_names(), expected);
  EXPECT_EQ(mechanism->manipulator()->leg(0).actuated_joint, "crank_1_joint");
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, HasAToolThatSpinsIdly) {
  Description five_bar = shipped_text("five_bar");
  five_bar.change_urdf("<joint name=\"tool_joint\" type=\"fixed\">",
                       "<joint name=\"tool_joint\" type=\"continuous\"><axis xyz=\"0 0 1\"/>");
  const auto mechanism = test::load(five_bar);
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T2);
  EXPECT_EQ(mechanism->mobility(), 3);
  EXPECT_EQ(mechanism->idle_degrees_of_freedom(), 1);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// A wrist after the platform and a column under the base are moved by others.
TEST(AwkwardMechanism, HasSerialJointsBeforeAndAfter) {
  Description robot = shipped_text("three_rrr");
  robot.change_urdf("</robot>",
                    "<link name=\"column\"/><link name=\"wrist\"/>" +
                        moving_joint("column_joint", "column", "base_link", "1 0 0", "xyz=\"0 0 5\"") +
                        moving_joint("wrist_joint", "platform", "wrist", "0 1 0", "xyz=\"3 0 0\"") +
                        "</robot>");
  const auto mechanism = test::load(robot);
  EXPECT_EQ(mechanism->mobility(), 3);
  EXPECT_TRUE(mechanism->manipulator()->task_frame().isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  EXPECT_EQ(mechanism->joint_names().size(), 9u);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, HasAPlatformInTwoPiecesThatAreWelded) {
  Description robot = shipped_text("three_rrr");
  robot.change_urdf(
      "<joint name=\"platform_2_joint\" type=\"fixed\">\n    <parent link=\"platform\"/>\n    <child "
      "link=\"platform_2\"/>\n    <origin xyz=\"10 0 0\"/>",
      "<joint name=\"platform_2_joint\" type=\"continuous\">\n    <parent link=\"rod_2\"/>\n    <child "
      "link=\"platform_2\"/>\n    <origin xyz=\"10 0 0\"/>\n    <axis xyz=\"0 0 1\"/>");
  robot.change_urdf("</robot>", "<link name=\"corner\"/>" +
                                    fixed_joint("platform_2", "corner", "xyz=\"-10 0 0\"") + "</robot>");
  robot.change_config("[platform_2, rod_2_tip], type: revolute", "[platform, corner], type: fixed");
  const auto mechanism = test::load(robot);
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SE2);
  EXPECT_NEAR((mechanism->manipulator()->leg(1).anchor - Eigen::Vector3d(10, 0, 0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

TEST(AwkwardMechanism, FindsTheTypeOfAWeldByItself) {
  Description robot = shipped_text("agile_eye");
  robot.change_config("type: revolute", "type: auto");
  const auto mechanism = test::load(robot);
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SO3);
  ASSERT_EQ(mechanism->notes().size(), 1u);
  EXPECT_TRUE(test::has(mechanism->notes().front(), "taken as point"));
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// Rods with ball joints at both ends turn about themselves.
TEST(AwkwardMechanism, HasRodsThatSpin) {
  Description robot = shipped_text("hexa");
  for (const char* leg : {"1", "2", "3", "4", "5", "6"}) {
    const std::string rod = std::string("rod_") + leg, cross = std::string("cross_") + leg;
    robot.change_urdf("<parent link=\"" + cross + "\"/>", "<parent link=\"" + rod + "_spin\"/>");
    robot.change_urdf("</robot>", "<link name=\"" + rod + "_spin\"/>" +
                                      moving_joint(rod + "_spin_joint", cross, rod + "_spin", "0 0 1") +
                                      "</robot>");
  }
  const auto mechanism = test::load(robot);
  EXPECT_EQ(mechanism->mobility(), 12);
  EXPECT_EQ(mechanism->idle_degrees_of_freedom(), 6);
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SE3);
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
}

// The platform carries rod 2 on its ball joint, and the loop is cut in the universal joint on the crank.
TEST(AwkwardMechanism, IsClosedInAUniversalJoint) {
  Description robot = shipped_text("hexa");
  robot.change_urdf("<parent link=\"crank_2\"/>", "<parent link=\"platform_2\"/>");
  robot.change_urdf("<child link=\"cross_2\"/>\n    <origin xyz=\"0.25 0 0\"/>\n    <axis xyz=\"0 1 0\"/>",
                    "<child link=\"cross_2\"/>\n    <origin xyz=\"0 0 0\"/>\n    <axis xyz=\"0 1 0\"/>");
  robot.change_urdf("<parent link=\"cross_2\"/>", "<parent link=\"spin_2\"/>");
  robot.change_urdf("</robot>",
                    "<link name=\"spin_2\"/><link name=\"fork\"/>" +
                        moving_joint("spin_2_joint", "cross_2", "spin_2", "0 0 1") +
                        fixed_joint("crank_2", "fork", "xyz=\"0.25 0 0\" rpy=\"1.5707963267948966 0 0\"") +
                        "</robot>");
  robot.change_config("[platform_2, rod_2_tip], type: spherical", "[fork, rod_2_tip], type: universal");
  const auto mechanism = test::load(robot);
  EXPECT_EQ(mechanism->mobility(), 6);
  EXPECT_NEAR(mechanism->manipulator()->leg(1).rod_length, 0.6, 1e-9);
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
}

// The origins of the two joints of a universal joint are apart, but their axes meet.
TEST(AwkwardMechanism, HasUniversalJointsWhoseOriginsAreApart) {
  Description robot = shipped_text("stewart");
  robot.change_urdf("<origin xyz=\"1.2 0 0\"/>\n    <axis xyz=\"1 0 0\"/>",
                    "<origin xyz=\"0.9 0 0\"/>\n    <axis xyz=\"1 0 0\"/>");
  for (const char* leg : {"1", "2", "3", "4", "5", "6"}) {
    const std::string child = std::string("<child link=\"cylinder_") + leg + "\"/>\n    <origin xyz=\"";
    robot.change_urdf(child + "0 0 0", child + "0.3 0 0");
  }
  const auto mechanism = test::load(robot);
  for (const Leg& leg : mechanism->manipulator()->legs())
    EXPECT_NEAR(std::get<StrutActuation>(leg.actuation).base.norm(), 1.2, 1e-9);
  EXPECT_EQ(test::open_loops(*mechanism, 0.1), 0);
}

TEST(AwkwardMechanism, HasJointsThatItsLoopsHoldStill) {
  const auto mechanism = test::load(test::five_bar_with_still_joints());
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T2);
  EXPECT_EQ(mechanism->mobility(), 2);
  EXPECT_NEAR(mechanism->manipulator()->leg(0).rod_length, 5.0, 1e-9);
  EXPECT_NEAR(mechanism->manipulator()->leg(1).rod_length, 8.0, 1e-9);
  ASSERT_EQ(mechanism->notes().size(), 1u);
  EXPECT_EQ(mechanism->notes().front(),
            "The loops of robot.urdf hold joints still, which are taken as fixed: 'swing_joint', "
            "'ball_1_joint', 'ball_2_joint'.");
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// At zero, on the limit, the leg is stretched: no place to take ranks.
TEST(AwkwardMechanism, HasItsZeroOnALimitOfAPassiveJoint) {
  Description robot = shipped_text("three_rrr");
  const std::string elbow = "<joint name=\"elbow_1_joint\" type=\"";
  robot.change_urdf(
      elbow + "continuous\">",
      elbow + "revolute\">\n    <limit lower=\"0\" upper=\"2.5\" effort=\"1\" velocity=\"1\"/>");
  const auto mechanism = test::load(robot);
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::SE2);
  EXPECT_EQ(mechanism->manipulator()->leg_count(), 3U);
}

// Zero is a limit of every joint, and there the loop holds the slide still everywhere.
TEST(AwkwardMechanism, HasAStillJointOnItsLimit) {
  std::string urdf = test::source_file("test/data/setup/jawed_five_bar.urdf");
  urdf = replaced(urdf, "<axis xyz=\"1 0 0\"/>", "<axis xyz=\"0 0 1\"/>");
  urdf = std::regex_replace(
      urdf, std::regex("type=\"continuous\">"),
      "type=\"revolute\"><limit lower=\"0\" upper=\"6.2831\" effort=\"1\" velocity=\"1\"/>");
  const auto mechanism =
      test::load(urdf,
                 "mechanism: {operational_point: biela_der_fin, actuated_joints: [motor_izq, motor_der], "
                 "closures: [{frames: [biela_der_fin, dedo], type: point}]}");
  EXPECT_EQ(mechanism->manipulator()->task_space(), TaskSpace::T2);
  EXPECT_NEAR(mechanism->manipulator()->leg(0).rod_length, 0.25, 1e-9);
  EXPECT_TRUE(test::has(mechanism->notes().front(), "hold joints still, which are taken as fixed: 'pinza'"));
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// Four digits, as people write them.
TEST(AwkwardMechanism, HasRoundedAngles) {
  Description five_bar = shipped_text("five_bar");
  const std::string crank_2 =
      "<child link=\"crank_2\"/>\n    <origin xyz=\"9 0 0\"/>\n    <axis xyz=\"0 0 1\"/>";
  five_bar.change_urdf(crank_2,
                       "<child link=\"crank_2\"/>\n    <origin xyz=\"9 0 0\" rpy=\"1.57075 0 0\"/>\n    "
                       "<axis xyz=\"0 -1 0\"/>");
  five_bar.change_urdf("<origin xyz=\"5 0 0\"/>\n    <axis xyz=\"0 0 1\"/>",
                       "<origin xyz=\"5 0 0\" rpy=\"-1.57075 0 0\"/>\n    <axis xyz=\"0 0 1\"/>");
  const auto mechanism = test::load(five_bar);
  EXPECT_NEAR(revolute(*mechanism, 1).radius, 5.0, 1e-3);
  EXPECT_NEAR(revolute(*mechanism, 1).axis.z(), -1.0, 1e-12);
  EXPECT_EQ(test::open_loops(*mechanism), 0);
}

// Every number of an attribute with so many digits.
std::string with_digits(const std::string& urdf, const std::string& attribute, int digits) {
  std::string result;
  std::size_t from = 0;
  const std::string start = attribute + "=\"";
  for (std::size_t at = urdf.find(start); at != std::string::npos; at = urdf.find(start, from)) {
    at += start.size();
    const std::size_t end = urdf.find('"', at);
    std::istringstream numbers(urdf.substr(at, end - at));
    std::ostringstream text;
    text << std::setprecision(digits);
    for (double number = 0.0; numbers >> number;) text << number << ' ';
    result += urdf.substr(from, at - from) + text.str();
    from = end;
  }
  return result + urdf.substr(from);
}

// Its links are angles, whatever rounding leaves of where its axes meet.
TEST(AwkwardMechanism, HasAxesThatMeetToWithinItsDigits) {
  const std::string urdf = test::source_file("test/data/chains/wrist_of_long_numbers.urdf");
  for (const int digits : {5, 6, 7, 9, 12, 17}) {
    const auto mechanism =
        test::load(with_digits(with_digits(urdf, "xyz", digits), "rpy", digits),
                   "mechanism: {operational_point: tool, actuated_joints: [motor_1, motor_2, motor_3]}");
    const Manipulator& wrist = *mechanism->manipulator();
    ASSERT_TRUE(moves_on_unit_sphere(wrist)) << digits;
    const double off = 30.0 * std::pow(0.1, digits) + 1e-12;
    for (const Leg& leg : wrist.legs()) {
      EXPECT_NEAR(leg.anchor.norm(), 1.0, 1e-13) << digits;
      EXPECT_NEAR(spherical_links(leg)->crank, EIGEN_PI / 3.0, off) << digits;
      EXPECT_NEAR(spherical_links(leg)->rod, EIGEN_PI / 2.4, off) << digits;
    }
    EXPECT_EQ(test::open_loops(*mechanism), 0) << digits;
  }
}

}  // namespace
}  // namespace parallel_aspects
