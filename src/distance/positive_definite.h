// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_POSITIVE_DEFINITE_H
#define PARALLEL_ASPECTS_DISTANCE_POSITIVE_DEFINITE_H

#include <Eigen/Core>

#include <cmath>

namespace parallel_aspects {

/// Whether a symmetric matrix of up to 42 rows, of which the lower half is given, is proved to be positive
/// definite: where the factorization of it less c I ends, with c more than its rounding, 43 parts in 2^52 of
/// the trace (Rump 2006). Its entries may be off by a rounding of the trace. Overwrites the matrix; in every
/// rounding direction.
template <int N>
bool is_positive_definite(Eigen::Matrix<double, N, N>& a) noexcept {
  static_assert(N <= 42);
  constexpr double smallest = 0x1p-800;  // products that underflow are off by far less than a rounding of it
  const double trace = a.trace();
  if (!(trace > smallest) || !std::isfinite(trace)) return false;
  a.diagonal().array() -= 0x1p-45 * trace;
  for (Eigen::Index k = 0; k < N; ++k) {
    if (!(a(k, k) > 0.0)) return false;
    const double pivot = std::sqrt(a(k, k));
    double* const column = &a(0, k);
    for (Eigen::Index i = k; i < N; ++i) column[i] /= pivot;
    for (Eigen::Index j = k + 1; j < N; ++j) {
      double* const other = &a(0, j);
      const double factor = column[j];
      for (Eigen::Index i = j; i < N; ++i) other[i] -= factor * column[i];
    }
  }
  return true;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_POSITIVE_DEFINITE_H
