// SPDX-License-Identifier: BSD-3-Clause
// Millimetres, and limits that are divided by 1000: each remedy is followed to the letter.
#include "urdf/corrections/said_of_robots.h"

#include <gtest/gtest.h>

#include "support/texts.h"
#include <algorithm>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using test::Description;
using test::expect_remedies_work;
using test::has_note;
using test::sentence;
using test::shipped_text;

std::string with_limits_times(double factor, std::string urdf, const std::string& joint) {
  const auto scale = [&](const std::string& key) {
    const std::size_t at =
        urdf.find(key + "=\"", urdf.find("<joint name=\"" + joint + "\"")) + key.size() + 2;
    const std::size_t end = urdf.find('"', at);
    urdf.replace(at, end - at, std::to_string(factor * std::stod(urdf.substr(at, end - at))));
  };
  scale("lower");
  scale("upper");
  return urdf;
}

std::string in_millimetres(const std::string& urdf, const std::string& joint) {
  return with_limits_times(1000.0, urdf, joint);
}

TEST(Units, OfLimitsAreNotAThousandthOfMetres) {
  for (const int count : {1, 6}) {
    Description robot = shipped_text("stewart");
    for (int k = 1; k <= count; ++k)
      robot.urdf = with_limits_times(1e-3, robot.urdf, "strut_" + std::to_string(k) + "_joint");
    const std::string said = sentence(robot);
    EXPECT_TRUE(test::begins(said, "robot.urdf is 2.35 m wide, but has limits of slides, 'strut_1_joint'"));
    EXPECT_TRUE(test::has(
        said, ", as if divided by 1000; write lower=\"1.1\" upper=\"1.9\" for joint 'strut_1_joint'"));
    EXPECT_EQ(test::remedies(said).size(), static_cast<std::size_t>(count));
    expect_remedies_work(robot, said);
  }
  Description robot = shipped_text("three_prr");
  robot.urdf = with_limits_times(1e-3, robot.urdf, "slider_1_joint");
  EXPECT_TRUE(has_note(robot,
                       "robot.urdf is 1.39 m wide, but has limits of slides, 'slider_1_joint', as if divided "
                       "by 1000; if so, write lower=\"-1.2\" upper=\"1.2\" for joint 'slider_1_joint'."));
}

TEST(Units, OfLimitsAreMetres) {
  Description robot = shipped_text("stewart");
  robot.urdf = in_millimetres(robot.urdf, "strut_1_joint");
  EXPECT_EQ(sentence(robot),
            "robot.urdf is 2.35 m wide, but has limits of slides, 'strut_1_joint', as if in millimetres; "
            "write lower=\"1.1\" upper=\"1.9\" for joint 'strut_1_joint', which makes it a robot in SE3.");
  robot = shipped_text("three_prr");
  robot.urdf = in_millimetres(robot.urdf, "slider_1_joint");
  const auto notes = test::load(robot)->notes();
  EXPECT_EQ(
      std::count_if(
          notes.begin(), notes.end(),
          [](const std::string& note) {
            return note.find(
                       "limits of slides, 'slider_1_joint', as if in millimetres; if so, write lower=") !=
                   std::string::npos;
          }),
      1);
}

TEST(Units, OfOneLengthAreNamedByItsJoint) {
  Description robot = shipped_text("bipod");
  robot.change_urdf("<origin xyz=\"5 0 0\"/>", "<origin xyz=\"5000 0 0\"/>");
  EXPECT_EQ(sentence(robot),
            "robot.urdf is 5e+03 m wide, as if in millimetres; write xyz=\"5 0 0\" in the origin of joint "
            "'pivot_2_joint', which makes it a robot in T2.");
}

// Half of the lengths of a five-bar are those of one leg.
TEST(Units, OfALegAreMetres) {
  Description robot = shipped_text("five_bar");
  for (const auto& [joint, xyz] : {std::pair<const char*, const char*>{"crank_2_joint", "9"},
                                   {"elbow_2_joint", "5"},
                                   {"closing_2_joint", "8"}}) {
    const std::string length = std::string("\"") + xyz + " 0 0\"";
    const std::size_t at =
        robot.urdf.find(length, robot.urdf.find(std::string("<joint name=\"") + joint + "\""));
    ASSERT_NE(at, std::string::npos) << joint;
    robot.urdf.insert(at + 2, "000");
  }
  const std::string said = sentence(robot);
  EXPECT_EQ(said.rfind("robot.urdf has origins of joints far beyond the others, 'crank_2_joint', "
                       "'elbow_2_joint', 'closing_2_joint', as if in millimetres; write xyz=\"9 0 0\"",
                       0),
            0U)
      << said;
  expect_remedies_work(robot, said);
}

TEST(Units, OfARobotAreMetres) {
  Description robot = shipped_text("five_bar");
  for (const std::string length : {"9", "8", "5"})
    for (std::size_t at = 0; (at = robot.urdf.find("\"" + length + " 0 0\"", at)) != std::string::npos;)
      robot.urdf.replace(at, length.size() + 6, "\"" + length + "000 0 0\"");
  const auto notes = test::load(robot)->notes();
  EXPECT_EQ(std::count(notes.begin(), notes.end(),
                       "robot.urdf is 2.2e+04 m wide, as if in millimetres; if so, write a thousandth of "
                       "each xyz in the origins of its joints."),
            1);
}

// A length in millimetres makes a robot so large that all legs seem to be in one place.
TEST(Units, OfOneOriginAreNotThoseOfAnotherLeg) {
  Description hexapod{test::source_file("test/data/setup/isaac_stewart.urdf"),
                      "mechanism: {operational_point: top_plate}\n"};
  hexapod.change_urdf("\"-0.104188907 0.590884652 0\"", "\"-104.188907 590.884652 0\"");
  EXPECT_EQ(sentence(hexapod),
            "robot.urdf puts the origin of joint 'universal_x_2' at (-104.188907, 590.884652, 0) m, as if in "
            "millimetres; write xyz=\"-0.104188907 0.590884652 0\" in the origin of joint 'universal_x_2', "
            "which makes it a robot in SE3.");
}

}  // namespace
}  // namespace parallel_aspects
