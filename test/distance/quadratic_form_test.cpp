// SPDX-License-Identifier: BSD-3-Clause
// Quadratic and cubic forms enclose: checked at random points, in numbers of more digits.
#include "distance/quadratic_form.h"

#include "distance/cubic_form.h"

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

template <class Form>
void expect_enclosure(std::uint64_t seed, FormDomain domain) {
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
    const Interval range = form.range();
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
      if constexpr (std::is_same_v<Form, QuadraticForm<size>>) {
        const Interval linear = form.linear().range();
        ASSERT_LE(linear.lower(), value) << "seed " << seed << " run " << run;
        ASSERT_GE(linear.upper(), value) << "seed " << seed << " run " << run;
      }
    }
  }
}

TEST(QuadraticForm, EnclosesOverBoxes) { expect_enclosure<QuadraticForm<size>>(20261121, FormDomain::box); }
TEST(QuadraticForm, EnclosesOverBalls) {
  expect_enclosure<QuadraticForm<size, FormDomain::ball>>(20261122, FormDomain::ball);
}

// As polynomials with what is left, too.
TEST(CubicForm, EnclosesOverBalls) { expect_enclosure<CubicForm<size>>(20261126, FormDomain::ball); }

TEST(CubicForm, WhatIsLeftFallsWithTheFourthPowerOfTheBall) {
  const RoundingUpward rounding;
  const auto error = [](double radius) {
    using Form = CubicForm<size>;
    const Form x = Form::coordinate(0.3, radius, 0), y = Form::coordinate(0.7, radius, 1);
    return (root(x + y) * (x * y) * root(y)).error();
  };
  EXPECT_LT(error(0.005), error(0.01) / 15.0);
}

TEST(CubicForm, CubesCancel) {
  const RoundingUpward rounding;
  using Form = CubicForm<size>;
  const Form x = Form::coordinate(0.3, 0.5, 0), y = Form::coordinate(0.7, 0.5, 1),
             z = Form::coordinate(0.1, 0.5, 2);
  const Form zero = (x + y) * ((x + z) * (y + z)) - (x + y + z) * (x * y + y * z + z * x) + x * (y * z);
  EXPECT_LT(zero.range().upper(), 1e-12);
  EXPECT_GT(zero.range().lower(), -1e-12);
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
