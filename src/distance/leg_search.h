// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_LEG_SEARCH_H
#define PARALLEL_ASPECTS_DISTANCE_LEG_SEARCH_H

#include "distance/cell.h"
#include "distance/leg_boundary.h"
#include "distance/mode_determinant.h"
#include "distance/quadratic_form.h"
#include "distance/search_result.h"
#include "distance/witness_search.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace parallel_aspects {

/// The pose nearest to the origin of a local_chart where some leg is at a boundary.
///
/// The boundary is a surface for the anchor, whose distance is a closed form. Where the platform does not
/// turn, that is the answer. Where it turns and moves, the nearest pose with the rotation r is the
/// displacement to the surface, so that D^2 = distance(r)^2 + |r|^2 is left to be minimised over rotations
/// alone, by branch and bound over cells of rotations. In SO3 and T1 cells are searched for a distance of
/// zero.
template <TaskSpace space>
class LegSearch {
 public:
  using Chart = LocalChart<space>;
  static constexpr std::size_t size = Chart::size, dimension = Chart::dimension, moves = Chart::moves;
  using Result = SearchResult<size>;
  using Boundary = LegBoundary<dimension>;

  LegSearch(const Chart& chart, const DistanceOptions& options) : chart_(chart), options_(options) {
    queue_.reserve(2 * static_cast<std::size_t>(options.max_boxes) + 4 * max_legs + 2);
  }

  /// Of limits a witness counts only where every leg reaches; of serial singularities the nearest of all legs
  /// always does. Needs a live `RoundingUpward`.
  Result run(const std::vector<Boundary>& boundaries, bool limits, const WorkingMode& mode,
             const ModeDeterminant<space>& determinant, const SearchRange& range) noexcept {
    assert_rounding_upward();
    boundaries_ = &boundaries;
    limits_ = limits;
    mode_ = &mode;
    determinant_ = &determinant;
    range_ = range;
    result_ = Result();
    attempts_ = 0;
    nearest_ = std::numeric_limits<double>::infinity();
    queue_.clear();
    bool any = false;
    for (std::size_t i = 0; i < boundaries.size(); ++i) {
      if (!is_of_mode(boundaries[i])) continue;
      any = true;
      if (touches(boundaries[i])) return of_leg(Result::touching(), boundaries[i]);
      if constexpr (searched == 0)
        measure_directly(boundaries[i]);
      else
        look_for_witness(boundaries[i], Coordinates<size>{});
    }
    if (!any) return Result::absent();
    if constexpr (searched > 0) search();
    finish();
    return result_;
  }

 private:
  // Coordinates that are searched; the others are a displacement in every direction, or none.
  static constexpr bool moves_freely = moves == dimension;
  static constexpr std::size_t searched = moves_freely ? Chart::turns : size;
  static constexpr std::size_t first_searched = moves_freely ? moves : 0;
  static constexpr int max_attempts = 24;
  using SearchedCell = Cell<searched>;
  using Form = QuadraticForm<searched>;

  bool is_of_mode(const Boundary& boundary) const noexcept {
    return boundary.branch == 0 || boundary.branch == mode_->sign(boundary.leg);
  }

  static Result of_leg(Result result, const Boundary& boundary) noexcept {
    result.leg = boundary.leg;
    result.end = boundary.end;
    return result;
  }

  double target() const noexcept {
    return result_.has_witness() ? std::min(range_.radius, (1.0 - options_.tolerance) * result_.upper)
                                 : range_.radius;
  }

  // The side of a sided boundary as the working mode sees it: positive where B_jj has its sign.
  template <class Scalar>
  Scalar side(const Boundary& boundary, const std::array<Scalar, dimension>& d) const noexcept {
    return Interval(static_cast<double>(mode_->sign(boundary.leg))) * boundary.side(d);
  }

  static double least_magnitude(const Interval& a) noexcept { return std::max({0.0, a.lower(), -a.upper()}); }

  bool touches(const Boundary& boundary) const noexcept {
    const auto& d = chart_.displacement_at_origin(boundary.leg);
    if (least_magnitude(boundary.signed_distance(d)) > 0.0) return false;
    return !boundary.sided || !side(boundary, d).negative();
  }

  void measure_directly(const Boundary& boundary) noexcept {
    const auto& d = chart_.displacement_at_origin(boundary.leg);
    Interval distance = boundary.signed_distance(d);
    bool rim = false;
    if (boundary.sided) {
      const Interval at = side(boundary, d);
      rim = at.negative();
      if (rim) distance = boundary.rim_distance(d);
    }
    nearest_ = std::min(nearest_, least_magnitude(distance));
    const double farthest = std::max(-distance.lower(), distance.upper());
    if (farthest < result_.upper) offer_nearest_point(boundary, rim, farthest);
  }

  // The distance from a surface falls with unit slope towards its nearest point.
  void offer_nearest_point(const Boundary& boundary, bool rim, double distance) noexcept {
    std::array<PointDual<size>, size> point;
    for (std::size_t i = 0; i < size; ++i) point[i] = PointDual<size>::coordinate(0.0, i);
    const auto d = chart_.displacement(boundary.leg, std::array<PointDual<size>, dimension>{}, point);
    const PointDual<size> value = rim ? boundary.rim_distance(d) : boundary.signed_distance(d);
    Coordinates<size> y;
    for (std::size_t i = 0; i < size; ++i) y[i] = -value.value * value.gradient[i];
    bool proved = true;
    if (limits_ && !is_reached_about(y, 1e-9 * (1.0 + distance), proved)) return;
    if (result_.offer(y, distance, proved)) result_ = of_leg(result_, boundary);
  }

  // Whether every leg reaches in floating point, and where that is proved.
  bool is_reached_about(const Coordinates<size>& y, double margin, bool& proved) const noexcept {
    std::array<Interval, size> box;
    for (std::size_t i = 0; i < size; ++i) box[i] = Interval(-(margin - y[i]), y[i] + margin);
    proved = determinant_->is_reached(box);
    return proved || determinant_->at(y).has_value();
  }

  // ---- Cells of rotations (of x in T1) ----

  template <class Scalar>
  std::array<Scalar, dimension> displacement(std::size_t leg,
                                             const std::array<Scalar, size>& y) const noexcept {
    std::array<Scalar, dimension> arm{};
    if constexpr (Chart::turns > 0) arm = chart_.arm(leg, chart_.rotation(y.data() + moves));
    return chart_.displacement(leg, arm, y);
  }

  std::array<Form, dimension> displacement(std::size_t leg, const SearchedCell& cell) const noexcept {
    const std::array<Form, searched> forms = cell.template forms<Form>();
    if constexpr (!moves_freely) {
      return displacement<Form>(leg, forms);
    } else {
      return chart_.turned_displacement(leg, chart_.arm(leg, chart_.rotation(forms.data())));
    }
  }

  // No pose of the boundary is closer: an anchor moves by |c' - c| + turning |r| at most.
  double first_bound(const Boundary& boundary) const noexcept {
    const auto& d = chart_.displacement_at_origin(boundary.leg);
    double distance = least_magnitude(boundary.signed_distance(d));
    if (boundary.sided && side(boundary, d).negative())
      distance = std::max(distance, least_magnitude(boundary.rim_distance(d)));
    if constexpr (Chart::turns == 0) return distance;
    const Interval turning(chart_.turning(boundary.leg));
    const Interval squared = (moves_freely ? Interval(1.0) : Interval(0.0)) + square(turning);
    return (Interval(distance) * reciprocal(square_root(squared))).lower();
  }

  void search() noexcept {
    for (std::size_t i = 0; i < boundaries_->size(); ++i) {
      if (!is_of_mode((*boundaries_)[i])) continue;
      SearchedCell all;
      all.tag = i;
      const double turn = Chart::turns > 0 ? chart_.metric().widest_turn : target();
      all.half_width.fill(std::min(target(), turn));
      all.bound = first_bound((*boundaries_)[i]);
      queue_.push(all);
    }
    while (!queue_.empty() && queue_.first().bound < target() && result_.boxes < options_.max_boxes) {
      const SearchedCell cell = queue_.pop();
      look_at_center(cell);
      for (SearchedCell half : cell.halves(cell.widest())) bound_and_push(half);
    }
    nearest_ = queue_.empty() ? std::numeric_limits<double>::infinity() : queue_.first().bound;
  }

  // Left out are cells in which no pose of the boundary is nearer than the target.
  void bound_and_push(SearchedCell cell) noexcept {
    ++result_.boxes;
    const double least = cell.least_length(), radius = target();
    if (least >= radius || chart_.is_beyond_half_turn(cell.box())) return;
    const Boundary& boundary = (*boundaries_)[cell.tag];
    const auto d = displacement(boundary.leg, cell);
    double distance = 0.0;
    if (is_clear(boundary.signed_distance(d), cell, radius, distance)) return;
    if (boundary.sided && range_in_ball(side(boundary, d).linear(), cell, radius).negative() &&
        is_clear(boundary.rim_distance(d), cell, radius, distance))
      return;
    const double negated_square = -distance * distance + -least * least;
    cell.bound = std::max(cell.bound, moves_freely ? lower_root_of_negated(negated_square) : least);
    queue_.push(cell);
  }

  // Whether the surface is farther from the anchor than a displacement can be all over the cell; else
  // `distance` is raised to what is proved.
  bool is_clear(const Form& signed_distance, const SearchedCell& cell, double radius,
                double& distance) const noexcept {
    const Interval range = range_in_ball(signed_distance.linear(), cell, radius);
    distance = std::max(distance, least_magnitude(range));
    if constexpr (!moves_freely) return distance > 0.0;
    if (!(distance > 0.0)) return false;
    // sqrt(a) <= (a / t + t) / 2 for every t > 0; here a = radius^2 - |r|^2.
    double squared = 0.0;
    Form sum(0.0);
    const std::array<Form, searched> forms = cell.template forms<Form>();
    for (std::size_t i = 0; i < searched; ++i) {
      sum = sum + square(forms[i]);
      squared += cell.center[i] * cell.center[i];
    }
    const double t = std::max(std::sqrt(std::max(0.0, radius * radius - squared)), 0.05 * radius);
    const Interval half(0.5), factor = half * reciprocal(Interval(t));
    const Form farthest = factor * (Form(square(Interval(radius))) - sum) + Form(half * Interval(t));
    const Form gap = (range.positive() ? signed_distance : -signed_distance) - farthest;
    return range_in_ball(gap.linear(), cell, radius).positive();
  }

  void look_at_center(const SearchedCell& cell) noexcept {
    if (attempts_ >= max_attempts) return;
    const Boundary& boundary = (*boundaries_)[cell.tag];
    Coordinates<size> y{};
    for (std::size_t i = 0; i < searched; ++i) y[first_searched + i] = cell.center[i];
    const PointDual<size> signed_distance = signed_distance_at(boundary, y);
    double squared = signed_distance.value * signed_distance.value + dot<searched>(cell.center, cell.center);
    if constexpr (!moves_freely) squared = dot<searched>(cell.center, cell.center);
    if (!(squared < 0.98 * result_.upper * result_.upper)) return;
    move_to_surface(boundary, y);
    look_for_witness(boundary, y);
  }

  // With the rotation of y, takes the shortest displacement to the surface.
  void move_to_surface(const Boundary& boundary, Coordinates<size>& y) const noexcept {
    if constexpr (moves_freely) {
      std::fill_n(y.begin(), moves, 0.0);
      const PointDual<size> signed_distance = signed_distance_at(boundary, y);
      for (std::size_t i = 0; i < moves; ++i) y[i] = -signed_distance.value * signed_distance.gradient[i];
    }
  }

  PointDual<size> signed_distance_at(const Boundary& boundary, const Coordinates<size>& y) const noexcept {
    std::array<PointDual<size>, size> point;
    for (std::size_t i = 0; i < size; ++i) point[i] = PointDual<size>::coordinate(y[i], i);
    return boundary.signed_distance(displacement(boundary.leg, point));
  }

  Interval signed_distance_on(const Boundary& boundary,
                              const std::array<Interval, size>& box) const noexcept {
    return boundary.signed_distance(displacement(boundary.leg, box));
  }

  void look_for_witness(const Boundary& boundary, Coordinates<size> y) noexcept {
    ++attempts_;
    const auto function = [&](const Coordinates<size>& at) {
      return std::optional<PointDual<size>>(signed_distance_at(boundary, at));
    };
    const Coordinates<size> start = y;
    const auto at = WitnessSearch<size, decltype(function)>(function).run(y);
    if (!at && !moves_freely) return;
    if (!at) y = start;  // at the tip of a cone steps fail, but a displacement leads there
    move_to_surface(boundary, y);
    if (chart_.is_about_half_turn(y) || !(length<size>(y) < result_.upper)) return;
    bool proved = false;
    if (limits_ && !is_reached_about(y, 0.0, proved)) return;
    std::array<PointDual<size>, size> point;
    for (std::size_t i = 0; i < size; ++i) point[i] = PointDual<size>(y[i]);
    if (boundary.sided && !(side(boundary, displacement(boundary.leg, point)).value >= 0.0)) return;
    const double distance = proved_distance(boundary, y, at.value_or(PointDual<size>()));
    proved = distance > 0.0;
    if (result_.offer(y, proved ? distance : length<size>(y), proved)) result_ = of_leg(result_, boundary);
  }

  // Of a pose of the boundary that is proved to be near y; 0 where none is.
  double proved_distance(const Boundary& boundary, const Coordinates<size>& y,
                         const PointDual<size>& at) const noexcept {
    if constexpr (moves_freely) return proved_by_displacement(boundary, y);
    Coordinates<size> normal = at.gradient;
    const double slope = length<size>(normal), distance = length<size>(y);
    for (double& each : normal) each /= slope;
    for (double offset = 1e-13; offset < 1e-5; offset *= 10.0) {
      const Coordinates<size> before = moved<size>(y, -offset * distance, normal),
                              after = moved<size>(y, offset * distance, normal);
      const Interval one = signed_distance_on(boundary, hull<size>(before, before)),
                     other = signed_distance_on(boundary, hull<size>(after, after));
      if (!((one.positive() && other.negative()) || (one.negative() && other.positive()))) continue;
      const std::array<Interval, size> between = hull<size>(before, after);
      if (limits_ && !determinant_->is_reached(between)) continue;
      if (boundary.sided && !side(boundary, displacement(boundary.leg, between)).positive()) continue;
      return std::max(length<size>(before), length<size>(after));
    }
    return 0.0;
  }

  // With the rotation of y there is a displacement to the surface, as long as the distance.
  double proved_by_displacement(const Boundary& boundary, const Coordinates<size>& y) const noexcept {
    std::array<Interval, size> turned;
    double squared = 0.0;
    for (std::size_t i = 0; i < searched; ++i) {
      turned[first_searched + i] = Interval(y[first_searched + i]);
      squared += y[first_searched + i] * y[first_searched + i];
    }
    const Interval signed_distance = signed_distance_on(boundary, turned);
    const double farthest = std::max(-signed_distance.lower(), signed_distance.upper());
    const double distance = std::sqrt(farthest * farthest + squared), margin = 1e-9 * (1.0 + distance);
    if (!limits_) return distance;
    std::array<Interval, size> about;
    for (std::size_t i = 0; i < size; ++i) about[i] = Interval(-(margin - y[i]), y[i] + margin);
    if (!determinant_->is_reached(about)) return 0.0;
    return !boundary.sided || side(boundary, displacement(boundary.leg, about)).positive() ? distance : 0.0;
  }

  void finish() noexcept {
    result_.lower = std::min(nearest_, searched > 0 ? target() : nearest_);
    const bool done = nearest_ >= target();
    if (!result_.has_witness() && searched > 0 && done && range_.holds_all) {
      const int boxes = result_.boxes;
      result_ = Result::absent();
      result_.boxes = boxes;
      return;
    }
    result_.status = !result_.has_witness() ? DistanceStatus::no_witness
                     : result_.lower >= (1.0 - options_.tolerance) * result_.upper ? DistanceStatus::tight
                                                                                   : DistanceStatus::loose;
  }

  const Chart& chart_;
  const DistanceOptions options_;
  CellQueue<searched> queue_;
  const std::vector<Boundary>* boundaries_ = nullptr;
  const WorkingMode* mode_ = nullptr;
  const ModeDeterminant<space>* determinant_ = nullptr;
  bool limits_ = false;
  SearchRange range_;
  double nearest_ = 0.0;  // proved: no boundary is closer
  int attempts_ = 0;
  Result result_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_LEG_SEARCH_H
