// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_LEG_ROWS_H
#define PARALLEL_ASPECTS_LEGS_LEG_ROWS_H

#include "interval/dual.h"
#include "interval/interval.h"
#include "model/matrix_row.h"

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

/// Of a leg of this form (see PlanarLeg, SpatialLeg), whose anchor is at b seen from the operational point.
template <TaskSpace space, template <class> class Form, class Scalar, class Arm>
LegRows<Scalar, traits(space).degrees_of_freedom()> leg_rows(const Form<Scalar>& form, const Arm& b) {
  LegRows<Scalar, traits(space).degrees_of_freedom()> rows;
  rows.squared_entry = form.squared_entry;
  write_row<space>(b, form.fixed, rows.fixed);
  write_row<space>(b, form.turned, rows.turned);
  return rows;
}

/// The same where the platform does not turn.
template <TaskSpace space, template <class> class Form, class Scalar>
LegRows<Scalar, traits(space).degrees_of_freedom()> leg_rows(const Form<Scalar>& form) {
  static_assert(traits(space).rotations == 0);
  return leg_rows<space>(form, form.fixed);
}

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

/// The minors of three rows of six, by column triples; those of the other three rows serve all branches of
/// these, and the other way round (Laplace's expansion along three rows).
template <class Scalar>
class Determinants<Scalar, 6> {
 public:
  explicit Determinants(const std::array<BranchRows<Scalar, 6>, 6>& rows) : rows_(rows) {}

  Scalar of(const std::array<int, 6>& signs) {
    const Minors &upper = minors(0, signs), &lower = minors(3, signs);
    Scalar sum = upper[0] * lower[triple_count - 1];
    // In this order the complement of a triple stands as far from the end as the triple from the start.
    for (std::size_t k = 1; k < triple_count; ++k) {
      const Scalar product = upper[k] * lower[triple_count - 1 - k];
      sum = is_odd(triples[k]) ? sum - product : sum + product;
    }
    return sum;
  }

 private:
  using Triple = std::array<std::size_t, 3>;
  static constexpr std::size_t triple_count = 20;
  static constexpr std::array<Triple, triple_count> triples{
      {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {0, 2, 3}, {0, 2, 4}, {0, 2, 5},
       {0, 3, 4}, {0, 3, 5}, {0, 4, 5}, {1, 2, 3}, {1, 2, 4}, {1, 2, 5}, {1, 3, 4},
       {1, 3, 5}, {1, 4, 5}, {2, 3, 4}, {2, 3, 5}, {2, 4, 5}, {3, 4, 5}}};
  using Minors = std::array<Scalar, triple_count>;

  /// Whether moving these columns to the front takes an odd number of exchanges.
  static constexpr bool is_odd(const Triple& columns) {
    return (columns[0] + columns[1] + columns[2] + 1) % 2 != 0;
  }

  /// Of the rows `first` to `first` + 2.
  const Minors& minors(std::size_t first, const std::array<int, 6>& signs) {
    std::size_t branches = first == 0 ? 0 : 8;
    for (std::size_t j = 0; j < 3; ++j) branches += signs[first + j] > 0 ? 0U : std::size_t{1} << j;
    if (!known_[branches]) {
      find(rows_[first].of(signs[first]), rows_[first + 1].of(signs[first + 1]),
           rows_[first + 2].of(signs[first + 2]), minors_[branches]);
      known_[branches] = true;
    }
    return minors_[branches];
  }

  static void find(const Row<Scalar, 6>& a, const Row<Scalar, 6>& b, const Row<Scalar, 6>& c,
                   Minors& result) {
    std::array<std::array<Scalar, 6>, 6> pairs;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t k = i + 1; k < 6; ++k) pairs[i][k] = b[i] * c[k] - b[k] * c[i];
    for (std::size_t k = 0; k < triple_count; ++k) {
      const auto [i, j, l] = triples[k];
      result[k] = a[i] * pairs[j][l] - a[j] * pairs[i][l] + a[l] * pairs[i][j];
    }
  }

  const std::array<BranchRows<Scalar, 6>, 6>& rows_;
  std::array<Minors, 16> minors_;
  std::array<bool, 16> known_{};
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_LEG_ROWS_H
