// SPDX-License-Identifier: BSD-3-Clause
#include "tools/paths/path_ends.h"

#include "parallel_aspects/kinematics/inverse.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <cmath>
#include <string>

namespace parallel_aspects::tools {
namespace {

std::shared_ptr<const Manipulator> five_bar_within(double lower, double upper) {
  ManipulatorDescription description = test::five_bar()->description();
  description.legs[0].limits = JointLimits{lower, upper};
  return std::make_shared<const Manipulator>(description);
}

std::string joints_text(const Manipulator& robot, double turns) {
  const JointVector q = inverse(robot, Pose::planar(4.5, 8.0), *WorkingMode::from_signs({1, 1})).q;
  return std::to_string(q[0] + turns * 2.0 * EIGEN_PI) + " " + std::to_string(q[1]);
}

PathEnd parsed(const Manipulator& robot, double turns, Problems& problems) {
  PathEndArguments arguments;
  arguments.pose = "4.5 8";
  arguments.joints = joints_text(robot, turns);
  return parse_path_end("--from", robot, arguments, problems);
}

TEST(PathEnds, KeepTheTurnOfAnglesWithoutLimits) {
  Problems problems;
  const PathEnd end = parsed(*test::five_bar(), 2.0, problems);
  EXPECT_TRUE(problems.empty());
  ASSERT_TRUE(end.q);
  EXPECT_NEAR((*end.q)[0], 0.48348 + 4.0 * EIGEN_PI, 1e-4);
}

// The one turn in which limits have the leg there is told.
TEST(PathEnds, RefuseATurnThatLimitsExclude) {
  const auto robot = five_bar_within(-3.0, 3.0);
  Problems problems;
  parsed(*robot, 0.0, problems);
  EXPECT_TRUE(problems.empty());
  parsed(*robot, 1.0, problems);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("limits are -3 to 3 rad; give 0.48348"), std::string::npos) << problems[0];
}

TEST(PathEnds, RefuseNumbersBeyondProofs) {
  PathEndArguments arguments;
  arguments.pose = "4.5 8";
  arguments.joints = "1e13 0";
  Problems problems;
  parse_path_end("--from", *test::five_bar(), arguments, problems);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("1e+13"), std::string::npos) << problems[0];
}

}  // namespace
}  // namespace parallel_aspects::tools
