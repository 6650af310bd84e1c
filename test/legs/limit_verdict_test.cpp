// SPDX-License-Identifier: BSD-3-Clause
#include "legs/limit_verdict.h"

#include "interval/interval.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include <cmath>
#include <limits>
#include <optional>

namespace parallel_aspects {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), full_turn = 2.0 * EIGEN_PI;

// Nothing where rounding may tell one from the other.
std::optional<bool> contains(const JointLimits& limits, double q) {
  if (std::abs(q - limits.lower) < 1e-6 || std::abs(q - limits.upper) < 1e-6) return std::nullopt;
  return limits.contain(q);
}

std::optional<bool> contains_angle(const JointLimits& limits, double q) {
  bool any = false;
  for (int turns = -3; turns <= 3; ++turns) {
    const auto held = contains(limits, q + turns * full_turn);
    if (!held) return std::nullopt;
    any = any || *held;
  }
  return any;
}

TEST(Verdict, OfTwoIsThatOfLogic) {
  const Verdict holds = Verdict::holds, fails = Verdict::fails, unknown = Verdict::unknown;
  for (const Verdict each : {holds, fails, unknown}) {
    EXPECT_EQ(both(each, fails), fails);
    EXPECT_EQ(both(each, holds), each);
    EXPECT_EQ(either(each, holds), holds);
    EXPECT_EQ(either(each, fails), each);
    EXPECT_EQ(both(each, each), each);
    EXPECT_EQ(either(each, each), each);
  }
}

TEST(AngleLimits, AreThoseOfTheAngleWhateverItsTurns) {
  test::RandomRobots random(20261123);
  int inside = 0, outside = 0;
  for (int i = 0; i < 20000; ++i) {
    JointLimits limits;
    limits.lower = random.uniform(-6.0, 6.0);
    limits.upper = limits.lower + random.uniform(0.01, full_turn);
    const double q = random.uniform(-6.0, 6.0), offset = random.uniform(-6.0, 6.0);
    const double sense = random.uniform(-1.0, 1.0) > 0.0 ? 1.0 : -1.0, length = random.uniform(0.1, 9.0);
    const auto held = contains_angle(limits, q);
    if (!held) continue;
    const double angle = offset + sense * q, cosine = length * std::cos(angle),
                 sine = length * std::sin(angle);
    const RoundingUpward rounding;
    const AngleLimits tested(limits, offset, sense);
    ++(*held ? inside : outside);
    ASSERT_EQ(verdict(tested.functions(Interval(cosine), Interval(sine))),
              *held ? Verdict::holds : Verdict::fails)
        << limits.lower << " to " << limits.upper << " at " << q << ", offset " << offset;
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

TEST(AngleLimits, OfAFullTurnBoundNothing) {
  const RoundingUpward rounding;
  // The double next to 2 pi is below it.
  for (const double upper : {std::nextafter(full_turn, 9.0), 9.0, infinity}) {
    JointLimits limits;
    limits.lower = 0.0;
    limits.upper = upper;
    const AngleLimits tested(limits, 0.0, 1.0);
    EXPECT_FALSE(tested.limited());
    EXPECT_EQ(verdict(tested.functions(Interval(-1.0), Interval(0.0))), Verdict::holds);
  }
}

// From the length itself and from its square; a strut cannot be shorter than zero, whatever its limits.
TEST(LengthLimits, AreThoseOfTheLength) {
  test::RandomRobots random(20261124);
  int inside = 0, outside = 0;
  for (int i = 0; i < 20000; ++i) {
    JointLimits limits;
    limits.lower = random.uniform(0.0, 1.0) < 0.2 ? -infinity : random.uniform(-2.0, 2.0);
    limits.upper = std::isfinite(limits.lower) ? limits.lower + random.uniform(0.01, 2.0) : 1.0;
    const double length = random.uniform(0.0, 3.0), zero = random.uniform(-1.0, 1.0);
    const double sense = random.uniform(-1.0, 1.0) > 0.0 ? 1.0 : -1.0, q = sense * (length - zero);
    const auto held = contains(limits, q);
    if (!held) continue;
    ++(*held ? inside : outside);
    const Verdict expected = *held ? Verdict::holds : Verdict::fails;
    const RoundingUpward rounding;
    ASSERT_EQ(verdict(LengthLimits(limits).functions(Interval(q))), expected);
    ASSERT_EQ(verdict(LengthLimits(limits, zero, sense).functions_of_square(square(Interval(length)))),
              expected)
        << limits.lower << " to " << limits.upper << " at " << q << ", " << zero << " at zero, sense "
        << sense;
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

}  // namespace
}  // namespace parallel_aspects
