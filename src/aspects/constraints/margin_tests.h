// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_MARGIN_TESTS_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_MARGIN_TESTS_H

#include "interval/interval.h"
#include "interval/scalar_range.h"
#include "legs/limit_verdict.h"
#include "legs/link_points.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/singularity/indices.h"

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace parallel_aspects {

/// What the margins of a manipulator ask of enclosed configurations (see Margins, and `parallel_index` for
/// the index), with its constants enclosed in intervals. Must be made under a live `RoundingUpward`.
///
/// The legs of a working mode with these `signs` are on one kind of enclosures, as `Legs`:
///  - row(j, sign) of A, and determinant(signs) of these rows, which may be longer than those of A;
///  - scale(j): how much longer; squared_rod(j): of what is u in a row, where the platform does not turn, and
///  in R1;
///  - turned(direction): of what is fixed in the platform.
///
/// Everything is compared by squares: a root would have no slope at a singularity.
template <std::size_t D>
class MarginTests {
 public:
  explicit MarginTests(const Manipulator& manipulator);

  bool any() const noexcept { return any_; }
  bool has_parallel() const noexcept { return squared_index_ || squared_determinant_; }

  /// Whether the serial index of a leg with this B_jj^2 is at least its margin.
  Verdict serial(std::size_t j, const Interval& squared_b_entry) const {
    return least_squares_[j] ? is_positive(squared_b_entry - *least_squares_[j]) : Verdict::holds;
  }

  /// Calls `action` with the function of `serial`, which is positive where that holds.
  template <class Scalar, class Action>
  void for_each_serial_function(std::size_t j, const Scalar& squared_b_entry, const Action& action) const {
    if (least_squares_[j]) action(squared_b_entry - Scalar(*least_squares_[j]));
  }

  /// Whether det A keeps its margins, where its square is in `squared_determinant`.
  template <class Legs, class Signs>
  Verdict parallel(const Interval& squared_determinant, const Legs& legs, const Signs& signs) const {
    Verdict result = Verdict::holds;
    for_each_parallel_function(squared_determinant, legs, signs, [&result](const auto& value) {
      result = both(result, is_positive(range_of(value)));
    });
    return result;
  }

  /// Calls `action` with functions that are positive where det A, whose square is given, keeps its margins.
  template <class Square, class Legs, class Signs, class Action>
  void for_each_parallel_function(const Square& squared_determinant, const Legs& legs, const Signs& signs,
                                  const Action& action) const {
    if (squared_index_)
      action(squared_determinant - *squared_index_ * enclosed<Square>(squared_norms(legs, signs)));
    if (squared_determinant_)
      action(squared_determinant - *squared_determinant_ * enclosed<Square>(squared_scales(legs)));
  }

  /// The square of what det A of these rows is divided by to give the parallel index.
  template <class Legs, class Signs>
  auto squared_norms(const Legs& legs, const Signs& signs) const {
    const auto middle = legs.turned(middle_);
    auto product = unit_ * squared_norm(legs, middle, 0, signs);
    for (std::size_t j = 1; j < leg_count_; ++j) product = product * squared_norm(legs, middle, j, signs);
    return product;
  }

  /// The square of what det A of these rows is divided by to give this index.
  template <class Legs, class Signs>
  auto index_squares(ParallelIndex kind, const Legs& legs, const Signs& signs) const {
    return kind == ParallelIndex::normalised ? squared_norms(legs, signs) : squared_scales(legs);
  }

  /// The square of what det A of these rows is divided by to give det A itself.
  template <class Legs>
  auto squared_scales(const Legs& legs) const {
    auto product = square(legs.scale(0));
    for (std::size_t j = 1; j < leg_count_; ++j) product = product * square(legs.scale(j));
    return product;
  }

 private:
  void set_middle(const std::vector<std::array<Interval, 3>>& anchors);

  /// Products over intervals serve where squares of det A are intervals.
  template <class Square, class Value>
  static Square enclosed(const Value& value) {
    if constexpr (std::is_same_v<Square, Value>)
      return value;
    else
      return Square(range_of(value));
  }

  /// Of a row with its moments about the middle of the anchors, over their distance from it. In R1 the rod
  /// stands for the row: its moment is at most its length times that of the arm, which is in `unit_`.
  template <class Legs, class Middle, class Signs>
  auto squared_norm(const Legs& legs, const Middle& middle, std::size_t j, const Signs& signs) const {
    if (rotations_ == 0 || leg_count_ == 1) return legs.squared_rod(j);
    const auto& row = legs.row(j, signs[j]);
    auto moments = square(moment(row, middle, 0));
    for (std::size_t i = 1; i < rotations_; ++i) moments = moments + square(moment(row, middle, i));
    moments = over_squared_distance_ * moments;
    for (std::size_t i = rotations_; i < leg_count_; ++i) moments = moments + square(row[i]);
    return moments;
  }

  /// A moment (b - middle) x u, from that about the operational point and u.
  template <class Row, class Middle>
  auto moment(const Row& row, const Middle& middle, std::size_t i) const {
    if (leg_count_ == rotations_) return row[i];
    const std::size_t u = rotations_, y = rotations_ == 1 ? 0 : (i + 1) % 3,
                      z = rotations_ == 1 ? 1 : (i + 2) % 3;
    return row[i] - (middle[y] * row[u + z] - middle[z] * row[u + y]);
  }

  bool any_ = false;
  std::size_t leg_count_, rotations_;
  Point<Interval, D> middle_;              // of the anchors, seen from the operational point
  Interval over_squared_distance_;         // 1 / mean of the squares of their distances from it
  Interval unit_;                          // of the square of det A, where moments are over that distance
  std::optional<Interval> squared_index_;  // least one
  std::optional<Interval> squared_determinant_;
  std::vector<std::optional<Interval>> least_squares_;  // of B_jj, by leg
};

extern template class MarginTests<2>;
extern template class MarginTests<3>;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_MARGIN_TESTS_H
