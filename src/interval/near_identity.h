// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_NEAR_IDENTITY_H
#define PARALLEL_ASPECTS_INTERVAL_NEAR_IDENTITY_H

#include "interval/interval.h"
#include "model/linear_algebra.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace parallel_aspects {

/// Proves matrices A to be nonsingular: with C an approximate inverse of their center, all entries of A C - I
/// are at most those of some matrix E >= 0 with a spectral radius below 1. A is the center, plus
/// multiples from -1 to 1 of some slopes, plus errors of its entries. Needs a live `RoundingUpward`: every
/// sum and product rounds upward, so products of matrices are upper bounds, and those of negated ones bound
/// from below.
template <int N>
class NearIdentity {
 public:
  using Matrix = Eigen::Matrix<double, N, N>;

  explicit NearIdentity(const Matrix& center)
      : inverse_(approximate_inverse(center)), negated_(-inverse_), is_finite_(inverse_.allFinite()) {
    assert_rounding_upward();
    const Matrix above = center * inverse_ - Matrix::Identity();
    const Matrix below = center * negated_ + Matrix::Identity();
    deviation_ = above.cwiseMax(below);
  }

  void add_slope(const Matrix& slope) {
    const Matrix rising = slope * inverse_, falling = slope * negated_;
    deviation_ += rising.cwiseMax(falling);
  }

  /// Entries are off by this much at most.
  void add_error(const Matrix& error) { deviation_ += error * inverse_.cwiseAbs(); }

  /// Collatz and Wielandt: the spectral radius of E >= 0 is at most the largest (E v)_i / v_i, for any v > 0.
  /// `ratio` becomes an upper bound of it; infinite where there is none.
  bool is_nonsingular(int max_iterations, double& ratio) const {
    using Vector = Eigen::Matrix<double, N, 1>;
    ratio = std::numeric_limits<double>::infinity();
    if (!is_finite_) return false;
    Vector v = Vector::Ones();
    for (int i = 0; i < max_iterations; ++i) {
      const Vector image = deviation_ * v;
      if (!image.allFinite()) return false;
      ratio = std::min(ratio, image.cwiseQuotient(v).maxCoeff());
      if ((image.array() < v.array()).all()) return true;
      v = image.cwiseMax(1e-9 * image.maxCoeff());
    }
    return false;
  }

 private:
  static Matrix approximate_inverse(const Matrix& center) {
    if constexpr (N <= 4)
      return center.inverse();
    else
      return inverse(center);
  }

  Matrix inverse_, negated_;
  bool is_finite_;
  Matrix deviation_;  // E
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_NEAR_IDENTITY_H
