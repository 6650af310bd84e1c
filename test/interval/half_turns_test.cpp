// SPDX-License-Identifier: BSD-3-Clause
#include "interval/half_turns.h"

#include "interval/interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

namespace parallel_aspects {
namespace {

// A few half turns beyond the region, too, where boxes are made longer.
TEST(HalfTurns, EnclosuresHoldTheCosineAndSineOfEveryPoint) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> end(-1.0, 1.0), share(0.0, 1.0);
  for (int i = 0; i < 100000; ++i) {
    const double most = i % 2 == 0 ? 1.0 : 3.0;
    double lower = most * end(random), upper = most * end(random);
    if (lower > upper) std::swap(lower, upper);
    const long double at = lower + share(random) * (upper - lower);
    const long double angle = 3.14159265358979323846264338327950288L * at;
    const RoundingUpward rounding;
    const Interval cosine = cosine_of_half_turns({lower, upper}), sine = sine_of_half_turns({lower, upper});
    ASSERT_TRUE(cosine.lower() <= std::cos(angle) && std::cos(angle) <= cosine.upper())
        << lower << ' ' << upper;
    ASSERT_TRUE(sine.lower() <= std::sin(angle) && std::sin(angle) <= sine.upper()) << lower << ' ' << upper;
  }
}

}  // namespace
}  // namespace parallel_aspects
