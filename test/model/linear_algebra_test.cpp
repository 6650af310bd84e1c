// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace parallel_aspects {
namespace {

Eigen::Vector3d random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return {uniform(random), uniform(random), uniform(random)};
}

void expect_shortest(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Quaterniond turn = shortest_rotation(from, to);
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  EXPECT_NEAR(turn.norm(), 1.0, 1e-15);
  EXPECT_LT((turn * a - b).norm(), 1e-7) << from.transpose() << " to " << to.transpose();
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  EXPECT_NEAR(2.0 * std::atan2(turn.vec().norm(), turn.w()), angle, 2e-7);
}

TEST(ShortestRotation, TurnsOneDirectionIntoTheOtherByTheAngleBetweenThem) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 1000; ++trial)
    expect_shortest(random_vector(random), 7.0 * random_vector(random));
}

TEST(ShortestRotation, IsHalfATurnBetweenOppositeDirectionsAndNearlySoBesideThem) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d from = random_vector(random);
    for (const double aside : {0.0, 1e-16, 1e-9, 1e-8, 1e-7, 1e-5, 1e-2})
      expect_shortest(from, -2.0 * from + aside * random_vector(random));
  }
  expect_shortest(Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitX());
}

TEST(SingularValues, OfSquareMatricesAreThoseOfTheGeneralDecomposition) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 1; n <= 6; ++n)
    for (int trial = 0; trial < 50; ++trial) {
      const TaskMatrix matrix = TaskMatrix::NullaryExpr(n, n, [&] { return uniform(random); });
      const TaskVector values = singular_values(matrix);
      ASSERT_EQ(values.size(), n);
      EXPECT_LT((values - singular_values(Eigen::MatrixXd(matrix))).norm(), 1e-13) << matrix;
      EXPECT_NEAR(values.squaredNorm(), matrix.squaredNorm(), 1e-13);
      EXPECT_NEAR(values.prod(), std::abs(determinant(matrix)), 1e-13);
    }
}

// One row and column more than a robot has legs; matrices of a fixed size too.
TEST(Inverse, OfSmallMatricesTakesThemToTheIdentity) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 1; n <= max_legs + 1; ++n) {
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return uniform(random); }) +
                                   2.0 * n * Eigen::MatrixXd::Identity(n, n);
    EXPECT_TRUE(product(matrix, inverse(matrix)).isIdentity(1e-14)) << matrix;
  }
  Eigen::Matrix<double, 6, 6> fixed = Eigen::Matrix<double, 6, 6>::Identity();
  fixed(0, 5) = 3.0;
  EXPECT_EQ(inverse(fixed)(0, 5), -3.0);
  EXPECT_FALSE(inverse(Eigen::Matrix2d::Ones()).allFinite());
}

// The general decompositions know the same line.
TEST(LineOfSolutions, SolvesTheEquationsNearestToZeroAndAlongWhatTheyLeaveOpen) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 1; n <= max_legs; ++n)
    for (int trial = 0; trial < 50; ++trial) {
      const TallMatrix matrix = TallMatrix::NullaryExpr(n + 1, n, [&] { return uniform(random); });
      const TaskVector right = TaskVector::NullaryExpr(n, [&] { return uniform(random); });
      const LineOfSolutions line = line_of_solutions(matrix, right);
      const Eigen::MatrixXd equations = matrix.transpose();
      const auto known = singular_value_decomposition(equations);
      const double least = known.values[n - 1];
      EXPECT_GE(line.least_pivot, (1.0 - 1e-12) * least) << matrix;
      if (least < 1e-3) continue;
      EXPECT_LT((line.nearest - least_squares_solution(equations, right, 1e-12)).norm(), 1e-9) << matrix;
      EXPECT_NEAR(std::abs(line.along.dot(known.null_space(n).col(0))), 1.0, 1e-10) << matrix;
      EXPECT_NEAR(line.along.norm(), 1.0, 1e-14);
    }
}

TEST(LineOfSolutions, HasAPivotOfZeroWhereTheEquationsAreDependent) {
  TallMatrix matrix = TallMatrix::Zero(4, 3);
  matrix(0, 0) = 2.0;
  matrix(1, 1) = 1.0;
  EXPECT_EQ(line_of_solutions(matrix, TaskVector::Zero(3)).least_pivot, 0.0);
  matrix(3, 2) = -3.0;
  const LineOfSolutions line = line_of_solutions(matrix, TaskVector::Constant(3, 6.0));
  EXPECT_EQ(line.least_pivot, 1.0);
  EXPECT_LT((line.nearest - Eigen::Vector4d(3.0, 6.0, 0.0, -2.0)).norm(), 1e-14);
  EXPECT_EQ(std::abs(line.along[2]), 1.0);
}

}  // namespace
}  // namespace parallel_aspects
