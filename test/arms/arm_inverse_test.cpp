// SPDX-License-Identifier: BSD-3-Clause
#include "arms/arm_inverse.h"

#include <gtest/gtest.h>

#include "arms/arm_cusps.h"
#include "arms/arm_determinant.h"
#include "arms/arms_by_table.h"

namespace parallel_aspects {
namespace {

// The pose of random joint values has these values as a solution, where all solutions are claimed.
void expect_none_missing(const ArmDescription& description, InverseMethod method, std::size_t most,
                         int samples) {
  const SerialArm arm(description);
  ASSERT_EQ(inverse_method(arm), method) << arm.name();
  std::mt19937 random(5);
  for (int k = 0; k < samples; ++k) {
    const Eigen::VectorXd q = test::random_joints(arm, random);
    const Eigen::Isometry3d tip = arm.tip(q);
    const ArmSolutions found = inverse_solutions(arm, tip);
    ASSERT_LE(found.all.size(), most) << arm.name() << " " << q.transpose();
    bool is_there = false;
    for (const ArmSolution& each : found.all) {
      is_there = is_there || test::apart(arm, each.q, q) < 1e-5;
      ASSERT_LT((arm.task_coordinates(arm.tip(each.q)).head(2) - arm.task_coordinates(tip).head(2)).norm(),
                1e-8);
    }
    ASSERT_TRUE(is_there || !found.is_complete) << arm.name() << " " << q.transpose();
  }
}

TEST(ArmInverse, NoneIsMissing) {
  expect_none_missing(test::planar_2r(), InverseMethod::planar, 2, 5000);
  expect_none_missing(test::planar_3r(), InverseMethod::planar, 2, 5000);
  expect_none_missing(test::scara(), InverseMethod::planar, 2, 5000);
  expect_none_missing(test::orthogonal_3r(), InverseMethod::position, 4, 5000);
  expect_none_missing(test::puma_560(), InverseMethod::wrist, 8, 2000);
  expect_none_missing(test::ur5(), InverseMethod::three_parallel, 8, 2000);
}

TEST(ArmInverse, JacoHasTwelveSolutionsOfOnePose) {
  const SerialArm arm(test::jaco());
  Eigen::VectorXd q(6);
  q << -3.1201, 0.7082, 1.4904, 2.62, -1.9637, -1.8817;
  const ArmSolutions found = inverse_solutions(arm, arm.tip(q));
  EXPECT_EQ(found.all.size(), 12U);
  EXPECT_FALSE(found.is_complete);
  int positive = 0;
  for (const ArmSolution& each : found.all) {
    EXPECT_TRUE(each.is_proved);
    positive += arm.jacobian(each.q).determinant() > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(positive, 6);
}

TEST(ArmCusps, OfTheOrthogonalArm) {
  const auto cusps_of = [](const ArmDescription& description) {
    const SerialArm arm(description);
    return arm_cusps(arm, arm_determinant(arm));
  };
  const ArmCusps found = cusps_of(test::orthogonal_3r());
  EXPECT_TRUE(found.is_complete);
  ASSERT_EQ(found.all.size(), 4U);
  int matched = 0;
  for (const ArmCusp& each : found.all)
    for (const auto& [rho, z] : {std::pair{2.46555, 1.99872}, std::pair{1.35549, 0.50467}})
      if (std::abs(each.rho - rho) < 1e-5 && std::abs(std::abs(each.z) - z) < 1e-5) ++matched;
  EXPECT_EQ(matched, 4);
  EXPECT_EQ(cusps_of(test::orthogonal_3r(2.0, 0.19)).all.size(), 0U);
  EXPECT_EQ(cusps_of(test::orthogonal_3r(2.0, 0.21)).all.size(), 4U);
}

}  // namespace
}  // namespace parallel_aspects
