// SPDX-License-Identifier: BSD-3-Clause
#include "interval/path_form.h"

#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include <array>
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

using Real = long double;

// Long doubles carry 64 bits; theirs is the rounding that is allowed here.
constexpr Real allowed = 1e-17L;

bool holds(const Interval& interval, Real value) {
  const Real allowance = allowed * (1.0L + std::abs(value));
  return interval.lower() - allowance <= value && value <= interval.upper() + allowance;
}

Interval widened(const Interval& slope, double s) {
  return slope * Interval(std::min(s, 0.0), std::max(s, 0.0));
}

// A value at s lies in the range, and in the cone that the slope allows from the center.
void expect_enclosed(const PathForm& form, Real at_center, Real at_s, double s) {
  ASSERT_TRUE(holds(form.center, at_center));
  ASSERT_TRUE(holds(form.range, at_s));
  ASSERT_TRUE(holds(form.center + widened(form.slope, s), at_s));
}

template <class Scalar>
Scalar expression(const Scalar& t, const std::array<double, 6>& c) {
  using std::sqrt;
  const Scalar p = Scalar(c[0]) + Scalar(c[1]) * t, q = square(t - Scalar(c[2])) + Scalar(1.5);
  const Scalar r = reciprocal(q) * p - square(p) * Scalar(c[3]);
  return square_root(square(r) + Scalar(0.25)) * t - Scalar(c[4]) * r + Scalar(c[5]);
}

struct Plain {
  Real value;
  explicit Plain(Real x) : value(x) {}
  friend Plain operator+(Plain a, Plain b) { return Plain(a.value + b.value); }
  friend Plain operator-(Plain a, Plain b) { return Plain(a.value - b.value); }
  friend Plain operator*(Plain a, Plain b) { return Plain(a.value * b.value); }
  friend Plain square(Plain a) { return a * a; }
  friend Plain reciprocal(Plain a) { return Plain(1.0L / a.value); }
  friend Plain square_root(Plain a) { return Plain(std::sqrt(a.value)); }
};

TEST(PathForm, EnclosesValuesAndSlopesOfRandomExpressions) {
  test::RandomRobots random(11);
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 6> c{};
    for (double& each : c) each = random.uniform(-2.0, 2.0);
    const double begin = random.uniform(-1.0, 1.0), end = begin + std::pow(10.0, random.uniform(-12.0, 0.0));
    const double middle = 0.5 * (begin + end), share = random.uniform(0.0, 1.0);
    const double t = std::min(end, begin + share * (end - begin));
    const Real center = expression(Plain(middle), c).value, there = expression(Plain(t), c).value;
    const RoundingUpward rounding;
    const PathForm parameter = PathForm::parameter(begin, middle, end);
    const double half = parameter.slope.upper(), s = (t - middle) / half;
    ASSERT_NO_FATAL_FAILURE(expect_enclosed(expression(parameter, c), center, there,
                                            std::clamp(s + (s < 0.0 ? -1e-9 : 1e-9), -1.0, 1.0)))
        << i << ": " << begin << " to " << end << " at " << t;
  }
}

// Ranges are tight to the second order: halving the part divides their excess by about four.
TEST(PathForm, RangesAreTightToTheSecondOrder) {
  const std::array<double, 6> c{0.3, -1.2, 0.4, 0.8, -0.5, 1.1};
  double before = 0.0;
  for (int level = 2; level < 12; ++level) {
    const double half = std::ldexp(1.0, -level);
    Real lowest = HUGE_VALL, highest = -HUGE_VALL;
    for (int i = 0; i <= 1000; ++i) {
      const Real value = expression(Plain(0.2 + half * (i / 500.0 - 1.0)), c).value;
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    const RoundingUpward rounding;
    const Interval range = expression(PathForm::parameter(0.2 - half, 0.2, 0.2 + half), c).range;
    const double excess = static_cast<double>(lowest - range.lower() + (range.upper() - highest));
    if (level > 4) {
      EXPECT_LT(excess, 0.35 * before) << level;
    }
    before = excess;
  }
}

}  // namespace
}  // namespace parallel_aspects
