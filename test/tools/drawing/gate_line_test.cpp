// SPDX-License-Identifier: BSD-3-Clause
#include "tools/drawing/gate_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace parallel_aspects::tools {
namespace {

const Eigen::AlignedBox2d wide(PagePoint(-500.0, -500.0), PagePoint(1000.0, 1000.0));

double room(const GateLine& line, const NodeCircle& circle) {
  double least = 1e9;
  for (int i = 0; i <= 1000; ++i)
    least = std::min(least, (line.at(i / 1000.0) - circle.middle).norm() - circle.radius);
  return least;
}

TEST(GateLine, IsStraightWhereNothingIsInTheWay) {
  const std::vector<NodeCircle> circles{{{0.0, 0.0}, 20.0}, {{100.0, 50.0}, 20.0}, {{0.0, 100.0}, 20.0}};
  const auto line = line_between(circles, 0, 1, wide);
  ASSERT_TRUE(line);
  EXPECT_TRUE(line->is_straight());
  EXPECT_EQ(line->at(0.0), circles[0].middle);
  EXPECT_EQ(line->at(1.0), circles[1].middle);
}

TEST(GateLine, GoesAroundCirclesInARow) {
  const std::vector<NodeCircle> circles{
      {{0.0, 0.0}, 20.0}, {{70.0, 0.0}, 24.0}, {{140.0, 0.0}, 9.0}, {{210.0, 0.0}, 20.0}};
  const auto line = line_between(circles, 0, 3, wide);
  ASSERT_TRUE(line);
  EXPECT_FALSE(line->is_straight());
  for (const std::size_t other : {1U, 2U}) EXPECT_GT(room(*line, circles[other]), 3.0);
}

TEST(GateLine, StaysWithinTheBounds) {
  const std::vector<NodeCircle> circles{{{0.0, 0.0}, 9.0}, {{70.0, 0.0}, 9.0}, {{140.0, 0.0}, 9.0}};
  for (const double side : {1.0, -1.0}) {
    const Eigen::AlignedBox2d bounds(PagePoint(-20.0, side > 0.0 ? -2.0 : -90.0),
                                     PagePoint(160.0, side > 0.0 ? 90.0 : 2.0));
    const auto line = line_between(circles, 0, 2, bounds);
    ASSERT_TRUE(line);
    EXPECT_GT(side * line->at(0.5).y(), 12.0);
  }
  EXPECT_FALSE(line_between(circles, 0, 2, {PagePoint(-20.0, -5.0), PagePoint(160.0, 5.0)}));
}

// As many on a circle as a large map has, each joined to each.
TEST(GateLine, FindsItsWayOnACrowdedCircle) {
  constexpr int count = 26;
  std::vector<NodeCircle> circles;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    circles.push_back({300.0 * PagePoint(std::cos(angle), std::sin(angle)), i % 4 == 0 ? 24.0 : 9.0});
  }
  for (std::size_t a = 0; a < circles.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const auto line = line_between(circles, a, b, wide);
      ASSERT_TRUE(line) << a << ' ' << b;
      for (std::size_t other = 0; other < circles.size(); ++other) {
        if (other == a || other == b) continue;
        EXPECT_GT(room(*line, circles[other]), 2.0) << a << ' ' << b;
      }
    }
}

}  // namespace
}  // namespace parallel_aspects::tools
