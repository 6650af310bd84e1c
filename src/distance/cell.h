// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_CELL_H
#define PARALLEL_ASPECTS_DISTANCE_CELL_H

#include "distance/point_dual.h"
#include "interval/affine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// A box of coordinates, and a proved lower bound of what is searched for in it. Everything of this file that
/// bounds needs a live `RoundingUpward`.
template <std::size_t N>
struct Cell {
  Coordinates<N> center{}, half_width{};
  double bound = 0.0;   ///< cells of the least are examined first
  std::size_t tag = 0;  ///< for the search that owns it

  std::array<Interval, N> box() const noexcept {
    std::array<Interval, N> result;
    for (std::size_t i = 0; i < N; ++i)
      result[i] = Interval(-(half_width[i] - center[i]), center[i] + half_width[i]);
    return result;
  }

  /// Its coordinates as linear or quadratic forms.
  template <class Form>
  std::array<Form, N> forms() const noexcept {
    std::array<Form, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = Form::coordinate(center[i], half_width[i], i);
    return result;
  }

  /// No point of the cell is closer to the origin.
  double least_length() const noexcept {
    double negated_square = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      const double negated_gap = std::min(0.0, half_width[i] - std::abs(center[i]));
      negated_square += negated_gap * -negated_gap;
    }
    return lower_root_of_negated(negated_square);
  }

  /// The halves along coordinate i; they overlap by a rounding error at most.
  std::array<Cell, 2> halves(std::size_t i) const noexcept {
    std::array<Cell, 2> result{*this, *this};
    // Rounded upward: center - half and center + half stay inside both.
    const double half = 0.5 * half_width[i], rounding = 0x1p-51 * (std::abs(center[i]) + half_width[i]);
    result[0].half_width[i] = result[1].half_width[i] = half + rounding;
    result[0].center[i] -= half;
    result[1].center[i] += half;
    return result;
  }

  std::size_t widest() const noexcept {
    return static_cast<std::size_t>(std::max_element(half_width.begin(), half_width.end()) -
                                    half_width.begin());
  }
};

/// A linear function `at_origin` + gradient . y, within `error` of what it stands for.
template <std::size_t N>
struct LinearModel {
  double below_at_origin = 0.0;  ///< proved: the value is at least below_at_origin + gradient . y - error
  double above_at_origin = 0.0;
  Coordinates<N> gradient{};
  double gradient_length = 0.0;  ///< rounded up
  double error = 0.0;

  LinearModel(const Affine<N>& f, const Cell<N>& cell) noexcept : error(f.error()) {
    double negated = -f.center(), above = f.center(), squares = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      const double slope = f.slope(i), width = cell.half_width[i];
      negated += slope * cell.center[i] / width;
      above += -slope * cell.center[i] / width;
      gradient[i] = slope / width;
      const double size = std::abs(slope) / width;
      squares += size * size;
    }
    below_at_origin = -negated;
    above_at_origin = above;
    gradient_length = std::sqrt(squares);
  }

  /// Proved: no zero in the cell is closer to the origin.
  double least_distance_of_zero() const noexcept {
    const double above_zero = std::max(-(error - below_at_origin), -(above_at_origin + error));
    return above_zero > 0.0 && gradient_length > 0.0 ? above_zero / gradient_length * (1.0 - 0x1p-50) : 0.0;
  }

  /// Encloses the values in the ball |y| <= radius, as far as it is in the cell.
  Interval in_ball(double radius) const noexcept {
    const double spread = gradient_length * radius + error;
    return {-(spread - below_at_origin), above_at_origin + spread};
  }
};

/// Encloses f over the part of the cell with |y| <= radius.
template <std::size_t N>
Interval range_in_ball(const Affine<N>& f, const Cell<N>& cell, double radius) noexcept {
  const Interval in_cell = f.range();
  if (in_cell.positive() || in_cell.negative()) return in_cell;
  return intersection(in_cell, LinearModel<N>(f, cell).in_ball(radius));
}

/// Cells by rising bound. Its memory is taken by `reserve`; `push` beyond that fails.
template <std::size_t N>
class CellQueue {
 public:
  void reserve(std::size_t capacity) { cells_.reserve(capacity); }
  void clear() noexcept { cells_.clear(); }
  bool empty() const noexcept { return cells_.empty(); }
  const Cell<N>& first() const noexcept { return cells_.front(); }

  bool push(const Cell<N>& cell) noexcept {
    if (cells_.size() == cells_.capacity()) return false;
    cells_.push_back(cell);
    std::push_heap(cells_.begin(), cells_.end(), later);
    return true;
  }

  Cell<N> pop() noexcept {
    std::pop_heap(cells_.begin(), cells_.end(), later);
    const Cell<N> cell = cells_.back();
    cells_.pop_back();
    return cell;
  }

 private:
  static bool later(const Cell<N>& a, const Cell<N>& b) noexcept { return a.bound > b.bound; }

  std::vector<Cell<N>> cells_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_CELL_H
