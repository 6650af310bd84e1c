// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/file/map_key.h"

#include <gtest/gtest.h>

#include "support/robots/constrained_robots.h"
#include "support/robots/robots.h"
#include <functional>
#include <variant>
#include <vector>

namespace parallel_aspects {
namespace {

TEST(ConstraintKey, HoldsAllOfTheConstraints) {
  const Constraints before = test::all_kinds(test::five_bar(), 0.01);
  const std::vector<std::function<void(Constraints&)>> changes{
      [](Constraints& c) { c.thickness.crank *= 2.0; },
      [](Constraints& c) { c.thickness.platform.reset(); },
      [](Constraints& c) { c.passive_limits[0].limits.upper += 0.1; },
      [](Constraints& c) { c.passive_limits[1].angle = PassiveAngle::crank_to_rod; },
      [](Constraints& c) { c.cones.pop_back(); },
      [](Constraints& c) { c.cones[0].angle += 1e-12; },
      [](Constraints& c) { c.cones[0].axis.x() += 1e-12; },
      [](Constraints& c) { c.cones[0].leg = 1; },
      [](Constraints& c) { c.cones[0].end = LegEnd::base; },
      [](Constraints& c) {
        c.passive_cones.push_back({"joint", c.cones[0]});
      },
      [](Constraints& c) { c.self_collision.reset(); },
      [](Constraints& c) {
        c.self_collision->ignored.push_back({LinkName{}, LinkName{LinkKind::rod, 1}});
      },
      [](Constraints& c) { std::get<BallObstacle>(c.obstacles[0].shape).radius += 1e-12; },
      [](Constraints& c) { std::get<BoxObstacle>(c.obstacles[1].shape).half_size.x() += 1e-12; },
      [](Constraints& c) { c.workspace->lower.y() -= 1e-12; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Constraints after = before;
    changes[i](after);
    EXPECT_NE(constraint_key(after), constraint_key(before)) << i;
  }
  EXPECT_EQ(constraint_key(Constraints{}), "");
}

}  // namespace
}  // namespace parallel_aspects
