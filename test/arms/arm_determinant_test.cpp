// SPDX-License-Identifier: BSD-3-Clause
#include "arms/arm_determinant.h"

#include "parallel_aspects/model/problems.h"

#include <gtest/gtest.h>

#include "arms/arms_by_table.h"
#include "arms/joint_segment.h"

namespace parallel_aspects {
namespace {

using test::quarter;

std::vector<std::size_t> sizes(const ArmDeterminant& determinant) {
  std::vector<std::size_t> counts;
  for (const FactorGroup& group : determinant.groups) counts.push_back(group.joints.size());
  return counts;
}

std::size_t factor_count(const ArmDeterminant& determinant) {
  std::size_t count = 0;
  for (const FactorGroup& group : determinant.groups) count += group.factors.size();
  return count;
}

TEST(ArmDeterminant, FactorsAsKnown) {
  const auto of = [](const ArmDescription& description) { return arm_determinant(SerialArm(description)); };
  EXPECT_EQ(sizes(of(test::planar_2r())), (std::vector<std::size_t>{1}));
  EXPECT_EQ(sizes(of(test::scara())), (std::vector<std::size_t>{1}));
  EXPECT_EQ(sizes(of(test::puma_560())), (std::vector<std::size_t>{2, 1}));
  EXPECT_EQ(factor_count(of(test::puma_560())), 3U);
  EXPECT_EQ(sizes(of(test::ur5())), (std::vector<std::size_t>{3, 1}));
  EXPECT_EQ(factor_count(of(test::ur5())), 3U);
  EXPECT_EQ(sizes(of(test::jaco())), (std::vector<std::size_t>{4}));
  const SerialArm planar(test::planar_2r());
  EXPECT_EQ(text_of(arm_determinant(planar).groups.at(0).factors.at(0), planar), "sin(q2)");
}

// Against det J by numbers, from axes and points, which knows nothing of polynomials.
TEST(ArmDeterminant, HasTheSignOfTheJacobianAtRandomJointValues) {
  std::mt19937 random(7);
  for (const ArmDescription& description :
       {test::planar_2r(), test::planar_3r(), test::scara(), test::orthogonal_3r(), test::puma_560(),
        test::ur5(), test::jaco()}) {
    const SerialArm arm(description);
    const JointSegments segments(arm, arm_determinant(arm));
    for (int k = 0; k < 20000; ++k) {
      const Eigen::VectorXd q = test::random_joints(arm, random);
      const double value = arm.jacobian(q).determinant();
      const auto signs = segments.signs(q);
      if (std::abs(value) < 1e-9) continue;
      ASSERT_TRUE(signs) << arm.name() << " " << q.transpose();
      ASSERT_EQ(segments.determinant_sign(*signs), value > 0.0 ? 1 : -1)
          << arm.name() << " " << q.transpose();
    }
  }
}

// The Jacobian against differences of frames.
TEST(SerialArm, JacobianIsTheDerivative) {
  std::mt19937 random(3);
  const SerialArm arm(test::jaco());
  const Eigen::VectorXd q = test::random_joints(arm, random);
  for (Eigen::Index i = 0; i < 6; ++i) {
    Eigen::VectorXd after = q, before = q;
    after[i] += 1e-6;
    before[i] -= 1e-6;
    const Eigen::Vector3d velocity = (arm.tip(after).translation() - arm.tip(before).translation()) / 2e-6;
    EXPECT_LT((velocity - arm.jacobian(q).col(i).head<3>()).norm(), 1e-8);
  }
}

// What CAD rounds: a quarter turn as 1.5708, and an axis 3 micrometres off.
TEST(SerialArm, RoundedDescriptionsFactorToo) {
  ArmDescription rounded = test::described_by("rounded", {{0, 0, 1.5708},
                                                          {0, 0.4318, 0.00001},
                                                          {0.15005, 0.0203, -1.5708},
                                                          {0.4318, 0.000003, 1.5708},
                                                          {0.000002, 0, -1.5708},
                                                          {0, 0, 0}});
  const SerialArm arm(rounded);
  EXPECT_EQ(sizes(arm_determinant(arm)), (std::vector<std::size_t>{2, 1}));
  EXPECT_FALSE(arm.notes().empty());
}

TEST(SerialArm, RedundantArmsAreRefused) {
  ArmDescription seven = test::ur5();
  seven.axes.push_back(seven.axes.back());
  EXPECT_THROW(SerialArm{seven}, InvalidDescription);
  ArmDescription four = test::orthogonal_3r();
  four.axes.push_back(four.axes.front());
  EXPECT_THROW(SerialArm{four}, InvalidDescription);
}

TEST(JointSegments, JacoChangesItsSolutionWithoutSingularity) {
  const SerialArm arm(test::jaco());
  const JointSegments segments(arm, arm_determinant(arm));
  Eigen::VectorXd from(6), to(6);
  from << -3.1201, 0.7082, 1.4904, 2.62, -1.9637, -1.8817;
  to << 2.4730, 0.0943, 2.0281, -1.4916, -2.4244, 2.4362;
  EXPECT_LT((arm.tip(from).matrix() - arm.tip(to).matrix()).norm(), 1e-3);
  EXPECT_EQ(segments.verdict(from, to).has_singularity, std::make_optional(false));
  EXPECT_EQ(segments.signs(from), segments.signs(to));
}

// Every yes is tried by det J at many places of the segment.
TEST(JointSegments, NoProvedSegmentChangesItsSign) {
  std::mt19937 random(11);
  const SerialArm arm(test::jaco());
  const JointSegments segments(arm, arm_determinant(arm));
  int proved = 0;
  for (int k = 0; k < 300; ++k) {
    const Eigen::VectorXd from = test::random_joints(arm, random),
                          to = from + 0.5 * test::random_joints(arm, random);
    const auto verdict = segments.verdict(from, to).has_singularity;
    if (!verdict || *verdict) continue;
    ++proved;
    const double sign = arm.jacobian(from).determinant();
    for (int i = 0; i <= 200; ++i)
      ASSERT_GT(arm.jacobian(from + (to - from) * i / 200.0).determinant() * sign, 0.0) << from.transpose();
  }
  EXPECT_GT(proved, 20);
}

}  // namespace
}  // namespace parallel_aspects
