// SPDX-License-Identifier: BSD-3-Clause
// Against the determinants of Eigen, in numbers.
#include "legs/determinant.h"

#include "legs/leg_rows.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "support/robots/random_robots.h"
#include <array>
#include <cstddef>

namespace parallel_aspects {
namespace {

template <std::size_t N>
using Rows = std::array<Row<double, N>, N>;

template <std::size_t N>
Row<double, N> random_row(test::RandomRobots& random) {
  Row<double, N> row{};
  for (double& entry : row) entry = random.uniform(-1.0, 1.0);
  return row;
}

template <std::size_t N>
double determinant_by_eigen(const Rows<N>& rows) {
  Eigen::Matrix<double, static_cast<int>(N), static_cast<int>(N)> matrix;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j)
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
  return matrix.determinant();
}

template <std::size_t N>
void expect_determinant_of_matrices() {
  test::RandomRobots random(20261121);
  for (int i = 0; i < 1000; ++i) {
    Rows<N> rows;
    for (auto& row : rows) row = random_row<N>(random);
    ASSERT_NEAR(determinant_of(rows), determinant_by_eigen<N>(rows), 1e-12) << N << " rows, trial " << i;
  }
}

TEST(Determinant, IsThatOfEigen) {
  expect_determinant_of_matrices<1>();
  expect_determinant_of_matrices<2>();
  expect_determinant_of_matrices<3>();
  expect_determinant_of_matrices<6>();
}

// In an order that asks for every one twice, so that what is kept of earlier ones is used.
template <std::size_t N>
void expect_determinants_of_branches() {
  test::RandomRobots random(20261122);
  for (int i = 0; i < 20; ++i) {
    std::array<BranchRows<double, N>, N> legs;
    for (auto& leg : legs) {
      leg.positive = random_row<N>(random);
      leg.negative = random_row<N>(random);
    }
    Determinants<double, N> determinants(legs);
    for (std::size_t choice = 0; choice < std::size_t{2} << N; ++choice) {
      std::array<int, N> signs{};
      Rows<N> rows;
      for (std::size_t j = 0; j < N; ++j) {
        signs[j] = (choice >> j) % 2 == 0 ? 1 : -1;
        rows[j] = legs[j].of(signs[j]);
      }
      ASSERT_NEAR(determinants.of(signs), determinant_by_eigen<N>(rows), 1e-12) << N << " legs, " << choice;
    }
  }
}

TEST(Determinants, AreThoseOfTheRowsOfEachBranch) {
  expect_determinants_of_branches<1>();
  expect_determinants_of_branches<2>();
  expect_determinants_of_branches<3>();
  expect_determinants_of_branches<6>();
}

TEST(BranchRows, AreFixedAndTurnedBySign) {
  const LegRows<double, 2> leg{9.0, {1.0, 2.0}, {0.5, -1.0}};
  const BranchRows<double, 2> rows = branch_rows(leg, 3.0);
  EXPECT_EQ(rows.of(1), (Row<double, 2>{2.5, -1.0}));
  EXPECT_EQ(rows.of(-1), (Row<double, 2>{-0.5, 5.0}));
}

}  // namespace
}  // namespace parallel_aspects
