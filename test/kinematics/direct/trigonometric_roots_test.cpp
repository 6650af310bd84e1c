// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/circle_family.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

// Product of sin((t - root) / 2) over an even number of roots; with 8 of them it is of degree 4.
double product(double t, const std::vector<double>& roots) {
  double value = 1.0;
  for (const double root : roots) value *= std::sin(0.5 * (t - root));
  return value;
}

std::vector<double> random_roots(std::mt19937& engine, std::size_t count) {
  std::uniform_real_distribution<double> angle(-EIGEN_PI, EIGEN_PI);
  std::vector<double> roots(count);
  for (double& root : roots) root = angle(engine);
  return roots;
}

double distance(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * EIGEN_PI)); }

double distance(const std::vector<double>& roots, double root) {
  double best = 9.0;
  for (const double each : roots) best = std::min(best, distance(each, root));
  return best;
}

double smallest_gap(const std::vector<double>& roots) {
  double gap = 9.0;
  for (std::size_t i = 0; i < roots.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) gap = std::min(gap, distance(roots[i], roots[j]));
  return gap;
}

std::size_t distinct(const std::vector<double>& roots) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < roots.size(); ++i)
    count +=
        distance({roots.begin(), roots.begin() + static_cast<std::ptrdiff_t>(i)}, roots[i]) > 1e-5 ? 1 : 0;
  return count;
}

TEST(TrigonometricRoots, FindsAllOfThemAndNoOthers) {
  std::mt19937 engine(1);
  for (int i = 0; i < 5000; ++i) {
    const std::vector<double> roots = random_roots(engine, 2 * static_cast<std::size_t>(i % 5));
    const auto f = TrigonometricPolynomial::interpolated([&](double t) { return product(t, roots); });
    const std::vector<double> found = real_roots(f);
    if (smallest_gap(roots) > 1e-2) {
      EXPECT_EQ(distinct(found), roots.size()) << "case " << i;
    }
    for (const double root : roots) EXPECT_LT(distance(found, root), 1e-5) << "case " << i;
    for (const double root : found) EXPECT_LT(distance(roots, root), 1e-5) << "case " << i;
  }
}

TEST(TrigonometricRoots, DoubleAndQuadrupleRootsAreNotMissed) {
  for (const std::vector<double>& roots : {std::vector<double>{1.0, 1.0},
                                           {0.1234567 - EIGEN_PI, 0.1234567 - EIGEN_PI},
                                           {2.0, 2.0, 2.0, 2.0},
                                           {-1.0, -1.0, 0.5, 0.5, 0.5, 0.5, 3.0, 3.0}}) {
    const auto f = TrigonometricPolynomial::interpolated([&](double t) { return product(t, roots); });
    const std::vector<double> found = real_roots(f);
    for (const double root : roots) EXPECT_LT(distance(found, root), 1e-3);
    EXPECT_LT(found.size(), 1000U);
  }
}

TEST(TrigonometricRoots, DerivativesMatchDifferences) {
  std::mt19937 engine(2);
  const std::vector<double> roots = random_roots(engine, 8);
  const auto f = TrigonometricPolynomial::interpolated([&](double t) { return product(t, roots); });
  for (double t = -3.0; t < 3.0; t += 0.1) {
    const auto [value, slope, curvature] = f.derivatives(t);
    const double h = 1e-4, ahead = product(t + h, roots), behind = product(t - h, roots);
    EXPECT_NEAR(value, product(t, roots), 1e-14);
    EXPECT_NEAR(slope, (ahead - behind) / (2.0 * h), 1e-7);
    EXPECT_NEAR(curvature, (ahead - 2.0 * value + behind) / (h * h), 1e-6);
    EXPECT_LE(std::abs(slope), f.bound(1));
  }
}

}  // namespace
}  // namespace parallel_aspects
