// SPDX-License-Identifier: BSD-3-Clause
//
// A map with a tolerance against maps of robots that are built within it.
#include "parallel_aspects/aspects/aspect_map.h"

#include <gtest/gtest.h>

#include "support/robots/robots.h"
#include "support/robots/robots_within.h"
#include "support/thoroughness.h"
#include <map>
#include <random>

namespace parallel_aspects {
namespace {

class MapWithTolerance : public testing::TestWithParam<double> {
 protected:
  const std::shared_ptr<const Manipulator> robot = test::five_bar()->with_tolerance(GetParam());
  const std::shared_ptr<const AspectMap> map = compute_aspect_map(robot).map;
};

// What lies in one component lies in one aspect of every robot within, and no aspect of it holds two
// components that are proved distinct.
TEST_P(MapWithTolerance, HoldsForEveryRobotWithin) {
  ASSERT_TRUE(map);
  EXPECT_GT(map->proved_count(), 0U);
  std::mt19937_64 random(20261123);
  for (int i = 0; i < 5; ++i) {
    const auto built = test::RobotsWithin(robot->tolerance(), random).draw(*robot);
    const auto own = compute_aspect_map(built).map;
    ASSERT_TRUE(own);
    ASSERT_TRUE(own->count_at_most());
    EXPECT_GE(*own->count_at_most(), map->proved_count());
    EXPECT_LE(own->proved_count(), map->count_at_most().value_or(own->proved_count()));
    for (const Aspect& component : map->aspects()) {
      int known = 0;
      map->visit_inside_poses(component.id, [&](const Pose& pose, double) {
        const Location location = own->locate(pose, component.mode);
        if (!location) return;
        if (known == 0) known = location.aspect;
        EXPECT_EQ(location.aspect, known) << component.id;
        EXPECT_EQ(own->aspects()[static_cast<std::size_t>(known - 1)].determinant_sign,
                  component.determinant_sign);
      });
      EXPECT_GT(known, 0) << component.id;
    }
  }
}

TEST_P(MapWithTolerance, LeavesMoreUndecidedThanNone) {
  const auto without = compute_aspect_map(test::five_bar()).map;
  ASSERT_TRUE(map && without);
  EXPECT_GT(map->measure_undecided(), without->measure_undecided());
  EXPECT_EQ(map->symmetry_use()->motions, without->symmetry_use()->motions);
}

INSTANTIATE_TEST_SUITE_P(Shares, MapWithTolerance, testing::Values(1e-3, 1e-2));

}  // namespace
}  // namespace parallel_aspects
