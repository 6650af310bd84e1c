// SPDX-License-Identifier: BSD-3-Clause
// Matrices that are proved regular, refuted by sampling and by searching for the least determinant.
#include "distance/regular_ball.h"

#include "distance/quadratic_form.h"
#include "interval/interval.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace parallel_aspects {
namespace {

using Vector = std::array<double, 6>;
using Matrix = Eigen::Matrix<double, 6, 6>;

// What is added to some rows: nothing, gaps, or roots of functions that may be negative in part of the ball,
// where the matrix does not count.
enum class Added { nothing, gaps, roots };

// Row j is  constant + linear + quadratic + cubic + g along_j,  with |g| <= gap_j or g = sqrt(squared_j).
class RandomMatrix {
 public:
  RandomMatrix(std::uint64_t seed, Added added) : added_(added), engine_(seed) {
    const double linear = 0.3 * std::abs(normal_(engine_)) + 0.02;
    for (std::size_t j = 0; j < 6; ++j) {
      is_added_[j] = added != Added::nothing && j % 2 == 0;
      gaps_[j] = added == Added::gaps && is_added_[j] ? 0.05 * std::abs(normal_(engine_)) : 0.0;
      square_[j] = 0.05 + 0.1 * std::abs(normal_(engine_));
      for (double& each : square_slope_[j]) each = 0.3 * normal_(engine_);
      for (std::size_t i = 0; i < 6; ++i) {
        constant_[j][i] = (i == j ? 2.0 : 0.0) + 0.5 * normal_(engine_);
        along_[j][i] = normal_(engine_);
        cube_[j][i] = 0.1 * linear * normal_(engine_);
        for (std::size_t k = 0; k < 6; ++k) {
          slope_[j][i][k] = linear * normal_(engine_);
          bend_[j][i][k] = 0.2 * linear * normal_(engine_);
        }
      }
    }
  }

  template <class Scalar>
  Scalar entry(std::size_t j, std::size_t i, const std::array<Scalar, 6>& e) const {
    Scalar sum(constant_[j][i]);
    for (std::size_t k = 0; k < 6; ++k)
      sum = sum + e[k] * (Scalar(slope_[j][i][k]) + e[(k + 1) % 6] * Scalar(bend_[j][i][k]));
    return sum + (e[i] * e[j]) * (e[(i + 1) % 6] * Scalar(cube_[j][i]));
  }
  template <class Scalar>
  Scalar along(std::size_t j, std::size_t i, const std::array<Scalar, 6>& e) const {
    return Scalar(along_[j][i]) + e[i] * Scalar(0.3);
  }

  template <class Scalar>
  Scalar squared(std::size_t j, const std::array<Scalar, 6>& e) const {
    Scalar sum(square_[j]);
    for (std::size_t k = 0; k < 6; ++k) sum = sum + e[k] * Scalar(square_slope_[j][k]);
    return sum + e[j] * e[(j + 1) % 6];
  }

  RowsInBall rows(double radius) const {
    std::array<CubicForm<6>, 6> e;
    for (std::size_t i = 0; i < 6; ++i) e[i] = CubicForm<6>::coordinate(0.0, radius, i);
    RowsInBall result;
    result.gaps = gaps_;
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t i = 0; i < 6; ++i) {
        result.rows[j][i] = entry(j, i, e);
        result.along[j][i] = along(j, i, e);
      }
    for (std::size_t j = 0; j < 6 && added_ == Added::roots; ++j) {
      if (!is_added_[j]) continue;
      const RootInBall<CubicForm<6>> root(squared(j, e));
      for (std::size_t i = 0; i < 6; ++i) result.rows[j][i] += root.middle * result.along[j][i];
      result.gaps[j] = root.gap;
    }
    return result;
  }

  // Infinite where a root is none.
  double determinant(const Vector& e, const Vector& g) const {
    Matrix result;
    for (std::size_t j = 0; j < 6; ++j) {
      double factor = g[j] * gaps_[j];
      if (added_ == Added::roots && is_added_[j]) {
        if (!(squared(j, e) >= 0.0)) return std::numeric_limits<double>::infinity();
        factor = std::sqrt(squared(j, e));
      }
      for (std::size_t i = 0; i < 6; ++i)
        result(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) =
            entry(j, i, e) + factor * along(j, i, e);
    }
    return result.determinant();
  }

  // Whether some root ends within the ball, to the first order.
  bool ends_within(double radius) const {
    for (std::size_t j = 0; j < 6; ++j) {
      double length = 0.0;
      for (const double each : square_slope_[j]) length = std::hypot(length, each);
      if (added_ == Added::roots && is_added_[j] && square_[j] < length * radius) return true;
    }
    return false;
  }

  // The least determinant, as a share of that at the center, that some walks in the ball find.
  double least_determinant(double radius) {
    const double center = determinant({}, {});
    double least = 1.0;
    for (int walk = 0; walk < 12; ++walk) {
      Vector e{}, g{};
      double here = 1.0;
      for (int step = 0; step < 300; ++step) {
        Vector f = e, h = g;
        const double length = step < 40 ? 1.0 : 0.3 * std::pow(0.985, step);
        for (double& each : f) each += length * radius * normal_(engine_);
        for (double& each : h)
          each = std::abs(normal_(engine_)) < 0.7 ? each : normal_(engine_) < 0.0 ? -1.0 : 1.0;
        double norm = 0.0;
        for (const double each : f) norm = std::hypot(norm, each);
        if (norm > radius)
          for (double& each : f) each *= radius / norm;
        const double reached = determinant(f, h), value = reached / center;
        if (!std::isfinite(reached) || !(value < here)) continue;
        here = value;
        e = f;
        g = h;
      }
      least = std::min(least, here);
    }
    return least;
  }

 private:
  Added added_;
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
  std::array<bool, 6> is_added_{};
  std::array<double, 6> gaps_{}, square_{};
  std::array<Vector, 6> constant_{}, along_{}, cube_{}, square_slope_{};
  std::array<std::array<Vector, 6>, 6> slope_{}, bend_{};
};

double proved_radius(const RandomMatrix& matrix, double radius) {
  const RoundingUpward rounding;
  return RegularBall(matrix.rows(radius)).proved_share() * radius;
}

class RegularBalls : public testing::TestWithParam<Added> {};

TEST_P(RegularBalls, HoldNoSingularMatrix) {
  int proved = 0, sharp = 0, ending = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    RandomMatrix matrix(seed, GetParam());
    const double radius = proved_radius(matrix, 0.05 + 0.01 * static_cast<double>(seed % 40));
    if (!(radius > 0.0)) continue;
    ++proved;
    if (matrix.ends_within(radius)) ++ending;
    ASSERT_GT(matrix.least_determinant(radius * (1.0 - 1e-9)), 0.0)
        << "seed " << seed << " radius " << radius;
    if (matrix.least_determinant(2.5 * radius) <= 0.0) ++sharp;
  }
  EXPECT_GT(proved, 75);
  EXPECT_GT(sharp, 10);
  if (GetParam() == Added::roots) {
    EXPECT_GT(ending, 25);
  }
}

INSTANTIATE_TEST_SUITE_P(RegularBall, RegularBalls,
                         testing::Values(Added::nothing, Added::gaps, Added::roots));

// det = 1 - s^2 vanishes at s = 1 in the direction of the first coordinate.
TEST(RegularBall, EndsBeforeASingularity) {
  const RoundingUpward rounding;
  for (const double radius : {0.5, 0.9, 0.99, 1.01, 1.5}) {
    RowsInBall rows;
    for (std::size_t j = 0; j < 6; ++j) rows.rows[j][j] = 1.0;
    rows.rows[0][0] += CubicForm<6>::coordinate(0.0, radius, 0);
    rows.rows[1][1] = rows.rows[1][1] - CubicForm<6>::coordinate(0.0, radius, 0);
    const double proved = RegularBall(rows).proved_share() * radius;
    EXPECT_LT(proved, 1.0);
    EXPECT_GT(proved, radius < 0.7 ? 0.49 : 0.65);
  }
}

// det = 1 + g s^k with |g| <= 1 may vanish from |s| = 1 on, whatever the degree k of what the gap adds.
TEST(RegularBall, EndsBeforeASingularityOfAGapOfEachDegree) {
  const RoundingUpward rounding;
  for (const double radius : {0.25, 0.9, 1.1, 1.5})
    for (const int degree : {1, 2, 3}) {
      RowsInBall rows;
      for (std::size_t j = 0; j < 6; ++j) rows.rows[j][j] = 1.0;
      rows.gaps[0] = 1.0;
      rows.along[0][0] = 1.0;
      const CubicForm<6> s = CubicForm<6>::coordinate(0.0, radius, 0);
      for (int i = 0; i < degree; ++i) rows.along[0][0] = rows.along[0][0] * s;
      const double proved = RegularBall(rows).proved_share() * radius;
      EXPECT_LT(proved, 1.0) << degree;
      EXPECT_GE(proved, radius < 0.7 ? radius : 0.0) << degree;
    }
}

TEST(RegularBall, ASingularCenterProvesNothing) {
  const RoundingUpward rounding;
  EXPECT_EQ(RegularBall(RowsInBall()).proved_share(), 0.0);
}

}  // namespace
}  // namespace parallel_aspects
