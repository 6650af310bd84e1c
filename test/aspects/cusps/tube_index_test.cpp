// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/cusp_trace.h"
#include "interval/interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace parallel_aspects {
namespace {

class RandomTubes {
 public:
  CuspTube tube() {
    CuspTube tube;
    tube.axis = std::uniform_int_distribution<std::size_t>(0, 2)(random_);
    tube.others = {tube.axis == 0 ? std::size_t{1} : std::size_t{0},
                   tube.axis == 2 ? std::size_t{1} : std::size_t{2}};
    tube.middle = between(-1.2, 1.2);
    tube.half = std::pow(10.0, between(-4.0, -1.0));
    tube.cross.dimension = 2;
    for (std::size_t i = 0; i < 2; ++i) {
      tube.slope[i] = between(-1.0, 1.0);
      const double at = between(-1.2, 1.2), half = tube.half * between(0.2, 1.0);
      tube.cross.lower[i] = at - half;
      tube.cross.upper[i] = at + half;
    }
    return tube;
  }

  /// A box near the tube's middle, by whole turns beside it.
  Box box_near(const CuspTube& tube) {
    MapPoint at{};
    at[tube.axis] = tube.middle;
    for (std::size_t i = 0; i < 2; ++i) at[tube.others[i]] = tube.cross.center(i);
    Box box{3, {}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const double turns = i < 2 ? 2.0 * std::uniform_int_distribution<int>(-1, 1)(random_) : 0.0;
      box.lower[i] = at[i] + turns + tube.half * between(-1.0, 1.0);
      box.upper[i] = box.lower[i] + tube.half * between(0.0, 0.3);
    }
    return box;
  }

 private:
  double between(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random_);
  }

  std::mt19937 random_{8};
};

TEST(TubeIndex, HoldsWhatOneOfAllTubesContains) {
  const RoundingUpward rounding;
  RandomTubes random;
  TubeIndex index(TraceBounds{-1.0, 1.0, {1.0, 1.0, 1.0}});
  std::vector<CuspTube> tubes;
  for (int i = 0; i < 500; ++i) {
    tubes.push_back(random.tube());
    index.add(tubes.back());
  }
  int held = 0;
  const int boxes = 20000;
  for (int i = 0; i < boxes; ++i) {
    const Box box = random.box_near(tubes[static_cast<std::size_t>(i) % tubes.size()]);
    const bool expected =
        std::any_of(tubes.begin(), tubes.end(), [&](const CuspTube& tube) { return contains(tube, box); });
    EXPECT_EQ(index.holds(box), expected) << "box " << i;
    held += expected ? 1 : 0;
  }
  EXPECT_GT(held, boxes / 20);
  EXPECT_LT(held, boxes - boxes / 20);
}

}  // namespace
}  // namespace parallel_aspects
