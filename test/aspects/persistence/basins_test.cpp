// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <gtest/gtest.h>

#include "support/index_at.h"
#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using Robot = std::shared_ptr<const Manipulator>;

/// A map of two coordinates with the pose of each pair of their values.
struct PlaneOfPoses {
  const char* name;
  std::function<Robot()> make;
  test::Held held;  // of a slice; empty for a map
};

/// The widest path on a grid, by code of its own: the largest index that a path of neighbouring grid points
/// can keep, each of eight being a neighbour.
class EightNeighbours {
 public:
  EightNeighbours(const AspectMap& map, const WorkingMode& mode, int sign, ParallelIndex index, int count)
      : map_(map),
        count_(count),
        values_(static_cast<std::size_t>(count) * static_cast<std::size_t>(count), 0.0) {
    const Manipulator& robot = *map.manipulator();
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < count; ++k) {
        const InverseSolution found = inverse(robot, pose(i, k), mode);
        if (found.status != InverseStatus::solved || !robot.within_limits(found.q)) continue;
        const test::IndexAt at(robot, pose(i, k), found.q);
        if (at.signed_determinant() * sign <= 0.0L) continue;
        values_[place(i, k)] =
            static_cast<double>(index == ParallelIndex::normalised ? at.parallel() : at.determinant());
      }
  }

  Pose pose(int i, int k) const {
    const Box region = map_.region();
    const auto at = [&](std::size_t axis, int step) {
      return region.lower[axis] + region.width(axis) * (step + 0.5) / count_;
    };
    const double x = at(0, i), y = at(1, k);
    if (!map_.slice()) return Pose::planar(x, y);
    Pose pose = map_.slice()->held;
    const double values[] = {x, y};
    for (std::size_t c = 0, next = 0; c < 3; ++c)
      if (map_.slice()->moves[c]) pose.position[static_cast<Eigen::Index>(c)] = values[next++];
    return pose;
  }

  double value(int i, int k) const { return values_[place(i, k)]; }

  /// Points are added by falling value, until the two are joined.
  double widest(std::size_t from, std::size_t to) const {
    std::vector<std::size_t> order(values_.size()), parent(values_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::iota(parent.begin(), parent.end(), 0U);
    std::sort(order.begin(), order.end(),
              [this](std::size_t a, std::size_t b) { return values_[a] > values_[b]; });
    const std::function<std::size_t(std::size_t)> root = [&parent](std::size_t item) {
      while (parent[item] != item) item = parent[item] = parent[parent[item]];
      return item;
    };
    std::vector<bool> is_there(values_.size(), false);
    for (const std::size_t item : order) {
      if (!(values_[item] > 0.0)) return 0.0;
      is_there[item] = true;
      const auto i = static_cast<int>(item) / count_, k = static_cast<int>(item) % count_;
      for (int a = std::max(0, i - 1); a <= std::min(count_ - 1, i + 1); ++a)
        for (int b = std::max(0, k - 1); b <= std::min(count_ - 1, k + 1); ++b)
          if (is_there[place(a, b)]) parent[root(place(a, b))] = root(item);
      if (is_there[from] && is_there[to] && root(from) == root(to)) return values_[item];
    }
    return 0.0;
  }

  /// The largest value that is reached from the point nearest to a pose on paths above a level.
  double largest_from(double x, double y, double level) const {
    const auto step = [&](std::size_t axis, double value) {
      const Box region = map_.region();
      return std::clamp(static_cast<int>((value - region.lower[axis]) / region.width(axis) * count_), 0,
                        count_ - 1);
    };
    std::vector<bool> is_there(values_.size(), false);
    std::vector<std::pair<int, int>> open{{step(0, x), step(1, y)}};
    double largest = 0.0;
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (is_there[place(i, k)] || !(value(i, k) > level)) continue;
      is_there[place(i, k)] = true;
      largest = std::max(largest, value(i, k));
      // Diagonal neighbours could be across a gap.
      if (i > 0) open.emplace_back(i - 1, k);
      if (i + 1 < count_) open.emplace_back(i + 1, k);
      if (k > 0) open.emplace_back(i, k - 1);
      if (k + 1 < count_) open.emplace_back(i, k + 1);
    }
    return largest;
  }

  std::size_t place(int i, int k) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(count_) + static_cast<std::size_t>(k);
  }

 private:
  const AspectMap& map_;
  int count_;
  std::vector<double> values_;
};

/// Whether the bounds are as near to each other as they are meant to be.
bool is_precise(const IndexRange& range, ParallelIndex index) {
  const double absolute = index == ParallelIndex::normalised ? 0.001 : 0.0;
  return range.upper - range.lower <= std::max(0.05 * range.upper, absolute);
}

class BasinsTest : public testing::TestWithParam<PlaneOfPoses> {
 protected:
  void SetUp() override {
    const Robot robot = GetParam().make();
    MapOptions options;
    if (!GetParam().held.empty()) options.slice = test::slice_of(robot, GetParam().held);
    options.modes = {WorkingMode(robot->leg_count())};
    map = compute_aspect_map(robot, options).map;
    ASSERT_TRUE(map);
  }

  std::shared_ptr<const AspectMap> map;
};

TEST_P(BasinsTest, BottlenecksAreThoseOfAGrid) {
  const int count = test::is_sanitized ? 100 : 700;
  const WorkingMode mode(map->manipulator()->leg_count());
  std::mt19937_64 random{7};
  for (const ParallelIndex index : {ParallelIndex::normalised, ParallelIndex::determinant}) {
    const EightNeighbours grid(*map, mode, map->aspects().front().determinant_sign, index, count);
    const auto draw = [&] {
      for (int i = 0; i < 1000000; ++i) {
        const int a = static_cast<int>(random() % count), b = static_cast<int>(random() % count);
        if (grid.value(a, b) > 0.0 && map->locate(grid.pose(a, b), mode)) return std::pair(a, b);
      }
      return std::pair(0, 0);
    };
    for (int n = 0; n < test::thinned(10); ++n) {
      const auto from = draw(), to = draw();
      const Pose first = grid.pose(from.first, from.second), second = grid.pose(to.first, to.second);
      const Bottleneck found = find_bottleneck(*map, mode, first, second, index);
      const double expected =
          grid.widest(grid.place(from.first, from.second), grid.place(to.first, to.second));
      const std::string what = to_string(map->manipulator()->task_space(), first) + " to " +
                               to_string(map->manipulator()->task_space(), second);
      if (found.status == BottleneckStatus::separate) {
        EXPECT_EQ(expected, 0.0) << what;
        continue;
      }
      ASSERT_EQ(found.status, BottleneckStatus::found) << found.message;
      // A grid misses the best path by a cell.
      const double scale = index == ParallelIndex::normalised ? 1.0 : map->manipulator()->size();
      const double coarse = 0.02 * (expected + 0.01 * scale);
      EXPECT_LE(found.index.lower, expected + coarse) << what;
      EXPECT_GE(found.index.upper, expected - coarse) << what;
      EXPECT_TRUE(is_precise(found.index, index))
          << what << ": " << found.index.lower << " to " << found.index.upper;
    }
  }
}

// A search that may do little ends with wider bounds, which hold.
TEST(Basins, BoundedSearchesEnd) {
  const auto map = compute_aspect_map(test::five_bar()).map;
  ASSERT_TRUE(map);
  const Pose from = Pose::planar(2.43, 6.3), to = Pose::planar(5.58, 10.12);
  const auto found = [&](const BottleneckPrecision& precision) {
    return find_bottleneck(*map, WorkingMode(2), from, to, ParallelIndex::normalised, precision);
  };
  const Bottleneck fine = found({});
  ASSERT_EQ(fine.status, BottleneckStatus::found);
  for (const BottleneckPrecision& little :
       {BottleneckPrecision{0.05, 0.001, 0, 2000000}, {0.05, 0.001, 400000, 0}}) {
    const Bottleneck coarse = found(little);
    ASSERT_EQ(coarse.status, BottleneckStatus::found);
    EXPECT_LT(coarse.halved, fine.halved);
    EXPECT_LE(coarse.index.lower, fine.index.upper);
    EXPECT_GE(coarse.index.upper, fine.index.lower);
  }
}

// Also where the largest index is at a serial singularity, in undecided leaves.
TEST(Basins, BoundTheLargestIndexOfEveryAspect) {
  for (const auto& robot :
       {test::five_bar(), test::bipod(), test::five_bar()->with_margins({0.1, 0.05, 0.0})}) {
    const auto map = compute_aspect_map(robot).map;
    ASSERT_TRUE(map);
    for (const ParallelIndex index : {ParallelIndex::normalised, ParallelIndex::determinant}) {
      const auto basins = find_basins(*map, index, BasinDetail::depths);
      ASSERT_TRUE(basins);
      for (const IndexRange& range : basins->deepest)
        EXPECT_TRUE(is_precise(range, index)) << robot->name() << ' ' << range.lower << " to " << range.upper;
    }
  }
}

// Of the five-bar also the mode with the shallow aspect, whose largest index is at a serial singularity.
TEST(Basins, EndAtSerialSingularities) {
  const Robot robot = test::five_bar();
  MapOptions options;
  options.modes = {*WorkingMode::from_signs({-1, 1})};
  const auto map = compute_aspect_map(robot, options).map;
  ASSERT_TRUE(map);
  const auto basins = find_basins(*map, ParallelIndex::normalised, BasinDetail::basins);
  ASSERT_TRUE(basins);
  bool found = false;
  for (const Basin& basin : basins->basins) {
    if (basin.deeper || basin.depth.lower > 0.7) continue;
    found = true;
    const EightNeighbours grid(*map, options.modes[0], -1, ParallelIndex::normalised, 1000);
    // The deepest pose is so near to the singularity that the next point of the grid is out of reach.
    const Pose& within = map->aspects()[static_cast<std::size_t>(basin.aspect - 1)].deepest;
    const double largest = grid.largest_from(within.position.x(), within.position.y(), 0.02);
    EXPECT_GT(largest, 0.55);
    EXPECT_LE(largest, basin.depth.upper);
    const InverseSolution solution = inverse(*robot, basin.deepest, options.modes[0]);
    ASSERT_EQ(solution.status, InverseStatus::solved);
    EXPECT_GE(parallel_index(*robot, basin.deepest, solution.q), basin.depth.lower - 1e-9);
  }
  EXPECT_TRUE(found);
}

// Halved cells of this robot show a peak that belongs to no aspect of its map.
TEST(Basins, BelongToAspectsOfTheMap) {
  const auto map = compute_aspect_map(test::bounded_robot(9, TaskSpace::T2, true)).map;
  ASSERT_TRUE(map);
  const auto basins = find_basins(*map, ParallelIndex::normalised, BasinDetail::basins);
  ASSERT_TRUE(basins);
  EXPECT_FALSE(basins->basins.empty());
  for (const Basin& basin : basins->basins) {
    EXPECT_GE(basin.aspect, 1);
    EXPECT_LE(basin.aspect, static_cast<int>(map->aspects().size()));
  }
}

TEST_P(BasinsTest, NoPoseIsDeeperThanItsAspect) {
  const auto basins = find_basins(*map, ParallelIndex::normalised, BasinDetail::basins);
  ASSERT_TRUE(basins);
  const WorkingMode mode(map->manipulator()->leg_count());
  std::vector<double> largest(map->aspects().size(), 0.0);
  const EightNeighbours grid(*map, mode, 1, ParallelIndex::normalised, 150),
      other(*map, mode, -1, ParallelIndex::normalised, 150);
  for (int i = 0; i < 150; ++i)
    for (int k = 0; k < 150; ++k) {
      const Location at = map->locate(grid.pose(i, k), mode);
      if (!at) continue;
      double& known = largest[static_cast<std::size_t>(at.aspect - 1)];
      known = std::max({known, grid.value(i, k), other.value(i, k)});
    }
  for (std::size_t i = 0; i < largest.size(); ++i) {
    EXPECT_LE(largest[i], basins->deepest[i].upper + 1e-12);
    EXPECT_LE(basins->deepest[i].lower, basins->deepest[i].upper);
    EXPECT_GT(basins->deepest[i].lower, 0.0);
  }
  for (const Basin& basin : basins->basins) {
    const InverseSolution found = inverse(*map->manipulator(), basin.deepest, mode);
    ASSERT_EQ(found.status, InverseStatus::solved);
    EXPECT_GE(parallel_index(*map->manipulator(), basin.deepest, found.q), basin.depth.lower - 1e-12);
    if (!map->slice()) {
      const int sign = map->aspects()[static_cast<std::size_t>(basin.aspect - 1)].determinant_sign;
      const EightNeighbours fine(*map, mode, sign, ParallelIndex::normalised, 600);
      const double level = basin.deeper ? basin.saddle.upper : 0.02;
      EXPECT_LE(fine.largest_from(basin.deepest.position.x(), basin.deepest.position.y(), level),
                basin.depth.upper + 1e-12);
    }
    if (!basin.deeper) continue;
    EXPECT_LT(basin.saddle.upper, basin.depth.lower);
    EXPECT_LE(basin.saddle.lower, basin.saddle.upper);
    const Basin& deeper = basins->basins[*basin.deeper];
    const Bottleneck between =
        find_bottleneck(*map, mode, basin.deepest, deeper.deepest, ParallelIndex::normalised);
    if (between.status != BottleneckStatus::found) continue;
    EXPECT_LE(between.index.lower, basin.saddle.upper);
    EXPECT_GE(between.index.upper, basin.saddle.lower);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, BasinsTest,
                         testing::Values(PlaneOfPoses{"five_bar", test::five_bar, {}},
                                         PlaneOfPoses{"three_rrr", test::three_rrr, {{"phi", 0.3}}},
                                         PlaneOfPoses{"delta", test::delta, {{"z", -0.6}}}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace parallel_aspects
