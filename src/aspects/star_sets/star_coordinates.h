// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_COORDINATES_H
#define PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_COORDINATES_H

#include "aspects/boxes/box_forms.h"
#include "aspects/boxes/evaluated_legs.h"
#include "aspects/star_sets/star_conditions.h"
#include "interval/affine.h"
#include "interval/dual.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {

/// Coordinates in which a star is searched for: those of the pose, with the heights h = |B_jj| of `Levels`
/// legs in place of as many of them. Enclosures are affine forms of all pose coordinates and of the heights
/// besides.
template <class Chart, std::size_t Levels>
class StarCoordinates {
 public:
  static constexpr std::size_t size = Chart::coordinate_count, leg_count = Chart::leg_count;
  using Form = Affine<size + Levels>;

  std::array<std::size_t, Levels> leg{};           ///< whose heights are taken
  std::array<std::size_t, Levels> replaced{};      ///< the pose coordinate that each height stands for
  std::array<double, Levels> lowest{}, highest{};  ///< of the heights examined, which are positive

  bool is_replaced(std::size_t i) const noexcept {
    for (const std::size_t each : replaced)
      if (each == i) return true;
    return false;
  }

  LegSet legs() const noexcept {
    LegSet result = 0;
    for (const std::size_t j : leg) result |= BoxFacts::bit(j);
    return result;
  }

  Form height(std::size_t level) const noexcept {
    return Form::coordinate(Interval(lowest[level], highest[level]), size + level);
  }

  static std::array<Form, size> pose(const ChartBox<Chart>& at) {
    std::array<Form, size> result;
    for (std::size_t i = 0; i < size; ++i) result[i] = Form::coordinate(at.range(i), i);
    return result;
  }

  /// |B_jj| of every leg. That of a leg that is neither clear nor among the levels has no slope.
  template <class Entries>
  std::array<Form, leg_count> entries(const Entries& known, const PlacedLegs<Chart, Form>& placed) const {
    std::array<Form, leg_count> result;
    for (std::size_t j = 0; j < leg_count; ++j)
      result[j] = known.clear(j) ? square_root(placed.squared_b_entry(j), known.square(j).lower())
                                 : Form(known.value(j));
    for (std::size_t level = 0; level < Levels; ++level) result[leg[level]] = height(level);
    return result;
  }
};

/// A square matrix of numbers.
template <std::size_t N>
using Matrix = std::array<std::array<double, N>, N>;

/// Not finite where there is none.
template <std::size_t N>
Matrix<N> inverse(const Matrix<N>& m) noexcept {
  static_assert(N <= 2);
  Matrix<N> result{};
  if constexpr (N == 1) result[0][0] = 1.0 / m[0][0];
  if constexpr (N == 2) {
    const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    result[0] = {m[1][1] / determinant, -m[0][1] / determinant};
    result[1] = {-m[1][0] / determinant, m[0][0] / determinant};
  }
  return result;
}

/// That B_jj^2 = h_j^2 for the levels of a star's coordinates, over a box.
template <class Chart, std::size_t Levels>
class LevelRelations {
 public:
  using Coordinates = StarCoordinates<Chart, Levels>;
  using Form = typename Coordinates::Form;
  using Forms = std::array<Form, Levels>;

  /// `squares`: B_jj^2 by the pose coordinates.
  LevelRelations(const Coordinates& coordinates, const Forms& squares)
      : coordinates_(coordinates), squares_(squares) {
    Matrix<Levels> slopes{};
    for (std::size_t level = 0; level < Levels; ++level)
      for (std::size_t m = 0; m < Levels; ++m)
        slopes[level][m] = squares[level].slope(coordinates.replaced[m]);
    inverse_ = inverse(slopes);
  }

  /// Whether heights determine the replaced coordinates, in double precision.
  bool are_solved() const noexcept {
    for (const auto& row : inverse_)
      for (const double each : row)
        if (!std::isfinite(each)) return false;
    return true;
  }

  const Form& square_of(std::size_t level) const noexcept { return squares_[level]; }

  /// What a change of B_jj^2 of level m changes a replaced coordinate by.
  double inverse_slope(std::size_t level, std::size_t m) const noexcept { return inverse_[level][m]; }

  /// The same function where the relations hold: multiples of these are added, so that what is linear in the
  /// replaced coordinates goes away.
  Form without_replaced(Form function) const {
    std::array<double, Levels> slopes;
    for (std::size_t level = 0; level < Levels; ++level)
      slopes[level] = function.slope(coordinates_.replaced[level]);
    for (std::size_t m = 0; m < Levels; ++m) {
      double factor = 0.0;
      for (std::size_t level = 0; level < Levels; ++level) factor += slopes[level] * inverse_[level][m];
      function += Interval(factor) * (square(coordinates_.height(m)) - squares_[m]);
    }
    return function;
  }

 private:
  Coordinates coordinates_;
  Forms squares_;
  Matrix<Levels> inverse_{};
};

/// Legs that are not clear, but for `levels`.
template <class Entries>
LegSet unclear_but(LegSet levels, const Entries& entries, std::size_t leg_count) noexcept {
  LegSet result = 0;
  for (std::size_t j = 0; j < leg_count; ++j)
    if (!entries.clear(j)) result |= BoxFacts::bit(j);
  return static_cast<LegSet>(result & ~levels);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_COORDINATES_H
