// SPDX-License-Identifier: BSD-3-Clause
#include "arms/joint_map.h"

#include <gtest/gtest.h>

#include "arms/arms_by_table.h"
#include "arms/joint_segment.h"

namespace parallel_aspects {
namespace {

// The number of aspects, if it is proved exactly; else 0.
std::size_t proved_aspects(const ArmDescription& description, double resolution = 0x1p-5) {
  const SerialArm arm(description);
  std::size_t count = 1;
  for (const FactorGroup& group : arm_determinant(arm).groups) {
    const JointMap map(arm, group, resolution, {});
    const bool is_exact = map.count_at_most() == map.proved_count();
    count *= is_exact ? map.proved_count() : 0;
  }
  return count;
}

TEST(JointMap, CountsAspects) {
  EXPECT_EQ(proved_aspects(test::planar_2r()), 2U);
  EXPECT_EQ(proved_aspects(test::planar_3r()), 2U);
  EXPECT_EQ(proved_aspects(test::scara()), 2U);
  EXPECT_EQ(proved_aspects(test::orthogonal_3r()), 2U);
  EXPECT_EQ(proved_aspects(test::puma_560()), 8U);
  EXPECT_EQ(proved_aspects(test::ur5()), 8U);
}

TEST(JointMap, LimitsCutAspects) {
  ArmDescription within = test::planar_2r();
  within.axes[1].limits.lower = 0.2;
  within.axes[1].limits.upper = 2.0;
  EXPECT_EQ(proved_aspects(within), 1U);
  within.axes[1].limits.lower = -4.0;  // from beyond half a turn: two ranges of positive sines
  EXPECT_EQ(proved_aspects(within), 3U);
}

TEST(JointMap, MeasuresOfTheOrthogonalArm) {
  const SerialArm arm(test::orthogonal_3r());
  const ArmDeterminant determinant = arm_determinant(arm);
  const JointMap map(arm, determinant.groups.at(0), 0x1p-9, {});
  const double half = 2.0 * half_turn * half_turn;
  ASSERT_EQ(map.components().size(), 2U);
  for (const JointComponent& each : map.components()) {
    EXPECT_LE(each.measure, half);
    EXPECT_GE(each.measure + map.undecided(), half);
    EXPECT_NEAR(each.measure, half, 0.2);
  }
}

// Joint values are in the component of their signs, which are those of det J.
TEST(JointMap, PlacesRandomJointValues) {
  std::mt19937 random(9);
  const SerialArm arm(test::puma_560());
  const ArmDeterminant determinant = arm_determinant(arm);
  const JointSegments segments(arm, determinant);
  std::vector<std::shared_ptr<const JointMap>> maps;
  for (const FactorGroup& group : determinant.groups)
    maps.push_back(std::make_shared<const JointMap>(arm, group, 0x1p-5, MapControl{}));
  for (int k = 0; k < 20000; ++k) {
    const Eigen::VectorXd q = test::random_joints(arm, random);
    const double value = arm.jacobian(q).determinant();
    if (std::abs(value) < 1e-6) continue;
    std::vector<int> signs;
    for (const auto& map : maps) {
      const auto component = map->component_at(q);
      ASSERT_TRUE(component) << q.transpose();
      const std::size_t of_component = map->components()[*component].signs;
      for (std::size_t i = 0; i < map->group().factors.size(); ++i)
        signs.push_back((of_component >> i & 1U) != 0 ? 1 : -1);
    }
    ASSERT_EQ(segments.determinant_sign(signs), value > 0.0 ? 1 : -1) << q.transpose();
  }
}

}  // namespace
}  // namespace parallel_aspects
