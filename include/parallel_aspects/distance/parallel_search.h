// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_PARALLEL_SEARCH_H
#define PARALLEL_ASPECTS_DISTANCE_PARALLEL_SEARCH_H

#include "parallel_aspects/distance/cell.h"
#include "parallel_aspects/distance/mode_determinant.h"
#include "parallel_aspects/distance/search_result.h"
#include "parallel_aspects/distance/witness_search.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {

/// The pose nearest to the origin of a neighbourhood where every leg reaches and det A = 0, by branch and
/// bound: cells are halved, the nearest first, until det A is proved to have one sign in them, or no leg to
/// reach, as far as they are within (1 - tolerance) times the distance of the best witness.
template <TaskSpace space>
class ParallelSearch {
 public:
  static constexpr std::size_t size = Neighbourhood<space>::size;
  using Result = SearchResult<size>;

  ParallelSearch(const Neighbourhood<space>& hood, const DistanceOptions& options)
      : hood_(hood), options_(options) {
    queue_.reserve(static_cast<std::size_t>(options.most_boxes) + 2);
  }

  /// Needs a live `RoundingUpward`; so does all of this class. Every leg must be proved to reach at the
  /// origin.
  Result run(const ModeDeterminant<space>& determinant, const SearchRange& range) noexcept {
    determinant_ = &determinant;
    const std::array<Interval, size> origin{};
    sign_ = determinant.proved_sign(origin);
    if (sign_ == 0) return Result::touching();
    result_ = Result();
    attempts_ = 0;
    look_for_witness(Coordinates<size>{});
    range_ = range;
    start();
    while (!queue_.empty() && queue_.first().bound < target() && result_.boxes < options_.most_boxes)
      examine(queue_.pop());
    finish();
    return result_;
  }

 private:
  static constexpr int most_attempts = 24;

  double target() const noexcept {
    return result_.has_witness() ? std::min(range_.radius, (1.0 - options_.tolerance) * result_.upper)
                                 : range_.radius;
  }

  void start() noexcept {
    queue_.clear();
    Cell<size> all;
    const double turn = hood_.metric().widest_turn;
    for (std::size_t i = 0; i < size; ++i)
      all.half_width[i] = i < Neighbourhood<space>::moves ? target() : std::min(target(), turn);
    queue_.push(all);
  }

  void examine(const Cell<size>& cell) noexcept {
    ++result_.boxes;
    if (hood_.is_beyond_half_turn(cell)) return;
    const auto value = determinant_->over(cell, target());
    if (!value) return;
    const Interval range = range_in_ball(*value, cell, target());
    if (sign_ > 0 ? range.positive() : range.negative()) return;
    if (sign_ < 0 ? range.positive() : range.negative()) {
      // Beyond a singularity: between here and the origin there is a witness, unless legs do not reach there.
      if (attempts_ < most_attempts) look_for_witness(cell.center);
      return;
    }
    look_where_expected(LinearModel<size>(*value, cell), cell);
    for (Cell<size> half : cell.halves(cell.widest())) {
      half.bound = std::max(cell.bound, half.least_length());
      queue_.push(half);
    }
  }

  // Where det A is expected to vanish in the cell, nearer than all witnesses.
  void look_where_expected(const LinearModel<size>& model, const Cell<size>& cell) noexcept {
    const double squared = model.gradient_length * model.gradient_length;
    if (!(squared > 0.0) || attempts_ >= most_attempts) return;
    const double factor = -0.5 * (model.below_at_origin + model.above_at_origin) / squared;
    Coordinates<size> y;
    for (std::size_t i = 0; i < size; ++i) {
      y[i] = factor * model.gradient[i];
      if (std::abs(y[i] - cell.center[i]) > 1.2 * cell.half_width[i]) return;
    }
    if (length<size>(y) < 0.98 * result_.upper) look_for_witness(y);
  }

  void look_for_witness(Coordinates<size> y) noexcept {
    ++attempts_;
    const auto function = [this](const Coordinates<size>& at) { return determinant_->at(at); };
    const auto at = WitnessSearch<size, decltype(function)>(function).run(y);
    if (!at || hood_.is_about_half_turn(y) || !(length<size>(y) < result_.upper)) return;
    const double distance = length<size>(y), slope = length<size>(at->gradient);
    Coordinates<size> normal = at->gradient;
    for (double& each : normal) each /= slope;
    for (double offset = 1e-13; offset < 1e-5; offset *= 10.0) {
      const Coordinates<size> before = moved<size>(y, -offset * distance, normal),
                              after = moved<size>(y, offset * distance, normal);
      const int one = determinant_->proved_sign(point(before)),
                other = determinant_->proved_sign(point(after));
      if (one * other >= 0 || !determinant_->is_reached(hull<size>(before, after))) continue;
      result_.offer(y, std::max(length<size>(before), length<size>(after)), true);
      return;
    }
    result_.offer(y, distance, false);
  }

  static std::array<Interval, size> point(const Coordinates<size>& y) noexcept { return hull<size>(y, y); }

  void finish() noexcept {
    const bool done = queue_.empty() || queue_.first().bound >= target();
    result_.lower = done ? target() : std::min(target(), queue_.first().bound);
    if (done && !result_.has_witness() && range_.holds_all) {
      const int boxes = result_.boxes;
      result_ = Result::absent();
      result_.boxes = boxes;
      return;
    }
    result_.status = !result_.has_witness() ? DistanceStatus::no_witness
                     : result_.lower >= (1.0 - options_.tolerance) * result_.upper ? DistanceStatus::tight
                                                                                   : DistanceStatus::loose;
  }

  const Neighbourhood<space>& hood_;
  const DistanceOptions options_;
  CellQueue<size> queue_;
  const ModeDeterminant<space>* determinant_ = nullptr;
  int sign_ = 0;
  int attempts_ = 0;
  SearchRange range_;
  Result result_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_PARALLEL_SEARCH_H
