// SPDX-License-Identifier: BSD-3-Clause
#include "draw/page/outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

PageLine square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

TEST(Outlines, SquaresBesideEachOtherAreOne) {
  const auto loops = outlines_of({square(0, 0, 1), square(1, 0, 1), square(0, 1, 1), square(1, 1, 1)});
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops.front().size(), 5U) << "corners alone";
  EXPECT_DOUBLE_EQ(area_of(loops), 4.0);
}

TEST(Outlines, HolesStayHoles) {
  std::vector<PageLine> ring;
  for (int i = 0; i < 9; ++i)
    if (i != 4) ring.push_back(square(i % 3, i / 3, 1));
  EXPECT_DOUBLE_EQ(area_of(outlines_of(ring)), 8.0);
}

// Any set of cells of a grid, each as a square or as two triangles: the outline has the area of the cells.
TEST(Outlines, KeepTheArea) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::vector<PageLine> polygons;
    double area = 0.0;
    for (int cell = 0; cell < 400; ++cell) {
      if (random() % 3 == 0) continue;
      const PageLine all = square(5.0 * (cell % 20), 5.0 * (cell / 20), 5.0);
      area += 25.0;
      if (random() % 2 == 0) {
        polygons.push_back(all);
      } else {
        polygons.push_back({all[0], all[1], all[2]});
        polygons.push_back({all[0], all[2], all[3]});
      }
    }
    EXPECT_NEAR(area_of(outlines_of(polygons)), area, 1e-6) << "seed " << seed;
  }
}

TEST(Outlines, PiecesInAnyOrderAreOneLine) {
  std::vector<std::pair<PagePoint, PagePoint>> pieces;
  for (int i = 0; i < 100; ++i) {
    const auto at = [](int k) { return PagePoint(k, 30.0 * std::sin(0.05 * k)); };
    pieces.emplace_back(at(i), at(i + 1));
    if (i % 3 == 0) std::swap(pieces.back().first, pieces.back().second);
  }
  std::shuffle(pieces.begin(), pieces.end(), std::mt19937(3));
  const auto lines = joined_lines(pieces);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT(lines.front().size(), 60U) << "what is straight is left out";
  EXPECT_NEAR(std::abs((lines.front().front() - lines.front().back()).x()), 100.0, 0.02);
}

TEST(Outlines, ALabelGoesWhereItHasMostRoom) {
  std::vector<PageLine> polygons;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      if (i < 5 || j == 0) polygons.push_back(square(i, j, 1));
  const auto point = label_point(polygons, outlines_of(polygons));
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->at.x(), 2.5, 0.51);
  EXPECT_NEAR(point->clearance, 2.5, 0.1);
  EXPECT_FALSE(label_point({}, {}));
}

}  // namespace
}  // namespace parallel_aspects
