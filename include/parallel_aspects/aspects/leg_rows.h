// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_LEG_ROWS_H
#define PARALLEL_ASPECTS_ASPECTS_LEG_ROWS_H

#include "parallel_aspects/aspects/dual.h"
#include "parallel_aspects/aspects/interval.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// One row of A up to a positive factor.
template <class Scalar, std::size_t N>
using Row = std::array<Scalar, N>;

/// One leg over a box: B_jj^2, and its row of A as `fixed + B_jj turned`, up to a positive factor.
template <class Scalar, std::size_t N>
struct LegRows {
  Scalar squared_entry;
  Row<Scalar, N> fixed, turned;
};

/// Rows of A of one leg for both signs of B_jj.
template <class Scalar, std::size_t N>
struct BranchRows {
  Row<Scalar, N> positive, negative;

  const Row<Scalar, N>& of(int sign) const { return sign > 0 ? positive : negative; }
};

template <class Scalar, std::size_t N>
BranchRows<Scalar, N> branch_rows(const LegRows<Scalar, N>& leg, const Scalar& entry) {
  BranchRows<Scalar, N> rows;
  for (std::size_t i = 0; i < N; ++i) {
    const Scalar turned = entry * leg.turned[i];
    rows.positive[i] = leg.fixed[i] + turned;
    rows.negative[i] = leg.fixed[i] - turned;
  }
  return rows;
}

template <class Scalar>
Scalar determinant(const Row<Scalar, 2>& a, const Row<Scalar, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Determinants of A for every combination of the legs' branches.
template <class Scalar, std::size_t N>
class Determinants;

template <class Scalar>
class Determinants<Scalar, 1> {
 public:
  explicit Determinants(const std::array<BranchRows<Scalar, 1>, 1>& rows) : rows_(rows) {}

  Scalar of(const std::array<int, 1>& signs) { return rows_[0].of(signs[0])[0]; }

 private:
  const std::array<BranchRows<Scalar, 1>, 1>& rows_;
};

template <class Scalar>
class Determinants<Scalar, 2> {
 public:
  explicit Determinants(const std::array<BranchRows<Scalar, 2>, 2>& rows) : rows_(rows) {}

  Scalar of(const std::array<int, 2>& signs) {
    return determinant(rows_[0].of(signs[0]), rows_[1].of(signs[1]));
  }

 private:
  const std::array<BranchRows<Scalar, 2>, 2>& rows_;
};

/// The cross product of the last two rows serves both branches of the first.
template <class Scalar>
class Determinants<Scalar, 3> {
 public:
  explicit Determinants(const std::array<BranchRows<Scalar, 3>, 3>& rows) : rows_(rows) {}

  Scalar of(const std::array<int, 3>& signs) {
    const std::size_t pair = (signs[1] > 0 ? 0U : 1U) + (signs[2] > 0 ? 0U : 2U);
    if (!known_[pair]) {
      minors_[pair] = cross(rows_[1].of(signs[1]), rows_[2].of(signs[2]));
      known_[pair] = true;
    }
    const Row<Scalar, 3>&first = rows_[0].of(signs[0]), &minor = minors_[pair];
    return first[0] * minor[0] + first[1] * minor[1] + first[2] * minor[2];
  }

 private:
  static Row<Scalar, 3> cross(const Row<Scalar, 3>& a, const Row<Scalar, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  const std::array<BranchRows<Scalar, 3>, 3>& rows_;
  std::array<Row<Scalar, 3>, 4> minors_;
  std::array<bool, 4> known_{};
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_LEG_ROWS_H
