// SPDX-License-Identifier: BSD-3-Clause
#include "motion/shortest_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double no_edge = std::numeric_limits<double>::infinity();

/// Points in the plane, some of which edges join that are at least as long as they are apart.
class Plane {
 public:
  explicit Plane(std::mt19937_64& random, std::size_t count)
      : points_(count), edges_(count, std::vector<double>(count, no_edge)) {
    std::uniform_real_distribution<double> number(0.0, 1.0);
    for (auto& point : points_) point = {number(random), number(random)};
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (number(random) < 0.15) edges_[a][b] = edges_[b][a] = between(a, b) * (1.0 + number(random));
  }

  std::size_t count() const { return points_.size(); }
  double edge(std::size_t a, std::size_t b) const { return edges_[a][b]; }
  double between(std::size_t a, std::size_t b) const {
    return std::hypot(points_[a][0] - points_[b][0], points_[a][1] - points_[b][1]);
  }

  /// By the algorithm of Floyd and Warshall.
  std::vector<std::vector<double>> all_distances() const {
    auto result = edges_;
    for (std::size_t i = 0; i < count(); ++i) result[i][i] = 0.0;
    for (std::size_t via = 0; via < count(); ++via)
      for (std::size_t a = 0; a < count(); ++a)
        for (std::size_t b = 0; b < count(); ++b)
          result[a][b] = std::min(result[a][b], result[a][via] + result[via][b]);
    return result;
  }

  /// Cost and nodes of the path to the goal, by A* or, without a bound, by Dijkstra's algorithm.
  std::pair<double, std::vector<std::size_t>> path(std::size_t from, std::size_t goal, bool bounded,
                                                   std::size_t& taken) const {
    ShortestPaths<double> paths;
    paths.enter(from, no_graph_node, 0.0);
    std::size_t at = paths.take();
    for (; at != no_graph_node && at != goal; at = paths.take(), ++taken)
      for (std::size_t next = 0; next < count(); ++next)
        if (edge(at, next) < no_edge) {
          const double cost = paths.cost(at) + edge(at, next);
          paths.enter(next, at, cost, bounded ? cost + between(next, goal) : cost);
        }
    if (at == no_graph_node) return {no_edge, {}};
    return {paths.cost(at), paths.path_to(at)};
  }

 private:
  std::vector<std::array<double, 2>> points_;
  std::vector<std::vector<double>> edges_;
};

double length_along(const Plane& plane, const std::vector<std::size_t>& path) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += plane.edge(path[i], path[i + 1]);
  return length;
}

TEST(ShortestPaths, AreThoseOfAnotherAlgorithm) {
  std::mt19937_64 random(20261129);
  std::size_t taken = 0, taken_with_bound = 0, joined = 0;
  for (int i = 0; i < 50; ++i) {
    const Plane plane(random, 25);
    const auto distances = plane.all_distances();
    for (std::size_t goal = 1; goal < plane.count(); ++goal) {
      SCOPED_TRACE("graph " + std::to_string(i) + ", goal " + std::to_string(goal));
      const auto [cost, path] = plane.path(0, goal, false, taken);
      const auto [same, other] = plane.path(0, goal, true, taken_with_bound);
      EXPECT_EQ(path.empty(), distances[0][goal] == no_edge);
      EXPECT_EQ(other.empty(), path.empty());
      if (path.empty() || other.empty()) continue;
      ++joined;
      EXPECT_NEAR(cost, distances[0][goal], 1e-12);
      EXPECT_NEAR(same, cost, 1e-12);
      EXPECT_NEAR(length_along(plane, path), cost, 1e-12);
      EXPECT_NEAR(length_along(plane, other), cost, 1e-12);
      EXPECT_EQ(path.front(), 0U);
      EXPECT_EQ(path.back(), goal);
    }
  }
  EXPECT_GT(joined, 100U);
  EXPECT_LT(taken_with_bound, taken);
}

TEST(ShortestPaths, PreferTheWiderAndOfTheseTheShorter) {
  ShortestPaths<WidthAndLength> paths;
  EXPECT_TRUE(paths.enter(0, no_graph_node, {3.0, 0.0}));
  EXPECT_TRUE(paths.enter(1, 0, {1.0, 1.0}));
  EXPECT_TRUE(paths.enter(1, 0, {2.0, 9.0}));
  EXPECT_FALSE(paths.enter(1, 0, {2.0, 9.0}));
  EXPECT_TRUE(paths.enter(1, 0, {2.0, 8.0}));
  EXPECT_FALSE(paths.enter(1, 0, {1.0, 0.0}));
  EXPECT_EQ(paths.take(), 0U);
  EXPECT_EQ(paths.take(), 1U);
  EXPECT_FALSE(paths.enter(1, 0, {3.0, 0.0}));
  EXPECT_EQ(paths.take(), no_graph_node);
  EXPECT_EQ(paths.cost(1).length, 8.0);
}

TEST(ProvedEdges, AreAskedForOnceAndBarredWhereTheyFail) {
  ProvedEdges edges;
  int asked = 0;
  const auto prove = [&asked](std::size_t a, std::size_t b) {
    ++asked;
    return std::max(a, b) != 3;
  };
  EXPECT_TRUE(edges.hold({}, prove));
  EXPECT_FALSE(edges.hold({0, 1, 3, 2, 0}, prove));
  EXPECT_EQ(asked, 4);
  EXPECT_TRUE(edges.is_barred(3, 1));
  EXPECT_TRUE(edges.is_barred(2, 3));
  EXPECT_FALSE(edges.is_barred(0, 1));
  EXPECT_TRUE(edges.hold({1, 0, 2}, prove));
  EXPECT_EQ(asked, 4);
}

}  // namespace
}  // namespace parallel_aspects
