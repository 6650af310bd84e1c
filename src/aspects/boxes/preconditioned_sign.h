// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_PRECONDITIONED_SIGN_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_PRECONDITIONED_SIGN_H

#include "interval/affine.h"
#include "interval/nonsingular.h"
#include "legs/leg_rows.h"

#include <Eigen/LU>

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// The sign of the determinant of a matrix of affine forms over a box; 0 where it is not proved. With C an
/// approximate inverse of the matrix A_0 of centers, all entries of A C - I are at most those of some E >= 0
/// with E v < v for a positive vector v, so that every matrix between is nonsingular and has the sign of A_0
/// (see `proved_nonsingular`). Where rows are close to dependent this is much tighter than an affine form of
/// the determinant. Needs a live `RoundingUpward`.
template <std::size_t Size, std::size_t Coordinates>
class PreconditionedSign {
 public:
  using Form = Affine<Coordinates>;
  using Rows = std::array<const Row<Form, Size>*, Size>;

  static int of(const Rows& rows) {
    const Matrix inverse =
        Matrix(of_entries(rows, [](const Form& entry) { return entry.center(); })).inverse();
    if (!inverse.allFinite() || !has_small_radius(deviation(rows, inverse))) return 0;
    SquareArray<Interval> centers;
    for (std::size_t i = 0; i < Size; ++i)
      for (std::size_t k = 0; k < Size; ++k) centers[i][k] = Interval((*rows[i])[k].center());
    return proved_determinant_sign(Size, centers);
  }

 private:
  static constexpr int order = static_cast<int>(Size);
  static constexpr int most_iterations = 4;
  using Matrix = Eigen::Matrix<double, order, order>;
  using Vector = Eigen::Matrix<double, order, 1>;

  template <class Function>
  static Matrix of_entries(const Rows& rows, const Function& function) {
    Matrix result;
    for (std::size_t i = 0; i < Size; ++i)
      for (std::size_t k = 0; k < Size; ++k)
        result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = function((*rows[i])[k]);
    return result;
  }

  // Every sum and product rounds upward, so products of matrices are upper bounds, and those of negated ones
  // bound from below.
  static Matrix deviation(const Rows& rows, const Matrix& inverse) {
    const Matrix negated = -inverse;
    const Matrix center = of_entries(rows, [](const Form& entry) { return entry.center(); });
    const Matrix above = center * inverse - Matrix::Identity(), below = center * negated + Matrix::Identity();
    const Matrix error = of_entries(rows, [](const Form& entry) { return entry.error(); });
    Matrix sum = above.cwiseMax(below) + error * inverse.cwiseAbs();
    for (std::size_t i = 0; i < Coordinates; ++i) {
      const Matrix slope = of_entries(rows, [i](const Form& entry) { return entry.slope(i); });
      const Matrix rising = slope * inverse, falling = slope * negated;
      sum += rising.cwiseMax(falling);
    }
    return sum;
  }

  // Collatz and Wielandt: the spectral radius of E >= 0 is below 1 if E v < v for some v > 0.
  static bool has_small_radius(const Matrix& e) {
    Vector v = Vector::Ones();
    for (int i = 0; i < most_iterations; ++i) {
      const Vector image = e * v;
      if (!image.allFinite()) return false;
      if ((image.array() < v.array()).all()) return true;
      v = image.cwiseMax(1e-9 * image.maxCoeff());
    }
    return false;
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_PRECONDITIONED_SIGN_H
