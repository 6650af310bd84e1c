// SPDX-License-Identifier: BSD-3-Clause
// Triangles of polygons against their areas by the shoelace formula, and against crossings of rays.
#include "draw/surface/plane_polygons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;
using Triangle = std::array<std::uint32_t, 3>;

/// Outer loops and holes, each around a middle with random radii.
struct Drawing {
  std::vector<Vector2d> points;
  std::vector<PlaneLoop> loops;

  void add(const Vector2d& middle, double radius, std::size_t corners, double turn, std::mt19937& random) {
    PlaneLoop loop;
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle = turn * 2.0 * EIGEN_PI * static_cast<double>(i) / static_cast<double>(corners);
      const double share = std::uniform_real_distribution<double>(0.5, 1.0)(random);
      loop.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(middle + share * radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    loops.push_back(std::move(loop));
  }
};

Drawing random_drawing(unsigned seed) {
  std::mt19937 random(seed);
  Drawing drawing;
  drawing.add({0.0, 0.0}, 10.0, 40, 1.0, random);
  drawing.add({2.0, 1.0}, 1.2, 12, -1.0, random);
  drawing.add({-2.0, -0.5}, 1.5, 9, -1.0, random);
  drawing.add({0.5, -2.3}, 1.1, 20, -1.0, random);
  drawing.add({30.0, 0.0}, 5.0, 7, 1.0, random);
  drawing.add({2.0, 1.0}, 0.5, 6, 1.0, random);  // an island in a hole
  return drawing;
}

double area(const std::vector<Triangle>& triangles, const std::vector<Vector2d>& points) {
  double sum = 0.0;
  for (const Triangle& each : triangles) sum += doubled_area({each[0], each[1], each[2]}, points);
  return 0.5 * sum;
}

TEST(PlanePolygons, TrianglesHaveTheAreaOfTheLoops) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Drawing drawing = random_drawing(seed);
    const auto triangles = triangles_of(drawing.loops, drawing.points);
    double loops = 0.0;
    for (const PlaneLoop& loop : drawing.loops) loops += 0.5 * doubled_area(loop, drawing.points);
    EXPECT_NEAR(area(triangles, drawing.points), loops, 1e-9) << "seed " << seed;
    for (const Triangle& each : triangles)
      EXPECT_GE(doubled_area({each[0], each[1], each[2]}, drawing.points), -1e-9) << "seed " << seed;
  }
}

TEST(PlanePolygons, EdgesOfLoopsHaveOneTriangleAndOthersTwo) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Drawing drawing = random_drawing(seed);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Triangle& each : triangles_of(drawing.loops, drawing.points))
      for (std::size_t i = 0; i < 3; ++i) ++uses[{each[i], each[(i + 1) % 3]}];
    for (const PlaneLoop& loop : drawing.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        EXPECT_EQ(uses.erase({loop[i], loop[(i + 1) % loop.size()]}), 1U) << "seed " << seed;
    for (const auto& [edge, count] : uses)
      EXPECT_EQ(uses.count({edge.second, edge.first}), 1U) << "seed " << seed;
  }
}

TEST(PlanePolygons, LoopsThatRoundingCrossedStillHaveAllTheirTriangles) {
  std::mt19937 random(7);
  std::vector<Vector2d> points;
  PlaneLoop loop;
  for (std::uint32_t i = 0; i < 30; ++i) {
    loop.push_back(i);
    points.emplace_back(std::uniform_real_distribution<double>()(random),
                        std::uniform_real_distribution<double>()(random));
  }
  EXPECT_EQ(triangles_of({loop}, points).size(), 28U);
}

}  // namespace
}  // namespace parallel_aspects
