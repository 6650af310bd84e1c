// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_LEG_ROWS_H
#define PARALLEL_ASPECTS_LEGS_LEG_ROWS_H

#include "interval/dual.h"
#include "interval/interval.h"
#include "legs/determinant.h"
#include "model/task_space_traits.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// One leg over a box: B_jj^2, and its row of A as `fixed + B_jj turned`, up to a positive factor.
template <class Scalar, std::size_t N>
struct LegRows {
  Scalar squared_b_entry;
  Row<Scalar, N> fixed, turned;
};

/// Of a leg of this form (see PlanarLeg, SpatialLeg), whose anchor is at b seen from the operational point.
template <TaskSpace space, template <class> class Form, class Scalar, class Arm>
LegRows<Scalar, traits(space).degrees_of_freedom()> leg_rows(const Form<Scalar>& form, const Arm& b) {
  LegRows<Scalar, traits(space).degrees_of_freedom()> rows;
  rows.squared_b_entry = form.squared_b_entry;
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
    return determinant(rows_[0].of(signs[0]), minors_[pair]);
  }

 private:
  const std::array<BranchRows<Scalar, 3>, 3>& rows_;
  std::array<Row<Scalar, 3>, 4> minors_;
  std::array<bool, 4> known_{};
};

/// The minors of the first three rows serve all branches of the last three, and the other way round.
template <class Scalar>
class Determinants<Scalar, 6> {
 public:
  explicit Determinants(const std::array<BranchRows<Scalar, 6>, 6>& rows) : rows_(rows) {}

  Scalar of(const std::array<int, 6>& signs) { return determinant(minors(0, signs), minors(3, signs)); }

 private:
  /// Of the rows `first` to `first` + 2.
  const TripleMinors<Scalar>& minors(std::size_t first, const std::array<int, 6>& signs) {
    std::size_t branches = first == 0 ? 0 : 8;
    for (std::size_t j = 0; j < 3; ++j) branches += signs[first + j] > 0 ? 0U : std::size_t{1} << j;
    if (!known_[branches]) {
      minors_[branches].find(rows_[first].of(signs[first]), rows_[first + 1].of(signs[first + 1]),
                             rows_[first + 2].of(signs[first + 2]));
      known_[branches] = true;
    }
    return minors_[branches];
  }

  const std::array<BranchRows<Scalar, 6>, 6>& rows_;
  std::array<TripleMinors<Scalar>, 16> minors_;
  std::array<bool, 16> known_{};
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_LEG_ROWS_H
