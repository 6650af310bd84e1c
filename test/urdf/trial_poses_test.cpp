// SPDX-License-Identifier: BSD-3-Clause
// What is said of loops that rounding leaves open.
#include "urdf/description/closure.h"
#include "urdf/mechanism_recognition.h"
#include "urdf/reading/tree_reader.h"

#include <gtest/gtest.h>

#include "support/descriptions.h"
#include <cmath>
#include <regex>
#include <string>

namespace parallel_aspects {
namespace {

// A five-bar whose elbows are tilted, and its base: gaps are along no axis of coordinates.
Description tilted_five_bar() {
  Description robot = test::shipped_text("five_bar");
  robot.change_urdf("<origin xyz=\"5 0 0\"/>", "<origin xyz=\"5 0 0\" rpy=\"0.0003 0.0002 0\"/>");
  robot.change_urdf(
      "</robot>",
      "<link name=\"hall\"/>" + test::fixed_joint("hall", "base_link", "rpy=\"0.6 0.5 0.3\"") + "</robot>");
  robot.change_config("base_link: base_link", "base_link: hall");
  return robot;
}

// At the assembled configuration.
LoopGap gap_of_five_bar(const Description& robot, const Mechanism& mechanism) {
  Problems problems;
  Notes notes;
  const auto tree = read_tree(robot.urdf, "robot.urdf", problems, notes);
  const AssembledConfiguration assembled = mechanism.assembled();
  Eigen::VectorXd positions(tree->variables());
  EXPECT_TRUE(mechanism.complete(assembled.pose, assembled.q, positions));
  const Poses poses = link_poses(*tree, 0, positions);
  const auto &one = poses[*tree->link_named("tool")], &other = poses[*tree->link_named("closing_2")];
  return {(one.translation() - other.translation()).norm(),
          std::asin(one.linear().col(2).cross(other.linear().col(2)).norm())};
}

TEST(TrialPoses, BoundTheGapsOfLoops) {
  const Description robot = tilted_five_bar();
  const auto mechanism = test::load(robot);
  const std::regex words("closes its loops only to within (\\S+) m and (\\S+) rad, as with rounded angles");
  std::smatch said;
  ASSERT_EQ(mechanism->notes().size(), 1U);
  ASSERT_TRUE(std::regex_search(mechanism->notes().front(), said, words)) << mechanism->notes().front();
  const LoopGap gap = gap_of_five_bar(robot, *mechanism);
  EXPECT_GE(std::stod(said.str(1)), gap.distance);
  EXPECT_LT(std::stod(said.str(1)), 0.005) << "elbows of 5 m that are tilted by 0.0004 rad";
  EXPECT_GE(std::stod(said.str(2)), gap.angle);
  EXPECT_LT(std::stod(said.str(2)), 0.001);
}

}  // namespace
}  // namespace parallel_aspects
