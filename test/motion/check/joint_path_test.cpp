// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/fold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

double middle_of_value(const Interval& a) { return 0.5 * (a.lower() + a.upper()); }

class RandomJointPaths : public testing::Test {
 protected:
  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random);
  }

  JointVector values() { return JointVector::Constant(1, uniform(-3.0, 3.0)); }

  /// Straight, cubic or quintic.
  JointPath path(int kind) {
    JointWaypoint from{0.0, values(), {}, {}}, to{uniform(0.1, 3.0), values(), {}, {}};
    for (JointWaypoint* each : {&from, &to}) {
      if (kind > 0) each->velocity = values();
      if (kind > 1) each->acceleration = values();
    }
    return JointPath(from, to);
  }

  std::mt19937_64 random{20261128};
};

// The bound is that of the whole part, wherever in it the path bends the most.
TEST_F(RandomJointPaths, AreNoFartherFromTheirChordsThanTheBend) {
  const RoundingUpward rounding;
  double closest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const JointPath tried = path(i % 3);
    const double begin = uniform(0.0, 0.9), end = begin + uniform(0.01, 1.0 - begin);
    const double bend = tried.bend(0, begin, end);
    const double first = middle_of_value(tried.value(0, begin)), last = middle_of_value(tried.value(0, end));
    for (int k = 1; k < 50; ++k) {
      const double share = k / 50.0, at = begin + share * (end - begin);
      const double off = std::abs(middle_of_value(tried.value(0, at)) - (first + share * (last - first)));
      ASSERT_LE(off, bend + 1e-12) << i << " from " << begin << " to " << end;
      if (bend > 1e-6) closest = std::max(closest, off / bend);
    }
  }
  EXPECT_GT(closest, 0.9);
}

TEST_F(RandomJointPaths, HaveSlopesWithinTheirBounds) {
  const RoundingUpward rounding;
  for (int i = 0; i < 3000; ++i) {
    const JointPath tried = path(i % 3);
    const double begin = uniform(0.0, 0.9), end = begin + uniform(0.01, 1.0 - begin);
    const Interval slope = tried.slope(0, Interval(begin, end));
    const Interval second = tried.second(0, Interval(begin, end));
    constexpr int parts = 50;
    const double step = (end - begin) / parts;
    for (int k = 0; k < parts; ++k) {
      const double at = begin + k * step;
      const double mean =
          (middle_of_value(tried.value(0, at + step)) - middle_of_value(tried.value(0, at))) / step;
      ASSERT_TRUE(slope.lower() - 1e-6 <= mean && mean <= slope.upper() + 1e-6) << i;
      const double rise = middle_of_value(tried.slope(0, Interval(at + step))) -
                          middle_of_value(tried.slope(0, Interval(at)));
      ASSERT_TRUE(second.lower() - 1e-6 <= rise / step && rise / step <= second.upper() + 1e-6) << i;
    }
  }
}

}  // namespace
}  // namespace parallel_aspects
