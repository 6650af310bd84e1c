// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

const auto robot = test::five_bar();

Pose at(double x, double y) {
  Pose pose;
  pose.position << x, y, 0.0;
  return pose;
}

WorkingMode mode(int s1, int s2) { return *WorkingMode::from_signs({s1, s2}); }

// The paper writes the elbow as q = atan2(.) + s acos(.); then B11 = L1 L2 sin(theta3 - theta1) has the sign
// of -s.
TEST(FiveBar, InverseSolutionsOfTheReferencePose) {
  const InverseSolution plus_plus = inverse(*robot, at(4.5, 8.0), mode(-1, -1));
  ASSERT_EQ(plus_plus.status, InverseStatus::solved);
  EXPECT_NEAR(plus_plus.q[0], 1.633334, 1e-6);
  EXPECT_NEAR(plus_plus.q[1], 3.138465, 1e-6);
  const InverseSolution plus_minus = inverse(*robot, at(4.5, 8.0), mode(-1, 1));
  EXPECT_NEAR(plus_minus.q[0], 1.633334, 1e-6);
  EXPECT_NEAR(plus_minus.q[1], 1.027907, 1e-6);
}

TEST(FiveBar, OutOfReachNamesTheLeg) {
  const InverseSolution solution = inverse(*robot, at(0.0, 2.0), mode(1, 1));
  EXPECT_EQ(solution.status, InverseStatus::out_of_reach);
  EXPECT_EQ(solution.leg, 0U);
}

TEST(FiveBar, RoundTripInEveryModeFindsThePoseAndItsSigns) {
  std::mt19937 random(20260101);
  std::uniform_real_distribution<double> coordinate(-13.0, 22.0);
  int solved = 0;
  for (int i = 0; i < 20000; ++i) {
    const Pose pose = at(coordinate(random), coordinate(random));
    for (const InverseSolution& solution : inverse_in_all_modes(*robot, pose)) {
      if (solution.status != InverseStatus::solved) continue;
      ++solved;
      SCOPED_TRACE("at(" + std::to_string(pose.position.x()) + ", " + std::to_string(pose.position.y()) +
                   "), mode " + to_string(solution.mode));
      EXPECT_EQ(working_mode(*robot, pose, solution.q), solution.mode);
      const DirectResult assembled = direct(*robot, solution.q);
      ASSERT_EQ(assembled.solutions.size(), 2U);
      double closest = 1e9;
      for (const AssemblyMode& each : assembled.solutions)
        closest = std::min(closest, (each.pose.position - pose.position).norm());
      EXPECT_LT(closest, assembled.solutions[0].near_singular ? 1e-5 : 1e-8);
    }
  }
  EXPECT_GT(solved, 10000);
}

TEST(FiveBar, MatricesMatchTheFormulasOfThePaper) {
  const InverseSolution solution = inverse(*robot, at(4.5, 8.0), mode(1, -1));
  const Eigen::Vector2d p(4.5, 8.0), c = robot->leg(0).proximal_point(solution.q[0]).head<2>(),
                                     d = robot->leg(1).proximal_point(solution.q[1]).head<2>();
  const double theta3 = std::atan2(p.y() - c.y(), p.x() - c.x());
  const double theta4 = std::atan2(p.y() - d.y(), p.x() - d.x());
  const TaskVector b = inverse_diagonal(*robot, at(4.5, 8.0), solution.q);
  EXPECT_NEAR(b[0], 8.0 * 5.0 * std::sin(theta3 - solution.q[0]), 1e-12);
  EXPECT_NEAR(b[1], 5.0 * 8.0 * std::sin(theta4 - solution.q[1]), 1e-12);
  const Eigen::Vector2d u = p - c, v = p - d;
  EXPECT_NEAR(direct_determinant(*robot, at(4.5, 8.0), solution.q), u.x() * v.y() - u.y() * v.x(), 1e-12);
}

}  // namespace
}  // namespace parallel_aspects
