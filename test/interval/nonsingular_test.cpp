// SPDX-License-Identifier: BSD-3-Clause
#include "interval/nonsingular.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmpxx.h>
#include <random>

namespace parallel_aspects {
namespace {

using Numbers = SquareArray<double>;

// Exact, over rational numbers.
int exact_sign(std::size_t size, const Numbers& matrix) {
  SquareArray<mpq_class> rows;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k < size; ++k) rows[i][k] = matrix[i][k];
  int sign = 1;
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    while (pivot < size && rows[pivot][k] == 0) ++pivot;
    if (pivot == size) return 0;
    if (pivot != k) {
      std::swap(rows[pivot], rows[k]);
      sign = -sign;
    }
    sign *= sgn(rows[k][k]);
    for (std::size_t i = k + 1; i < size; ++i) {
      const mpq_class factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < size; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  return sign;
}

int proved_sign(std::size_t size, const Numbers& matrix) {
  SquareArray<Interval> intervals;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k < size; ++k) intervals[i][k] = Interval(matrix[i][k]);
  const RoundingUpward rounding;
  return proved_determinant_sign(size, intervals);
}

class RandomMatrices {
 public:
  explicit RandomMatrices(unsigned seed) : engine_(seed) {}

  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(engine_);
  }

  // Entries of very different sizes where `spread` is large.
  Numbers general(std::size_t size, double spread) {
    Numbers matrix{};
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k)
        matrix[i][k] = uniform(-1.0, 1.0) * std::pow(10.0, uniform(-spread, spread));
    return matrix;
  }

  // Small whole numbers, the last row a combination of two others: exactly singular.
  Numbers singular(std::size_t size) {
    Numbers matrix{};
    for (std::size_t i = 0; i + 1 < size; ++i)
      for (std::size_t k = 0; k < size; ++k) matrix[i][k] = std::round(uniform(-50.0, 50.0));
    for (std::size_t k = 0; k < size; ++k)
      matrix[size - 1][k] = size == 2 ? 2.0 * matrix[0][k] : matrix[0][k] - 3.0 * matrix[1][k];
    return matrix;
  }

 private:
  std::mt19937_64 engine_;
};

TEST(DeterminantSign, IsThatOfTheExactDeterminant) {
  RandomMatrices random(1);
  for (const std::size_t size : {2U, 3U, 6U}) {
    int decided = 0;
    constexpr int count = 3000;
    for (int i = 0; i < count; ++i) {
      const Numbers matrix = random.general(size, i % 2 == 0 ? 0.0 : 4.0);
      const int sign = proved_sign(size, matrix);
      decided += sign != 0;
      if (sign != 0) {
        ASSERT_EQ(sign, exact_sign(size, matrix)) << "size " << size << ", number " << i;
      }
    }
    EXPECT_GE(decided, 0.99 * count) << "size " << size;
  }
}

// Singular matrices, and those a few units in the last place from them.
TEST(DeterminantSign, IsNeverProvedOfSingularMatricesNorWronglyNextToThem) {
  RandomMatrices random(2);
  for (const std::size_t size : {2U, 3U, 6U}) {
    for (int i = 0; i < 2000; ++i) {
      Numbers matrix = random.singular(size);
      ASSERT_EQ(exact_sign(size, matrix), 0);
      ASSERT_EQ(proved_sign(size, matrix), 0);
      double& entry = matrix[static_cast<std::size_t>(i) % size][0];
      entry += entry * std::ldexp(1.0, -52 + i % 40);
      const int sign = proved_sign(size, matrix);
      if (sign != 0) {
        ASSERT_EQ(sign, exact_sign(size, matrix)) << "size " << size << ", number " << i;
      }
    }
  }
}

// A(s) = a + s b, with the slope of every entry widened at random.
SquareArray<PathForm> path(std::size_t size, const Numbers& a, const Numbers& b) {
  SquareArray<PathForm> matrix;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k < size; ++k) {
      matrix[i][k].center = Interval(a[i][k]);
      matrix[i][k].slope = Interval(b[i][k]);
      matrix[i][k].range = Interval(a[i][k]) + Interval(-1.0, 1.0) * matrix[i][k].slope;
    }
  return matrix;
}

// a + s b is singular at a chosen s in [-1, 1]: exactly so, as all numbers are small multiples of 1/16.
TEST(Nonsingular, IsNeverProvedOfPathsThroughASingularMatrix) {
  RandomMatrices random(3);
  for (const std::size_t size : {2U, 3U, 6U}) {
    for (int i = 0; i < 5000; ++i) {
      const Numbers singular = random.singular(size);
      const double scale = std::pow(2.0, -(i % 8));
      const double s = std::round(random.uniform(-16.0, 16.0)) / 16.0;
      Numbers a = singular, b{};
      for (std::size_t row = 0; row < size; ++row)
        for (std::size_t k = 0; k < size; ++k) {
          b[row][k] = scale * std::round(random.uniform(-20.0, 20.0));
          a[row][k] -= s * b[row][k];
        }
      double ratio = 0.0;
      const RoundingUpward rounding;
      ASSERT_FALSE(proved_nonsingular(size, path(size, a, b), ratio)) << "size " << size << ", number " << i;
      ASSERT_GE(ratio, 1.0);
    }
  }
}

// Of what is proved, no random point is singular or of another sign; and slow paths are proved.
TEST(Nonsingular, KeepsTheSignOfTheExactDeterminant) {
  RandomMatrices random(4);
  for (const std::size_t size : {2U, 3U, 6U}) {
    int slow = 0, proved_slow = 0;
    for (int i = 0; i < 300; ++i) {
      const Numbers a = random.general(size, 0.0);
      Numbers b = random.general(size, 0.0);
      const double scale = std::pow(10.0, random.uniform(-6.0, 0.0));
      for (auto& row : b)
        for (double& entry : row) entry *= scale;
      bool proved = false;
      double ratio = 0.0;
      {
        const RoundingUpward rounding;
        proved = proved_nonsingular(size, path(size, a, b), ratio);
      }
      slow += scale < 1e-4;
      proved_slow += proved && scale < 1e-4;
      for (int point = 0; proved && point < 20; ++point) {
        const double s = random.uniform(-1.0, 1.0);
        Numbers there = a;
        for (std::size_t row = 0; row < size; ++row)
          for (std::size_t k = 0; k < size; ++k) there[row][k] += s * b[row][k];
        ASSERT_EQ(exact_sign(size, there), exact_sign(size, a)) << "size " << size << ", number " << i;
      }
    }
    EXPECT_GE(proved_slow, 0.9 * slow);
  }
}

TEST(Nonsingular, NumbersThatAreNotFiniteProveNothing) {
  for (const double bad : {std::nan(""), HUGE_VAL, 1e308}) {
    Numbers a{}, b{};
    for (std::size_t i = 0; i < 6; ++i) a[i][i] = 1.0;
    b[2][3] = bad;
    double ratio = 0.0;
    const RoundingUpward rounding;
    EXPECT_FALSE(proved_nonsingular(6, path(6, a, b), ratio) && !std::isfinite(bad));
    EXPECT_FALSE(proved_nonsingular(6, path(6, b, a), ratio));
  }
}

}  // namespace
}  // namespace parallel_aspects
