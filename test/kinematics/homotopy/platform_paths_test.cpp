// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/homotopy/platform_paths.h"

#include "kinematics/homotopy/complex_lanes.h"
#include "kinematics/homotopy/platform_start.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#pragma GCC diagnostic ignored "-Wpsabi"

namespace parallel_aspects::platform_paths {
namespace {

using Vector = Eigen::Matrix<Complex, 3, 1>;

// Without conjugation.
Complex square(const Vector& v) { return v.cwiseProduct(v).sum(); }

Eigen::Matrix<Complex, 3, 3> rotation(const Solution& s) {
  const Complex x = s[0], y = s[1], z = s[2], w = s[3], n = x * x + y * y + z * z + w * w;
  Eigen::Matrix<Complex, 3, 3> r;
  r << w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y),  //
      2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x),   //
      2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return r / n;
}

// x = g conj(e) / e . e, as a product of quaternions.
Vector displacement(const Solution& s) {
  const Vector e(s[0], s[1], s[2]), g(s[4], s[5], s[6]);
  const Complex norm = square(e) + s[3] * s[3];
  const Vector turned(g[1] * e[2] - g[2] * e[1], g[2] * e[0] - g[0] * e[2], g[0] * e[1] - g[1] * e[0]);
  return (g * s[3] - e * s[7] - turned) / norm;
}

// |x + R b - c|^2 - r of every leg, from the rotation matrix rather than from Study's form; relative to the
// moduli of its terms, which cancel where the complex norm of a solution is small.
double largest_residual(const Parameters& parameters, const Solution& s) {
  double largest = 0.0;
  for (const auto& leg : parameters) {
    const Vector b(leg[0], leg[1], leg[2]), c(leg[3], leg[4], leg[5]);
    const Vector x = displacement(s), turned = rotation(s) * b;
    const double scale = x.squaredNorm() + turned.squaredNorm() + c.squaredNorm() + std::abs(leg[6]);
    largest = std::max(largest, std::abs(square(x + turned - c) - leg[6]) / scale);
  }
  return largest;
}

int distinct(const std::vector<Solution>& solutions) {
  int count = 0;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    bool fresh = true;
    for (std::size_t j = 0; j < i; ++j) fresh = fresh && distance(solutions[i], solutions[j]) > 1e-3;
    count += fresh ? 1 : 0;
  }
  return count;
}

TEST(PlatformPaths, StartHasFortyDifferentSolutions) {
  EXPECT_EQ(start_solutions().size(), solution_count);
  EXPECT_EQ(distinct(start_solutions()), 40);
  for (const Solution& s : start_solutions()) EXPECT_LT(largest_residual(start_parameters(), s), 1e-10);
}

TEST(PlatformPaths, LeadToFortySolutionsOfOtherPlatforms) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20; ++i) {
    ParameterPath path{start_parameters(), {}, {}};
    for (auto& leg : path.target)
      for (Complex& each : leg) each = Complex(normal(engine), 0.5 * normal(engine));
    std::vector<Solution> ends;
    for (const PathEnd& end : followed(path, start_solutions(), {})) {
      ASSERT_EQ(end.ending, Ending::regular) << "platform " << i;
      ends.push_back(end.solution);
      EXPECT_LT(largest_residual(path.target, end.solution), 1e-9) << "platform " << i;
    }
    EXPECT_EQ(distinct(ends), 40) << "platform " << i;
  }
}

TEST(PlatformPaths, DistanceKnowsNoFactors) {
  const Solution& s = start_solutions()[0];
  Solution same = s;
  for (Complex& each : same) each *= std::polar(1.0, 2.0);
  EXPECT_LT(distance(s, same), 1e-15);
  EXPECT_GT(distance(s, start_solutions()[1]), 1e-3);
  EXPECT_LE(distance(s, start_solutions()[1]), std::sqrt(2.0) + 1e-12);
}

TEST(ComplexLanes, SolveLikeEigenWithZeroPivots) {
  std::mt19937 engine(4);
  std::normal_distribution<double> normal;
  lanes::Complex equations[5][6];
  std::array<Eigen::Matrix<Complex, 5, 6>, lanes::count> plain;
  for (int lane = 0; lane < lanes::count; ++lane)
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 6; ++j) {
        const Complex value = i + lane == j ? Complex{} : Complex(normal(engine), normal(engine));
        plain[static_cast<std::size_t>(lane)](i, j) = value;
        equations[i][j].re[lane] = value.real();
        equations[i][j].im[lane] = value.imag();
      }
  lanes::solve(equations);
  for (int lane = 0; lane < lanes::count; ++lane) {
    const auto& matrix = plain[static_cast<std::size_t>(lane)];
    const Eigen::Matrix<Complex, 5, 1> expected = matrix.leftCols<5>().fullPivLu().solve(matrix.col(5));
    for (int i = 0; i < 5; ++i)
      EXPECT_LT(std::abs(Complex(equations[i][5].re[lane], equations[i][5].im[lane]) - expected[i]), 1e-11);
  }
}

}  // namespace
}  // namespace parallel_aspects::platform_paths
