// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_PARALLEL_SEARCH_H
#define PARALLEL_ASPECTS_DISTANCE_PARALLEL_SEARCH_H

#include "distance/cell.h"
#include "distance/map_search.h"
#include "distance/mode_determinant.h"
#include "distance/search_result.h"
#include "distance/witness_search.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace parallel_aspects {

/// The pose nearest to the origin of a local_chart where every leg reaches and det A = 0, by branch and
/// bound: cells are halved, the nearest first, until det A is proved to have one sign in them, or no leg to
/// reach, as far as they are within (1 - tolerance) times the distance of the best witness.
template <TaskSpace space>
class ParallelSearch {
 public:
  static constexpr std::size_t size = LocalChart<space>::size;
  using Result = SearchResult<size>;

  ParallelSearch(const LocalChart<space>& chart, MapSearch<space>& map, const DistanceOptions& options)
      : chart_(chart), map_(map), options_(options) {
    queue_.reserve(2 * static_cast<std::size_t>(options.max_boxes) + 2);
  }

  /// Needs a live `RoundingUpward`; so does all of this class. Every leg must be proved to reach at the
  /// origin.
  Result run(ModeDeterminant<space>& determinant, const SearchRange& range) noexcept {
    assert_rounding_upward();
    determinant_ = &determinant;
    const std::array<Interval, size> origin{};
    sign_ = determinant.proved_sign(origin);
    if (sign_ == 0) return Result::touching();
    result_ = Result();
    attempts_ = corner_attempts_ = 0;
    range_ = range;
    look_for_witness(Coordinates<size>{});
    if (size > 3) look_about();
    determinant.point_cells_to(map_.knows() ? Coordinates<size>{} : result_.witness);
    if constexpr (size > 3) prove_ball();
    start();
    while (bound() < target() && result_.boxes < max_boxes() && !map_.is_exhausted() && !is_good_enough())
      proceed();
    finish();
    return result_;
  }

 private:
  // Searches for witnesses from boxes: these, and one more for so many boxes. Where the first ones lead
  // elsewhere, boxes come near the nearest zero all the same.
  static constexpr int first_attempts = 12, boxes_an_attempt = 32;

  // With a map so many boxes are evaluated for the tolerance, and the others for so many tolerances only.
  static constexpr int few_boxes = 20, coarser = 5;

  // In six degrees of freedom a box takes about as long as `box_cost` of a search over legs, and
  // a ball as long as `ball_cost` boxes. The first ball is smaller than the distance of the witness, since a
  // proof right up to a zero fails; where one reaches `near_enough` of what is not refuted, another could
  // gain 3 % at most, which boxes do as well.
  static constexpr int box_cost = 32, balls = 4, ball_cost = 2, least_boxes = 5;
  static constexpr double first_ball = 0.9, near_enough = 0.97;

  int max_boxes() const noexcept {
    return size > 3 ? std::max(least_boxes, options_.max_boxes / box_cost) : options_.max_boxes;
  }

  int max_attempts() const noexcept { return first_attempts + result_.boxes / boxes_an_attempt; }

  double target() const noexcept {
    return result_.has_witness() ? std::min(range_.radius, (1.0 - options_.tolerance) * result_.upper)
                                 : range_.radius;
  }

  // From symmetric poses the first steps may end at a saddle; turns to either side leave it.
  void look_about() noexcept {
    const double away = std::min(0.1 * range_.radius, 0.5 * result_.upper);
    for (std::size_t i = LocalChart<space>::moves; i < size; ++i)
      for (const double sense : {-1.0, 1.0}) {
        Coordinates<size> y{};
        y[i] = sense * away;
        look_for_witness(y);
      }
    attempts_ = 0;
  }

  // Enclosures over larger balls are looser, those over smaller ones prove less.
  void prove_ball() noexcept {
    proved_radius_ = 0.0;
    double untried = target(), radius = first_ball * untried;
    for (int i = 0; i < std::min(balls, max_boxes() / ball_cost); ++i) {
      if (proved_radius_ > near_enough * untried) return;
      result_.boxes += ball_cost;
      const auto found = determinant_->regular_radius(radius);
      if (found.proved < radius) untried = radius;
      proved_radius_ = std::max(proved_radius_, found.proved);
      const double gap = untried - proved_radius_;
      radius = std::max(proved_radius_ + 0.15 * gap, std::min(found.expected, untried - 0.15 * gap));
    }
  }

  void start() noexcept {
    queue_.clear();
    Cell<size> all;
    for (std::size_t i = 0; i < size; ++i) all.half_width[i] = target();
    if (map_.knows()) {
      map_.start(target());
      all.bound = map_.distance_beyond();
      all.tag = MapSearch<space>::beyond_map;
    }
    all_ = all;
    if (all.bound < target()) queue_.push(all);
  }

  // With a map bounds come near at once, and nearer slowly.
  bool is_good_enough() const noexcept {
    return map_.knows() && result_.boxes >= few_boxes &&
           bound() >= (1.0 - coarser * options_.tolerance) * result_.upper;
  }

  // Proved: no singularity is closer.
  double bound() const noexcept {
    return std::min(map_.bound(),
                    queue_.empty() ? std::numeric_limits<double>::infinity() : queue_.first().bound);
  }

  void proceed() noexcept {
    if (map_.knows() && map_.bound() <= bound()) {
      if (const auto cell = map_.next(target(), all_)) examine(*cell);
    } else {
      examine(queue_.pop());
    }
  }

  // Left out are cells in which no pose that is nearer than the target is singular and reached: det A is
  // proved to have one sign there, or a leg not to reach; or the map has all of the cell, whose leaves are
  // examined.
  void examine(const Cell<size>& cell) noexcept {
    if (cell.tag == MapSearch<space>::beyond_map && map_.has(determinant_->reflected(cell.box()))) return;
    ++result_.boxes;
    if (LocalChart<space>::turns > 0 && chart_.is_beyond_half_turn(determinant_->reflected(cell.box())))
      return;
    if (!determinant_->over(cell, target(), over_)) return;
    const Affine<size> value = sign_ > 0 ? over_.determinant : -over_.determinant;
    const Interval range = range_in_ball(value, cell, target());
    if (range.lower() > 0.0 || over_.is_positive_where_reached(value, cell, target())) return;
    if (range.upper() < 0.0) {
      // Beyond a singularity: between here and the origin there is a witness, unless legs do not reach there.
      if (attempts_ < max_attempts()) look_for_witness(determinant_->reflected_point(cell.center));
      return;
    }
    if (over_.is_free_by_norm(cell, target())) return;
    const LinearModel<size> model(value, cell);
    look_where_expected(model, cell);
    if (over_.any_unclear) look_at_corner(cell);
    double bound = std::max(cell.bound, model.least_distance_of_zero());
    if (over_.has_norm) bound = std::max(bound, LinearModel<size>(over_.norm, cell).least_distance_of_zero());
    push_halves(cell, bound);
  }

  void push_halves(const Cell<size>& cell, double bound) noexcept {
    for (Cell<size> half : cell.halves(cell.widest())) {
      half.bound = std::max(bound, half.least_length());
      if (half.bound < target()) queue_.push(half);
    }
  }

  // Where det A is expected to vanish in the cell, nearer than all witnesses.
  void look_where_expected(const LinearModel<size>& model, const Cell<size>& cell) noexcept {
    const double squared = model.gradient_length * model.gradient_length;
    if (!(squared > 0.0) || attempts_ >= max_attempts()) return;
    const double factor = -0.5 * (model.below_at_origin + model.above_at_origin) / squared;
    Coordinates<size> y;
    for (std::size_t i = 0; i < size; ++i) {
      y[i] = factor * model.gradient[i];
      if (std::abs(y[i] - cell.center[i]) > 1.2 * cell.half_width[i]) return;
    }
    if (length<size>(y) < 0.98 * result_.upper) look_for_witness(determinant_->reflected_point(y));
  }

  void look_for_witness(Coordinates<size> y) noexcept {
    ++attempts_;
    const auto function = [this](const Coordinates<size>& at) { return determinant_->at(at); };
    const auto at = WitnessSearch<size, decltype(function)>(function).run(y);
    if (at) look_for_witness_at(y, *at);
  }

  // Takes y where det A vanishes there.
  void look_for_witness_at(const Coordinates<size>& y, const PointDual<size>& at) noexcept {
    if (chart_.is_about_half_turn(y) || !(length<size>(y) < result_.upper)) return;
    const double distance = length<size>(y), slope = length<size>(at.gradient);
    if (!(std::abs(at.value) <= 1e-6 * slope * distance)) return;
    Coordinates<size> normal = at.gradient;
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

  // Surfaces det A = 0 may end where a leg just reaches. There det A has no slope, and steps go by det A at a
  // small constant |B_jj| and by B_jj^2 itself.
  void look_at_corner(const Cell<size>& cell) noexcept {
    if (corner_attempts_ >= max_attempts() || !(cell.least_length() < 0.98 * result_.upper)) return;
    std::size_t held = 0;
    for (const bool unclear : over_.unclear) held += unclear ? 1 : 0;
    if (held + 1 > size) return;
    ++corner_attempts_;
    Coordinates<size> y = determinant_->reflected_point(cell.center);
    if (!walk_to_corner(over_.unclear, y)) return;
    const auto function = [this](const Coordinates<size>& at) { return determinant_->at(at); };
    const auto at = WitnessSearch<size, decltype(function)>(function).polished(y);
    if (at) look_for_witness_at(y, *at);
  }

  bool walk_to_corner(const std::array<bool, size>& held, Coordinates<size>& y) const noexcept {
    constexpr double small = 1e-8;  // |B_jj|^2 is left at this times its slope times |y|
    Coordinates<size> entries{};
    for (int step = 0; step < 12; ++step) {
      std::array<PointDual<size>, size> squared, conditions;
      conditions[0] = determinant_->at(y, held, entries, squared);
      std::size_t count = 1;
      for (std::size_t j = 0; j < size; ++j) {
        if (!held[j]) continue;
        const double left = small * length<size>(squared[j].gradient) * length<size>(y);
        entries[j] = std::sqrt(left);
        conditions[count++] = squared[j] - PointDual<size>(left);
      }
      const Coordinates<size> next = nearest_common_zero(conditions, count, y);
      const double change = length<size>(moved<size>(next, -1.0, y));
      y = next;
      if (!std::isfinite(change) || change > 1e3 * range_.radius) return false;
      if (change < 1e-12 * length<size>(y)) break;
    }
    return length<size>(y) < result_.upper && determinant_->at(y).has_value();
  }

  // Of the linear functions that touch these at y, by modified Gram and Schmidt.
  static Coordinates<size> nearest_common_zero(std::array<PointDual<size>, size>& conditions,
                                               std::size_t count, const Coordinates<size>& y) noexcept {
    Coordinates<size> result{};
    for (std::size_t k = 0; k < count; ++k) {
      Coordinates<size>& normal = conditions[k].gradient;
      double right = dot<size>(normal, y) - conditions[k].value;
      right -= dot<size>(normal, result);
      for (std::size_t i = 0; i < k; ++i)
        normal = moved<size>(normal, -dot<size>(normal, conditions[i].gradient), conditions[i].gradient);
      const double slope = length<size>(normal);
      for (double& each : normal) each /= slope;
      result = moved<size>(result, right / slope, normal);
    }
    return result;
  }

  static std::array<Interval, size> point(const Coordinates<size>& y) noexcept { return hull<size>(y, y); }

  void finish() noexcept {
    const bool done = bound() >= target();
    result_.lower = done ? target() : std::min(target(), std::max(proved_radius_, bound()));
    if (done && !result_.has_witness() && range_.holds_all) {
      const int boxes = result_.boxes;
      result_ = Result::absent();
      result_.boxes = boxes;
      return;
    }
    result_.status = !result_.has_witness() ? DistanceStatus::no_witness
                     : result_.lower >= (1.0 - options_.tolerance) * result_.upper ? DistanceStatus::tight
                                                                                   : DistanceStatus::loose;
    result_.lower = -((determinant_->reflection_error() - 1.0) * result_.lower);
  }

  const LocalChart<space>& chart_;
  MapSearch<space>& map_;
  const DistanceOptions options_;
  CellQueue<size> queue_;
  const ModeDeterminant<space>* determinant_ = nullptr;
  int sign_ = 0;
  double proved_radius_ = 0.0;
  int attempts_ = 0, corner_attempts_ = 0;
  Cell<size> all_;
  typename ModeDeterminant<space>::OverCell over_;
  SearchRange range_;
  Result result_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_PARALLEL_SEARCH_H
