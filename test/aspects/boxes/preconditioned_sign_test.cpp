// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/boxes/box_forms.h"
#include "interval/interval.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <array>
#include <random>

namespace parallel_aspects {
namespace {

using Form = Affine<2>;
using Matrix = Eigen::Matrix<double, 6, 6>;

/// A matrix that is linear in two coordinates of a box, with a random center, and its affine forms.
struct Family {
  Matrix center, first, second;
  std::array<Row<Form, 6>, 6> rows;

  Family(std::mt19937_64& random, double spread) {
    std::normal_distribution<double> normal;
    const auto fill = [&](Matrix& matrix, double scale) {
      matrix = matrix.NullaryExpr([&](Eigen::Index, Eigen::Index) { return scale * normal(random); });
    };
    fill(center, 1.0);
    fill(first, spread);
    fill(second, spread);
    const RoundingUpward rounding;
    const Form x = Form::coordinate(Interval(-1.0, 1.0), 0), y = Form::coordinate(Interval(-1.0, 1.0), 1);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t k = 0; k < 6; ++k) {
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(k);
        rows[i][k] = Form(center(row, column)) +
                     (Interval(first(row, column)) * x + Interval(second(row, column)) * y);
      }
  }

  int sign() const {
    PreconditionedSign<6, 2>::Rows pointers;
    for (std::size_t i = 0; i < 6; ++i) pointers[i] = &rows[i];
    const RoundingUpward rounding;
    return PreconditionedSign<6, 2>::of(pointers);
  }

  int sign_of_the_affine_determinant() const {
    std::array<BranchRows<Form, 6>, 6> branches;
    for (std::size_t i = 0; i < 6; ++i) branches[i].positive = branches[i].negative = rows[i];
    const RoundingUpward rounding;
    const Interval range = Determinants<Form, 6>(branches).of({1, 1, 1, 1, 1, 1}).range();
    return range.positive() ? 1 : range.negative() ? -1 : 0;
  }
};

TEST(PreconditionedSign, HoldsAtEveryPoint) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> share(-1.0, 1.0), size(-4.0, -0.5);
  int proved = 0, by_affine_form = 0;
  for (int i = 0; i < 3000; ++i) {
    const Family family(random, std::pow(10.0, size(random)));
    const int sign = family.sign(), other = family.sign_of_the_affine_determinant();
    proved += sign != 0;
    by_affine_form += other != 0;
    for (int k = 0; k < 20; ++k) {
      // Corners too, where a singularity shows first.
      const double x = k < 4 ? (k % 2 == 0 ? -1.0 : 1.0) : share(random);
      const double y = k < 4 ? (k / 2 == 0 ? -1.0 : 1.0) : share(random);
      const double determinant = (family.center + x * family.first + y * family.second).determinant();
      if (std::abs(determinant) < 1e-9) continue;
      const int expected = determinant > 0.0 ? 1 : -1;
      ASSERT_TRUE(sign == 0 || sign == expected) << "family " << i << " at " << x << ", " << y;
      ASSERT_TRUE(other == 0 || other == expected) << "family " << i << " at " << x << ", " << y;
    }
  }
  EXPECT_GT(proved, 1500);
  EXPECT_GT(proved, by_affine_form);
  EXPECT_GT(by_affine_form, 500);
}

TEST(PreconditionedSign, IsNotProvedWhereThereIsNone) {
  std::mt19937_64 random(22);
  Family family(random, 1e-3);
  family.rows[2] = family.rows[4];
  EXPECT_EQ(family.sign(), 0);
  family.rows[2].fill(Form(0.0));
  EXPECT_EQ(family.sign(), 0);
}

}  // namespace
}  // namespace parallel_aspects
