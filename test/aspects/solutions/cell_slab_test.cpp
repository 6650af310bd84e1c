// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/solutions/cell_slab.h"

#include "interval/interval.h"

#include <gtest/gtest.h>

#include "support/slices.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

namespace parallel_aspects {
namespace {

using test::uniform;

/// A cell of two or three lengths, and a slab that may lie anywhere about it, steep or flat.
struct Sample {
  Box cell;
  std::array<double, 3> slope{};
  Interval slab;

  Sample(std::mt19937_64& random, std::size_t dimension) : cell{dimension, {}, {}} {
    double reach = 0.0;
    for (std::size_t i = 0; i < dimension; ++i) {
      cell.lower[i] = uniform(random, 0.0, 10.0);
      cell.upper[i] = cell.lower[i] + uniform(random, 0.1, 2.0);
      slope[i] = uniform(random, -1.0, 1.0) * std::pow(10.0, uniform(random, -8.0, 0.0));
      reach += 0.5 * std::abs(slope[i]) * cell.width(i);
    }
    const double from = reach * uniform(random, -1.2, 1.2);
    slab = Interval(from, from + reach * uniform(random, 0.0, 0.5));
  }
};

/// The share of a cell on a side of the slab, at points in a lattice.
double counted_share(const Sample& sample, int side, int points) {
  int count = 0, all = 0;
  const int deep = sample.cell.dimension == 3 ? points : 1;
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j)
      for (int k = 0; k < deep; ++k) {
        const std::array<int, 3> at{i, j, k};
        double value = 0.0;
        for (std::size_t axis = 0; axis < sample.cell.dimension; ++axis)
          value += sample.slope[axis] * sample.cell.width(axis) * ((at[axis] + 0.5) / points - 0.5);
        ++all;
        count += (side < 0 ? value < sample.slab.lower() : value > sample.slab.upper()) ? 1 : 0;
      }
  return static_cast<double>(count) / all;
}

// A plane cuts at most as many cubes of the lattice as three of its faces have, once over.
TEST(CellSlab, HasTheMeasureThatPointsCount) {
  std::mt19937_64 random(41);
  for (const std::size_t dimension : {2U, 3U})
    for (int i = 0; i < test::thinned(400); ++i) {
      const Sample sample(random, dimension);
      for (const int side : {-1, 1}) {
        const int points = dimension == 2 ? 100 : 40;
        const double counted = counted_share(sample, side, points) * sample.cell.measure();
        const RoundingUpward rounding;
        const Interval measure = measure_beside(sample.cell, sample.slope, sample.slab, side);
        const double off = static_cast<double>(dimension) / points * sample.cell.measure();
        EXPECT_LT(measure.lower(), counted + off) << dimension << ' ' << i;
        EXPECT_GT(measure.upper(), counted - off) << dimension << ' ' << i;
        EXPECT_LT(measure.upper() - measure.lower(), 2e-4 * sample.cell.measure()) << dimension << ' ' << i;
      }
    }
}

TEST(CellSlab, HasPointsBesideTheSlab) {
  std::mt19937_64 random(42);
  const RoundingUpward rounding;
  for (const std::size_t dimension : {2U, 3U})
    for (int i = 0; i < 2000; ++i) {
      const Sample sample(random, dimension);
      for (const int side : {-1, 1}) {
        if (!(measure_beside(sample.cell, sample.slope, sample.slab, side).lower() > 0.0)) continue;
        const auto point = point_beside(sample.cell, sample.slope, sample.slab, side);
        EXPECT_TRUE(sample.cell.contains(point));
        const Interval value = linear_at(sample.cell, sample.slope, point);
        EXPECT_TRUE(side < 0 ? value.upper() < sample.slab.lower() : value.lower() > sample.slab.upper());
      }
    }
}

}  // namespace
}  // namespace parallel_aspects
