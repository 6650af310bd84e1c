// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/grid_runs.h"

#include "aspects/cusps/held_slice.h"
#include "aspects/solutions/joint_ranges.h"
#include "aspects/solutions/value_grid.h"
#include "interval/interval.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include "support/robots/robots.h"
#include "support/slices.h"
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

// Paths and closed paths in grids that are marked at random, against Betti numbers and winding numbers.

namespace parallel_aspects {
namespace {

constexpr std::size_t cells = 24;

/// Joint values in a grid: of angles with all values, or within limits.
struct Grid {
  JointRanges ranges;
  ValueGrid grid;

  Grid(const test::Robot& robot, const HeldJoint& held, const HeldSlice& slice, std::size_t marks,
       test::RandomRobots& random)
      : ranges(*robot, held, slice), grid(ranges, cells) {
    for (std::size_t n = 0; n < marks; ++n) mark(random);
    grid.join(1);
  }

 private:
  void mark(test::RandomRobots& random) {
    ValueStrip strip;
    for (std::size_t i = 0; i < 2; ++i) {
      const double from = random.uniform(ranges.values().lower[i], ranges.values().upper[i]);
      strip.values[i] = Interval(from, from + random.uniform(0.0, 3.0 * grid.steps()[i]));
    }
    grid.mark(strip);
  }
};

GridPlace place(std::size_t x, std::size_t y) {
  return {static_cast<std::ptrdiff_t>(x), static_cast<std::ptrdiff_t>(y)};
}

/// Loops of a set of cells that are joined through their sides: of the graph of cells those that are not
/// about a corner with four cells of the set. The number of independent ones, by the rank of the boundary
/// matrices.
int betti_number(const ValueGrid& grid, std::size_t set) {
  std::vector<std::vector<int>> index(cells, std::vector<int>(cells, -1));
  int points = 0;
  for (std::size_t x = 0; x < cells; ++x)
    for (std::size_t y = 0; y < cells; ++y)
      if (grid.set_at(place(x, y)) == set) index[x][y] = points++;
  const auto at = [&](std::size_t x, std::size_t y) {
    const bool beyond = (x == cells && !grid.is_periodic(0)) || (y == cells && !grid.is_periodic(1));
    return beyond ? -1 : index[x % cells][y % cells];
  };
  std::vector<std::array<std::size_t, 3>> edges;  // cell, and the axis
  std::vector<std::vector<int>> edge_of(2 * cells, std::vector<int>(cells, -1));
  for (std::size_t x = 0; x < cells; ++x)
    for (std::size_t y = 0; y < cells; ++y)
      for (std::size_t axis = 0; axis < 2; ++axis)
        if (at(x, y) >= 0 && at(x + (axis == 0), y + (axis == 1)) >= 0) {
          edge_of[2 * x + axis][y] = static_cast<int>(edges.size());
          edges.push_back({x, y, axis});
        }
  std::vector<std::array<int, 4>> faces;
  for (std::size_t x = 0; x < cells; ++x)
    for (std::size_t y = 0; y < cells; ++y)
      if (at(x, y) >= 0 && at(x + 1, y) >= 0 && at(x, y + 1) >= 0 && at(x + 1, y + 1) >= 0)
        faces.push_back({edge_of[2 * x][y], edge_of[2 * ((x + 1) % cells) + 1][y],
                         edge_of[2 * x][(y + 1) % cells], edge_of[2 * x + 1][y]});
  Eigen::MatrixXd boundary =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(edges.size()), static_cast<Eigen::Index>(faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 4; ++k)
      boundary(faces[f][k], static_cast<Eigen::Index>(f)) += k < 2 ? 1.0 : -1.0;
  const auto rank = faces.empty() ? 0 : static_cast<int>(boundary.fullPivLu().rank());
  return static_cast<int>(edges.size()) - (points - 1) - rank;
}

/// Turns of a closed path about the middle of a cell in the first turn, and how it goes on in further turns.
double winding(const std::vector<GridPlace>& loop, const GridPlace& about) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
    const double ax = static_cast<double>(loop[i][0] - about[0]),
                 ay = static_cast<double>(loop[i][1] - about[1]);
    const double bx = static_cast<double>(loop[i + 1][0] - about[0]),
                 by = static_cast<double>(loop[i + 1][1] - about[1]);
    sum += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return std::round(sum / (2.0 * 3.14159265358979324));
}

/// How many independent closed paths there are among these, by their turns about all cells that are not in
/// the set.
int independent_loops(const ValueGrid& grid, std::size_t set,
                      const std::vector<std::vector<GridPlace>>& loops) {
  std::vector<GridPlace> holes;
  for (std::size_t x = 0; x < cells; ++x)
    for (std::size_t y = 0; y < cells; ++y)
      if (grid.set_at(place(x, y)) != set) holes.push_back(place(x, y));
  Eigen::MatrixXd turns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(loops.size()),
                                                static_cast<Eigen::Index>(holes.size()) + 1);
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t h = 0; h < holes.size(); ++h)
      turns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(h)) = winding(loops[i], holes[h]);
  return loops.empty() ? 0 : static_cast<int>(turns.fullPivLu().rank());
}

/// Whether a line between two cells lies in the set, by many points of it.
bool is_in_set(const ValueGrid& grid, std::size_t set, const GridPlace& from, const GridPlace& to) {
  for (int k = 0; k <= 1000; ++k) {
    const double t = k / 1000.0;
    GridPlace at{};
    for (std::size_t i = 0; i < 2; ++i)
      at[i] = static_cast<std::ptrdiff_t>(std::floor(static_cast<double>(from[i]) + 0.5 +
                                                     t * static_cast<double>(to[i] - from[i]) +
                                                     (t < 0.5 ? 1e-9 : -1e-9)));
    if (grid.set_at(grid.within(at)) != set) return false;
  }
  return true;
}

class GridRunsOf : public testing::Test {
 protected:
  template <class Check>
  void for_grids(const test::Robot& robot, const Check& check) {
    test::RandomRobots random(41);
    const RoundingUpward rounding;
    const HeldJoint held{0, 0.3, true};
    const auto slice = make_held_slice(*robot, held);
    for (std::size_t n = 0; n < 40; ++n) {
      const Grid grid(robot, held, *slice, 5 + 4 * n, random);
      const GridRuns runs(grid.grid);
      for (std::size_t set = 0; set < grid.grid.sets().size(); ++set) check(grid.grid, runs, set);
    }
  }

  static test::Robot periodic() { return test::three_rrr()->with_constraints({}); }

  static test::Robot limited() {
    const test::Robot free = test::three_rrr();
    std::vector<Leg> legs(free->legs().begin(), free->legs().end());
    legs[1].limits = JointLimits{2.5, 4.0};
    legs[2].limits = JointLimits{-1.0, 1.0};
    return test::manipulator("limited", TaskSpace::SE2, legs);
  }
};

TEST_F(GridRunsOf, LeadThroughTheSet) {
  for (const test::Robot& robot : {periodic(), limited()})
    for_grids(robot, [](const ValueGrid& grid, const GridRuns& runs, std::size_t set) {
      for (std::size_t x = 0; x < cells; ++x)
        for (std::size_t y = 0; y < cells; ++y) {
          if (grid.set_at(place(x, y)) != set) continue;
          const std::vector<GridPlace> path = runs.path_to(place(x, y));
          EXPECT_EQ(path.front(), grid.sets()[set].cell);
          EXPECT_EQ(grid.within(path.back()), place(x, y));
          for (std::size_t i = 0; i + 1 < path.size(); ++i)
            EXPECT_TRUE(is_in_set(grid, set, path[i], path[i + 1])) << x << " " << y;
        }
    });
}

// Within limits there are no further turns, and turns about what is not in the set tell closed paths apart.
TEST_F(GridRunsOf, AreAllClosedPathsWithinLimits) {
  int all = 0;
  for_grids(limited(), [&](const ValueGrid& grid, const GridRuns& runs, std::size_t set) {
    const auto loops = runs.loops(set);
    const int expected = betti_number(grid, set);
    EXPECT_EQ(independent_loops(grid, set, loops), expected);
    EXPECT_EQ(static_cast<int>(loops.size()), expected);
    all += expected;
  });
  EXPECT_GT(all, 50);
}

TEST_F(GridRunsOf, AreAtLeastAsManyClosedPathsWithFurtherTurns) {
  for_grids(periodic(), [&](const ValueGrid& grid, const GridRuns& runs, std::size_t set) {
    const auto loops = runs.loops(set);
    for (const auto& loop : loops) EXPECT_EQ(grid.within(loop.back()), grid.within(loop.front()));
    EXPECT_GE(static_cast<int>(loops.size()), betti_number(grid, set));
  });
}

}  // namespace
}  // namespace parallel_aspects
