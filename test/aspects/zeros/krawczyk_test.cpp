// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/zeros/krawczyk.h"

#include "interval/half_turns.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>

namespace parallel_aspects {
namespace {

using Pair = std::array<Interval, 2>;

/// Two quadratic functions of u, the angles from the point `first` [rad], with two zeros: there and at
/// `second`.
class Quadratics {
 public:
  Quadratics(std::mt19937_64& random, const MapPoint& first, const MapPoint& second) : first_(first) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const Pair there = angles(Interval(second[0]), Interval(second[1]));
    for (std::size_t n = 0; n < 2; ++n) {
      for (double& each : bend_[n]) each = number(random);
      slope_[n][1] = number(random);
      // So that it vanishes at the second point, too.
      const Interval rest = slope_[n][1] * there[1] + bent(n, there);
      slope_[n][0] = -(rest * inverse_of(there[0]));
    }
  }

  PairOverBox over(const Box& box) const {
    const Pair center = angles(Interval(box.center(0)), Interval(box.center(1)));
    const Pair range = angles(Interval(box.lower[0], box.upper[0]), Interval(box.lower[1], box.upper[1]));
    PairOverBox result;
    for (std::size_t n = 0; n < 2; ++n) {
      result.center[n] = slope_[n][0] * center[0] + slope_[n][1] * center[1] + bent(n, center);
      const auto& [a, b, c] = bend_[n];
      result.jacobian[n][0] = slope_[n][0] + Interval(2.0 * a) * range[0] + Interval(b) * range[1];
      result.jacobian[n][1] = slope_[n][1] + Interval(b) * range[0] + Interval(2.0 * c) * range[1];
    }
    return result;
  }

 private:
  static Interval inverse_of(const Interval& a) { return a.positive() ? reciprocal(a) : -reciprocal(-a); }

  Pair angles(const Interval& x, const Interval& y) const {
    return {pi_enclosure() * (x - Interval(first_[0])), pi_enclosure() * (y - Interval(first_[1]))};
  }

  Interval bent(std::size_t n, const Pair& u) const {
    return Interval(bend_[n][0]) * square(u[0]) + Interval(bend_[n][1]) * (u[0] * u[1]) +
           Interval(bend_[n][2]) * square(u[1]);
  }

  MapPoint first_;
  std::array<std::array<double, 3>, 2> bend_{};
  std::array<Pair, 2> slope_;
};

class KrawczykTest : public testing::Test {
 protected:
  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random);
  }

  /// Its edges are of very different lengths.
  Box box() {
    Box result{2, {}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
      result.lower[i] = uniform(-1.0, 1.0);
      result.upper[i] = result.lower[i] + std::pow(10.0, uniform(-3.0, -0.5));
    }
    return result;
  }

  MapPoint within(const Box& box) {
    return {uniform(box.lower[0], box.upper[0]), uniform(box.lower[1], box.upper[1]), 0.0};
  }

  std::mt19937_64 random{20261128};
};

TEST_F(KrawczykTest, KeepsEveryZeroOfABox) {
  int one = 0;
  for (int i = 0; i < 20000; ++i) {
    const Box here = box();
    const MapPoint zero = within(here), far{uniform(1.0, 2.0), uniform(1.0, 2.0), 0.0};
    const RoundingUpward rounding;
    const ZeroSearch found = krawczyk_test(here, Quadratics(random, zero, far).over(here));
    ASSERT_NE(found.zeros, Zeros::none) << i;
    ASSERT_TRUE(found.enclosure.contains(zero)) << i;
    one += found.zeros == Zeros::one ? 1 : 0;
  }
  EXPECT_GT(one, 1000);
}

TEST_F(KrawczykTest, DoesNotTakeTwoZerosForOne) {
  for (int i = 0; i < 20000; ++i) {
    const Box here = box();
    const MapPoint first = within(here), second = within(here);
    const RoundingUpward rounding;
    const ZeroSearch found = krawczyk_test(here, Quadratics(random, first, second).over(here));
    ASSERT_EQ(found.zeros, Zeros::unknown) << i;
    ASSERT_TRUE(found.enclosure.contains(first) && found.enclosure.contains(second)) << i;
  }
}

TEST_F(KrawczykTest, ExcludesBoxesBesideTheZeros) {
  int none = 0;
  for (int i = 0; i < 2000; ++i) {
    const Box here = box();
    const MapPoint zero = within(here), far{uniform(1.0, 2.0), uniform(1.0, 2.0), 0.0};
    const RoundingUpward rounding;
    const Quadratics functions(random, zero, far);
    Box beside = here;
    for (std::size_t k = 0; k < 2; ++k) {
      beside.lower[k] += here.width(k);
      beside.upper[k] += here.width(k);
    }
    none += krawczyk_test(beside, functions.over(beside)).zeros == Zeros::none ? 1 : 0;
  }
  EXPECT_GT(none, 500);
}

}  // namespace
}  // namespace parallel_aspects
