// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/connectivity.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "support/configuration_at.h"
#include "support/robots/robots.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cstdint>
#include <functional>
#include <iostream>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;
using Values = std::vector<float>;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;  // of grid points

const int count = test::is_sanitized ? 200 : 2000;  // of grid points along each coordinate

struct Planes {
  const char* name;
  std::function<Robot()> make;
  test::Held held;  // of a slice; empty for a map
};

/// The widest paths on a grid of two coordinates, by code of the test alone. They bound the bottleneck from
/// both sides:
///  - A path along edges of the grid is a path of the robot. What it keeps is looked up between the points,
///    too, at a tenth of the grid's steps. The bottleneck is no less.
///  - Every path of the robot runs through squares about grid points, from each to one of its eight
///    neighbours. Where the index is monotone over three squares it is in none larger than at the largest of
///    the grid points around. The bottleneck is no more than what such a chain of squares keeps.
class Grid {
 public:
  Grid(const AspectMap& map, const WorkingMode& mode, int sign)
      : map_(map), mode_(mode), sign_(sign), values_(static_cast<std::size_t>(count) * count) {
    tbb::parallel_for(0, count, [this](int i) {
      for (int k = 0; k < count; ++k) values_[place(i, k)] = static_cast<float>(index(i, k));
    });
  }

  /// Anywhere, in steps of the grid. 0 out of S(mode, sign).
  double index(double i, double k) const {
    const test::ConfigurationAt<double> at(*map_.manipulator(), pose(i, k), mode_);
    if (!at.reaches() || !(at.within_limits() > 0.0)) return 0.0;
    return std::max(0.0, sign_ * at.parallel());
  }

  Pose pose(double i, double k) const {
    const Box region = map_.region();
    const double x = region.lower[0] + region.width(0) * (i + 0.5) / count,
                 y = region.lower[1] + region.width(1) * (k + 0.5) / count;
    if (!map_.slice()) return Pose::planar(x, y);
    Pose pose = map_.slice()->held;
    const double values[] = {x, y};
    for (std::size_t c = 0, next = 0; c < 3; ++c)
      if (map_.slice()->moves[c]) pose.position[static_cast<Eigen::Index>(c)] = values[next++];
    return pose;
  }
  Pose pose(std::size_t point) const { return pose(row(point), column(point)); }

  /// A point in an aspect, with at least this share of the largest index.
  std::size_t draw(std::mt19937_64& random, float share) const {
    const float least = share * *std::max_element(values_.begin(), values_.end());
    for (int n = 0; n < 1000000; ++n) {
      const std::size_t point = random() % values_.size();
      if (values_[point] > least && map_.locate(pose(point), mode_)) return point;
    }
    ADD_FAILURE() << "no pose found";
    return 0;
  }

  /// What the best paths along edges keep, by pair; 0 without one.
  std::vector<double> below(const Pairs& pairs) const {
    std::vector<double> result;
    const std::vector<float> levels = joined(values_, pairs, 4);
    for (std::size_t n = 0; n < pairs.size(); ++n)
      result.push_back(levels[n] > 0.0F ? kept(path(pairs[n], levels[n])) : 0.0);
    return result;
  }

  /// What no path of the robot keeps more than.
  std::vector<float> above(const Pairs& pairs) const {
    Values largest(values_.size());
    tbb::parallel_for(0, count, [&](int i) {
      for (int k = 0; k < count; ++k) {
        float& here = largest[place(i, k)];
        visit_near(place(i, k), 8, [&](std::size_t near) { here = std::max(here, values_[near]); });
        here = std::max(here, values_[place(i, k)]);
      }
    });
    return joined(largest, pairs, 8);
  }

 private:
  static std::size_t place(int i, int k) {
    return static_cast<std::size_t>(i) * count + static_cast<std::size_t>(k);
  }
  static int row(std::size_t point) { return static_cast<int>(point) / count; }
  static int column(std::size_t point) { return static_cast<int>(point) % count; }

  template <class Visit>
  static void visit_near(std::size_t point, int neighbours, const Visit& visit) {
    const int i = row(point), k = column(point);
    for (int a = std::max(0, i - 1); a <= std::min(count - 1, i + 1); ++a)
      for (int b = std::max(0, k - 1); b <= std::min(count - 1, k + 1); ++b)
        if ((neighbours == 8 || a == i || b == k) && (a != i || b != k)) visit(place(a, b));
  }

  /// The level at which the points of each pair are joined first, as points are added by falling value.
  static std::vector<float> joined(const Values& values, const Pairs& pairs, int neighbours) {
    std::vector<std::uint32_t> order(values.size()), parent(values.size());
    std::iota(order.begin(), order.end(), 0U);
    std::iota(parent.begin(), parent.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return values[a] > values[b]; });
    const auto root = [&parent](std::uint32_t item) {
      while (parent[item] != item) item = parent[item] = parent[parent[item]];
      return item;
    };
    std::vector<float> levels(pairs.size(), 0.0F);
    for (const std::uint32_t item : order) {
      const float value = values[item];
      if (!(value > 0.0F)) break;
      visit_near(item, neighbours, [&](std::size_t near) {
        if (values[near] > value || (values[near] == value && near < item))
          parent[root(static_cast<std::uint32_t>(near))] = root(item);
      });
      for (std::size_t n = 0; n < pairs.size(); ++n)
        if (levels[n] == 0.0F && values[pairs[n].first] >= value && values[pairs[n].second] >= value &&
            root(static_cast<std::uint32_t>(pairs[n].first)) ==
                root(static_cast<std::uint32_t>(pairs[n].second)))
          levels[n] = value;
    }
    return levels;
  }

  /// Along edges, through points of this value or more.
  std::vector<std::size_t> path(const std::pair<std::size_t, std::size_t>& ends, float level) const {
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> before(values_.size(), none);
    std::vector<std::size_t> queue{ends.first};
    before[ends.first] = static_cast<std::uint32_t>(ends.first);
    for (std::size_t next = 0; next < queue.size() && before[ends.second] == none; ++next)
      visit_near(queue[next], 4, [&](std::size_t near) {
        if (before[near] != none || values_[near] < level) return;
        before[near] = static_cast<std::uint32_t>(queue[next]);
        queue.push_back(near);
      });
    std::vector<std::size_t> path{ends.second};
    while (path.back() != ends.first) path.push_back(before[path.back()]);
    return path;
  }

  /// The least value along a path, looked up between its points, too.
  double kept(const std::vector<std::size_t>& path) const {
    double least = index(row(path.front()), column(path.front()));
    for (std::size_t n = 0; n + 1 < path.size(); ++n)
      for (int part = 1; part <= 10; ++part) {
        const double share = 0.1 * part;
        least = std::min(least, index(row(path[n]) + share * (row(path[n + 1]) - row(path[n])),
                                      column(path[n]) + share * (column(path[n + 1]) - column(path[n]))));
      }
    return least;
  }

  const AspectMap& map_;
  WorkingMode mode_;
  int sign_;
  Values values_;
};

class WidestPathTest : public testing::TestWithParam<Planes> {};

TEST_P(WidestPathTest, IsWithinTheBottleneck) {
  const Robot robot = GetParam().make();
  MapOptions options;
  if (!GetParam().held.empty()) options.slice = test::slice_of(robot, GetParam().held);
  const WorkingMode mode(robot->leg_count());
  options.modes = {mode};
  const auto map = compute_aspect_map(robot, options).map;
  ASSERT_TRUE(map);
  const Grid grid(*map, mode, map->aspects().front().determinant_sign);
  std::mt19937_64 random{11};
  Pairs pairs;
  // Between deep ones the path narrows on the way, between others mostly at its ends.
  for (int n = 0; n < 10; ++n) {
    const float share = n % 2 == 0 ? 0.0F : 0.7F;
    pairs.emplace_back(grid.draw(random, share), grid.draw(random, share));
  }
  const std::vector<double> below = grid.below(pairs);
  const std::vector<float> above = grid.above(pairs);
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const Pose from = grid.pose(pairs[n].first), to = grid.pose(pairs[n].second);
    const Bottleneck found = find_bottleneck(*map, mode, from, to, ParallelIndex::normalised);
    const std::string what =
        to_string(robot->task_space(), from) + " to " + to_string(robot->task_space(), to);
    std::cout << what << ": grid " << below[n] << " to " << above[n] << ", proved " << found.index.lower
              << " to " << found.index.upper << ", halved " << found.halved << '\n';
    if (found.status == BottleneckStatus::separate) {
      EXPECT_EQ(below[n], 0.0) << what;
      continue;
    }
    ASSERT_EQ(found.status, BottleneckStatus::found) << what << found.message;
    EXPECT_LE(below[n], found.index.upper + 1e-9) << what;
    EXPECT_LE(found.index.lower, above[n] + 1e-6) << what;  // values of the grid have seven digits
    EXPECT_LE(found.index.upper - found.index.lower, std::max(0.05 * found.index.upper, 0.001)) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, WidestPathTest,
                         testing::Values(Planes{"five_bar", test::five_bar, {}},
                                         Planes{"three_rrr", test::three_rrr, {{"phi", 0.3}}},
                                         Planes{"delta", test::delta, {{"z", -0.6}}}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace parallel_aspects
