// SPDX-License-Identifier: BSD-3-Clause
#include "ask/question_parts.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/texts.h"
#include <cmath>
#include <string>

namespace parallel_aspects::ask {
namespace {

std::shared_ptr<const Manipulator> five_bar_within(double lower, double upper) {
  ManipulatorDescription description = test::five_bar()->description();
  description.legs[0].limits = JointLimits{lower, upper};
  return std::make_shared<const Manipulator>(description);
}

const Pose at = Pose::planar(4.5, 8.0);

/// Beside the pose the values that hold it, the first so many turns on.
EndQuestion end_after(const Manipulator& robot, double turns) {
  EndQuestion question;
  question.pose = at;
  question.joints = inverse(robot, at, *WorkingMode::from_signs({1, 1})).q;
  (*question.joints)[0] += turns * 2.0 * EIGEN_PI;
  return question;
}

TEST(PathEnds, KeepTheTurnOfAnglesWithoutLimits) {
  ProblemList problems;
  const auto robot = test::five_bar();
  const PathEnd end = path_end("start", *robot, end_after(*robot, 2.0), problems);
  EXPECT_TRUE(problems.empty());
  ASSERT_TRUE(end.q);
  EXPECT_NEAR((*end.q)[0], 0.48348 + 4.0 * EIGEN_PI, 1e-4);
}

// The one turn in which limits have the leg there is told.
TEST(PathEnds, RefuseATurnThatLimitsExclude) {
  const auto robot = five_bar_within(-3.0, 3.0);
  ProblemList problems;
  path_end("start", *robot, end_after(*robot, 0.0), problems);
  EXPECT_TRUE(problems.empty());
  path_end("start", *robot, end_after(*robot, 1.0), problems);
  ASSERT_EQ(problems.size(), 1U);
  const std::string text = text_of(problems[0], plain_name);
  EXPECT_TRUE(test::has(text, "limits are -3 to 3 rad; give 0.48348"));
}

TEST(PathEnds, RefuseNumbersBeyondProofs) {
  EndQuestion question;
  question.pose = at;
  question.joints = JointVector(Eigen::Vector2d(1e13, 0.0));
  ProblemList problems;
  path_end("start", *test::five_bar(), question, problems);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].field, "start_joints");
  EXPECT_TRUE(test::has(problems[0].fault, "1e+13"));
}

}  // namespace
}  // namespace parallel_aspects::ask
