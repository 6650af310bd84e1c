// SPDX-License-Identifier: BSD-3-Clause
// Quadratic forms enclose: checked at random points, in numbers of more digits.
#include "distance/quadratic_form.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <type_traits>

namespace parallel_aspects {
namespace {

constexpr std::size_t size = 3;

// The function that the forms stand for, over any numbers.
template <class Scalar, class Root>
Scalar function(const std::array<Scalar, size>& x, const std::array<double, 6>& a, const Root& root_of) {
  const Scalar first = Interval(a[0]) * x[0] - Interval(a[1]) * x[1] + Scalar(a[2]);
  const Scalar second = first * x[2] + Interval(a[3]) * (x[0] * x[1]);
  const Scalar positive = first * first + Scalar(0.5 + a[4] * a[4]);
  return second * root_of(positive) - Interval(a[5]) * (second * first);
}

// Of long doubles; intervals are exact here.
struct Number {
  long double value = 0.0L;
  Number() = default;
  Number(double a) : value(a) {}  // NOLINT
  explicit Number(long double a, int) : value(a) {}
  friend Number operator+(const Number& a, const Number& b) { return Number(a.value + b.value, 0); }
  friend Number operator-(const Number& a, const Number& b) { return Number(a.value - b.value, 0); }
  friend Number operator*(const Number& a, const Number& b) { return Number(a.value * b.value, 0); }
  friend Number operator*(const Interval& a, const Number& b) { return Number(a.upper() * b.value, 0); }
};

template <FormDomain domain>
void expect_enclosure(std::uint64_t seed) {
  using Form = QuadraticForm<size, domain>;
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int run = 0; run < 200; ++run) {
    std::array<double, 6> a{};
    for (double& each : a) each = uniform(engine);
    std::array<double, size> center{}, width{};
    const double scale = std::pow(10.0, 2.0 * uniform(engine) - 2.0);
    for (std::size_t i = 0; i < size; ++i) {
      center[i] = uniform(engine);
      width[i] = scale * (1.1 + uniform(engine));
    }
    const RoundingUpward rounding;
    std::array<Form, size> x;
    for (std::size_t i = 0; i < size; ++i) x[i] = Form::coordinate(center[i], width[i], i);
    const Form form = function<Form>(x, a, [](const Form& each) { return root(each); });
    const Interval range = form.range(), linear = form.linear().range();
    for (int point = 0; point < 50; ++point) {
      std::array<long double, size> offset{};
      long double squared = 0.0L;
      for (long double& each : offset) {
        each = uniform(engine);
        squared += each * each;
      }
      std::array<Number, size> y;
      for (std::size_t i = 0; i < size; ++i) {
        const long double within =
            domain == FormDomain::ball ? offset[i] / std::sqrt(std::max(1.0L, squared)) : offset[i];
        y[i] = Number(center[i] + width[i] * within * (1.0L - 1e-17L), 0);
      }
      const long double value =
          function<Number>(y, a, [](const Number& each) { return Number(std::sqrt(each.value), 0); }).value;
      ASSERT_LE(range.lower(), value) << "seed " << seed << " run " << run;
      ASSERT_GE(range.upper(), value) << "seed " << seed << " run " << run;
      if (domain == FormDomain::ball) continue;
      ASSERT_LE(linear.lower(), value) << "seed " << seed << " run " << run;
      ASSERT_GE(linear.upper(), value) << "seed " << seed << " run " << run;
    }
  }
}

TEST(QuadraticForm, EnclosesOverBoxes) { expect_enclosure<FormDomain::box>(20261121); }
TEST(QuadraticForm, EnclosesOverBalls) { expect_enclosure<FormDomain::ball>(20261122); }

TEST(QuadraticForm, IsPositiveInTheShareOfTheBall) {
  using Form = QuadraticForm<2, FormDomain::ball>;
  std::mt19937_64 engine(20261125);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int proved = 0;
  for (int run = 0; run < 500; ++run) {
    const double a = uniform(engine), b = uniform(engine), c = uniform(engine), d = uniform(engine);
    const auto value = [&](const auto& x, const auto& y) {
      using Value = std::decay_t<decltype(x)>;
      return x * x * y * Value(a) + x * y * Value(b) + x * Value(c) + y * Value(d);
    };
    const RoundingUpward rounding;
    const Form x = Form::coordinate(0.0, 1.0, 0), y = Form::coordinate(0.0, 1.0, 1);
    const Form form = Form(0.5) + value(x, y);
    const double share = form.positive_share();
    ASSERT_LE(share, 1.0);
    if (share > 0.0) ++proved;
    // Not much more would do: that is where the bounds of the parts meet.
    const double all = 1.5 * (std::abs(a) + std::abs(b) + std::hypot(c, d));
    if (std::abs(a) < 0.4) {
      EXPECT_GE(share, std::min(1.0, 0.1 / all)) << a << " " << b << " " << c << " " << d;
    }
    for (int i = 0; i < 50; ++i) {
      const double angle = 4.0 * uniform(engine), length = share * std::abs(uniform(engine));
      ASSERT_GE(0.5 + value(length * std::cos(angle), length * std::sin(angle)), 0.0)
          << a << " " << b << " " << c << " " << d;
    }
  }
  EXPECT_GT(proved, 200);
}

TEST(QuadraticForm, WhatIsLeftFallsWithTheCubeOfTheBox) {
  const RoundingUpward rounding;
  const auto excess = [](double width) {
    using Form = QuadraticForm<2>;
    const Form x = Form::coordinate(0.3, width, 0), y = Form::coordinate(0.7, width, 1);
    const Form zero = (x * y + root(x + y)) * (x - y) - ((x * x) * y - x * (y * y)) - root(x + y) * (x - y);
    return zero.range().upper();
  };
  EXPECT_LT(excess(0.005), excess(0.01) / 7.5);
}

TEST(QuadraticForm, QuadraticPartsCancel) {
  const RoundingUpward rounding;
  using Form = QuadraticForm<2>;
  const Form x = Form::coordinate(0.3, 0.5, 0), y = Form::coordinate(0.7, 0.5, 1);
  const Form zero = (x + y) * (x - y) - (x * x - y * y);
  EXPECT_LT(zero.range().upper(), 1e-13);
  EXPECT_GT(zero.range().lower(), -1e-13);
}

}  // namespace
}  // namespace parallel_aspects
