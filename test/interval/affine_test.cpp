// SPDX-License-Identifier: BSD-3-Clause
#include "interval/affine.h"

#include "interval/dual.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

namespace parallel_aspects {
namespace {

using Real = long double;
using Form = Affine<2>;

constexpr Real pi = 3.14159265358979323846264338327950288L;

Real square(Real a) { return a * a; }
Real reciprocal(Real a, double) { return 1.0L / a; }
Real square_root(Real a, double) { return std::sqrt(a); }
Turn<Real> turn_of_half_turns(Real a) { return {std::cos(pi * a), std::sin(pi * a)}; }

/// Every operation, over enclosures and over long double alike.
template <class Scalar>
std::array<Scalar, 7> functions(const Scalar& x, const Scalar& y) {
  const Scalar distance = square(x - Scalar(0.3)) + square(y) + Scalar(0.01);
  const auto turn = turn_of_half_turns(x * y * Scalar(0.1));
  return {x + y,
          x * y - square(x),
          reciprocal(distance, 0.01),
          square_root(distance, 0.01),
          turn.cosine,
          turn.sine * distance,
          -(x * x * x) * square_root(reciprocal(distance, 0.01), 0.01)};
}

struct Sample {
  std::mt19937_64 random{17};
  std::uniform_real_distribution<double> coordinate{-2.0, 2.0}, share{0.0, 1.0}, exponent{-12.0, 0.0};

  Interval range() {
    const double at = coordinate(random), width = std::pow(10.0, exponent(random));
    return {at, at + width};
  }
  Real inside(const Interval& range) {
    return range.lower() + static_cast<Real>(share(random)) * (range.upper() - range.lower());
  }
};

std::string text(const Interval& a) {
  return "[" + std::to_string(a.lower()) + ", " + std::to_string(a.upper()) + "]";
}

// Against the same functions in long double at points of the box, in boxes from 1e-12 to 1.
TEST(Affine, EnclosesEveryFunctionOnTheWholeBox) {
  Sample sample;
  for (int i = 0; i < 100000; ++i) {
    const Interval x = sample.range(), y = sample.range();
    std::array<Interval, 7> enclosures;
    {
      const RoundingUpward rounding;
      const auto forms = functions(Form::coordinate(x, 0), Form::coordinate(y, 1));
      for (std::size_t k = 0; k < forms.size(); ++k) enclosures[k] = forms[k].range();
    }
    const auto values = functions(sample.inside(x), sample.inside(y));
    for (std::size_t k = 0; k < values.size(); ++k)
      ASSERT_TRUE(enclosures[k].lower() <= values[k] && values[k] <= enclosures[k].upper())
          << "function " << k << " over " << text(x) << " x " << text(y);
  }
}

TEST(Affine, EnclosesTheValueAtTheCenter) {
  Sample sample;
  for (int i = 0; i < 20000; ++i) {
    const Interval x = sample.range(), y = sample.range();
    const Real middle_x = 0.5L * (static_cast<Real>(x.lower()) + x.upper());
    const Real middle_y = 0.5L * (static_cast<Real>(y.lower()) + y.upper());
    const RoundingUpward rounding;
    const auto forms = functions(Form::coordinate(x, 0), Form::coordinate(y, 1));
    const auto values = functions(middle_x, middle_y);
    // The center of the form is the center of the box up to rounding.
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LE(forms[k].at_center().lower(), values[k] + 1e-14L);
      EXPECT_GE(forms[k].at_center().upper(), values[k] - 1e-14L);
    }
  }
}

// What is too wide must shrink with the square of the box.
TEST(Affine, ExcessIsOfSecondOrder) {
  const RoundingUpward rounding;
  double last = 0.0;
  for (double width : {0.1, 0.05, 0.025, 0.0125}) {
    const Form x = Form::coordinate({1.0, 1.0 + width}, 0), y = Form::coordinate({2.0, 2.0 + width}, 1);
    const Interval difference = (x * y - y * x + square_root(square(x), 1.0) - x).range();
    const double excess = difference.upper() - difference.lower();
    if (last > 0.0) {
      EXPECT_LT(excess, 0.27 * last);
    }
    last = excess;
  }
}

// f(x, y) = (x - y) / ((x + 2 y)^2 + 3), differentiated by hand.
TEST(Dual, GradientEnclosesTheDerivative) {
  const RoundingUpward rounding;
  using Slope = Dual<2, Form>;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-2.0, 2.0);
  for (int i = 0; i < 1000; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    const auto dx = Slope::coordinate(Form::coordinate({x - 0.01, x + 0.01}, 0), 0);
    const auto dy = Slope::coordinate(Form::coordinate({y - 0.01, y + 0.01}, 1), 1);
    const Slope value = reciprocal(square(dx + Interval(2.0) * dy) + Slope(3.0), 3.0) * (dx - dy);
    const double r = (x + 2 * y) * (x + 2 * y) + 3.0, bend = -2.0 * (x + 2 * y) / (r * r) * (x - y);
    const double along_x = bend + 1.0 / r, along_y = 2.0 * bend - 1.0 / r;
    const Interval over_x = value.gradient[0].range(), over_y = value.gradient[1].range();
    EXPECT_LE(over_x.lower(), along_x);
    EXPECT_GE(over_x.upper(), along_x);
    EXPECT_LE(over_y.lower(), along_y);
    EXPECT_GE(over_y.upper(), along_y);
    EXPECT_LT(over_x.upper() - over_x.lower(), 1.0);
  }
}

}  // namespace
}  // namespace parallel_aspects
