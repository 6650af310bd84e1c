// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_WEDGE_PROOF_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_WEDGE_PROOF_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/box_slopes.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// Proves that all of S(s, sigma) in a box lies in one aspect, where the box holds a serial singularity of
/// one leg and det A = 0 touches it: there the set is a wedge with a tip, which does not grow along
/// coordinates.
///
/// Let g = B_jj^2 of that leg and h = |B_jj|. In place of one pose coordinate y, along which g rises, h is
/// taken: a pose is (w, h), w being the other coordinates. In them det A is a smooth function F(w, h), and
/// the set is { h > 0, sigma F > 0 }. Let N be the poses with w in a box W, longer than the given one along
/// one of its coordinates x, and 0 < h <= the largest h in the given box. If at constant h and constant other
/// w, sigma F nowhere falls along x, and if it is positive all over the end x = e of N, then what N holds of
/// the set can be pushed onto that end, which is connected. N holds all of the set that the given box does.
///
/// With subscripts for partial derivatives at constant h, the slope of F along x in these coordinates is
/// F_x - F_y g_x / g_y. N is enclosed by a box of poses that g <= 0 on its face below and g >= the largest
/// h^2 on the one above, seen along y.
template <class Chart>
class WedgeProof {
 public:
  using Intervals = BoxIntervals<Chart>;
  using Forms = BoxForms<Chart>;
  using Slopes = BoxSlopes<Chart>;
  using Signs = typename Slopes::Signs;
  static constexpr std::size_t size = Chart::coordinate_count;

  WedgeProof(const Slopes& here, const Signs& signs, int sign, const BoxPolicy& policy)
      : here_(here), box_(here.at().box), signs_(signs), sign_(sign), policy_(policy) {}

  /// A pose that all of the set in the box is connected with, in the coordinates of the root, where there
  /// is a proof; it may lie outside of the box.
  std::optional<MapPoint> find() {
    const auto leg = here_.forms().single_unclear_leg(signs_);
    if (size < 2 || !leg) return std::nullopt;
    leg_ = *leg;
    slopes_ = here_.squared_b_entry_gradient(leg_);
    y_ = steepest();
    if (!has_sign(slopes_[y_])) return std::nullopt;
    const auto along = level_slopes(here_);
    for (std::size_t x = 0; x < size; ++x) {
      if (x == y_ || !has_sign(along[x])) continue;
      if (const auto pose = find_along(x, along[x])) return pose;
    }
    return std::nullopt;
  }

 private:
  static bool has_sign(const Interval& value) { return value.positive() || value.negative(); }
  static double middle(const Interval& value) { return 0.5 * (value.lower() + value.upper()); }
  static double least_size(const Interval& value) { return std::max(value.lower(), -value.upper()); }

  std::size_t steepest() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < size; ++i)
      if (least_size(slopes_[i]) > least_size(slopes_[best])) best = i;
    return best;
  }

  /// Slopes of sigma F at constant h, times |g_y|.
  std::array<Interval, size> level_slopes(const Slopes& slopes) const {
    std::array<Interval, size> result = slopes.level_slopes(signs_, leg_, y_);
    const Interval factor(slopes_[y_].positive() ? sign_ : -sign_);
    for (Interval& each : result) each = factor * each;
    return result;
  }

  std::optional<MapPoint> find_along(std::size_t x, const Interval& slope) {
    const Interval determinant = Interval(sign_) * here_.forms().determinant(signs_);
    const double steepness = std::abs(middle(slope) / middle(slopes_[y_]));
    double length = 1.25 * std::max(0.0, -determinant.lower()) / steepness;
    for (int i = 0; i < policy_.wedge_attempts && std::isfinite(length); ++i, length *= 2.0) {
      const Box wide = enclosure(x, slope.positive(), length);
      const Box end = tightened(end_of(wide, x, slope.positive()), x);
      if (!end_is_free(end)) continue;
      if (!encloses(wide) || !encloses(end) || !rises(wide, x, slope.positive())) return std::nullopt;
      return pose_at(end);
    }
    return std::nullopt;
  }

  /// A guess at the enclosure of N, by first-order approximation of g about the center of the box.
  Box enclosure(std::size_t x, bool upward, double length) const {
    Box wide = box_;
    (upward ? wide.upper : wide.lower)[x] += upward ? length : -length;
    const double at_center = middle(here_.forms().squared_b_entry_at_center(leg_));
    double most = at_center, least = at_center;
    for (std::size_t i = 0; i < size; ++i) {
      if (i == y_) continue;
      const double slope = middle(slopes_[i]);
      const double below = slope * (wide.lower[i] - box_.center(i)),
                   above = slope * (wide.upper[i] - box_.center(i));
      most += std::max(below, above);
      least += std::min(below, above);
    }
    const double steepness = std::abs(middle(slopes_[y_])), reserve = 1.25;
    const double down = reserve * std::max(0.0, most) / steepness,
                 up = reserve * std::max(0.0, highest() - least) / steepness;
    const bool rising = slopes_[y_].positive();
    wide.lower[y_] = std::min(wide.lower[y_], box_.center(y_) - (rising ? down : up));
    wide.upper[y_] = std::max(wide.upper[y_], box_.center(y_) + (rising ? up : down));
    return wide;
  }

  /// The largest h^2 in the given box.
  double highest() const { return here_.forms().entries().square(leg_).upper(); }

  static Box end_of(Box box, std::size_t coordinate, bool upper) {
    (upper ? box.lower : box.upper)[coordinate] = (upper ? box.upper : box.lower)[coordinate];
    return box;
  }

  /// A guess at the least box that encloses the end of N.
  Box tightened(Box end, std::size_t x) const {
    const double bottom = where(end, 0.0), top = where(end, highest());
    double margin = 0.25 * std::abs(top - bottom);
    for (std::size_t i = 0; i < size; ++i)
      if (i != x && i != y_) margin += std::abs(middle(slopes_[i]) / middle(slopes_[y_])) * end.width(i);
    end.lower[y_] = std::max(end.lower[y_], std::min(bottom, top) - margin);
    end.upper[y_] = std::min(end.upper[y_], std::max(bottom, top) + margin);
    return end;
  }

  /// Where g comes to `value` on the line along y through the center of a box.
  double where(const Box& box, double value) const {
    const bool rising = slopes_[y_].positive();
    MapPoint pose = box.middle();
    double below = rising ? box.lower[y_] : box.upper[y_], above = rising ? box.upper[y_] : box.lower[y_];
    for (int i = 0; i < policy_.wedge_bisections; ++i) {
      pose[y_] = 0.5 * (below + above);
      (middle(squared_b_entry_at(pose)) > value ? above : below) = pose[y_];
    }
    return pose[y_];
  }

  /// As BoxIntervals has it, of one leg alone: this is asked for many poses.
  Interval squared_b_entry_at(const MapPoint& pose) const {
    const Chart& chart = here_.at().chart;
    std::array<Interval, size> at;
    for (std::size_t i = 0; i < size; ++i) at[i] = Interval(pose[i]);
    const auto placement = chart.place(here_.at().root, at);
    const auto displacement = chart.displacement(leg_, placement);
    return chart.rows(leg_, chart.form(leg_, displacement), displacement, placement).squared_b_entry;
  }

  /// The poses of a box of which N may hold some.
  ChartBox<Chart> within(const Box& box) const { return here_.at().with(box, BoundedEntry{leg_, highest()}); }

  bool end_is_free(const Box& end) const {
    const Intervals intervals(within(end));
    if (intervals.reachable_nowhere()) return false;
    const Forms forms(intervals);
    return forms.holds_but_for(leg_, signs_) && (Interval(sign_) * forms.determinant(signs_)).positive();
  }

  bool encloses(const Box& wide) const {
    const bool rising = slopes_[y_].positive();
    return squared_b_entry(end_of(wide, y_, !rising)).upper() <= 0.0 &&
           squared_b_entry(end_of(wide, y_, rising)).lower() >= highest();
  }

  Interval squared_b_entry(const Box& box) const {
    const Intervals intervals(here_.at().with(box));
    if (intervals.reachable_nowhere()) return intervals.entries().square(leg_);
    return Forms(intervals).entries().square(leg_);
  }

  bool rises(const Box& wide, std::size_t x, bool upward) const {
    const Intervals intervals(within(wide));
    if (intervals.reachable_nowhere()) return false;
    const Forms forms(intervals);
    if (!forms.holds_but_for(leg_, signs_)) return false;
    const Slopes slopes(forms);
    const Interval steepness = slopes.squared_b_entry_gradient(leg_)[y_], slope = level_slopes(slopes)[x];
    return (slopes_[y_].positive() ? steepness.positive() : steepness.negative()) &&
           (upward ? slope.lower() >= 0.0 : slope.upper() <= 0.0);
  }

  /// A pose of N on its end.
  std::optional<MapPoint> pose_at(const Box& end) const {
    MapPoint pose = end.middle();
    pose[y_] = where(end, 0.5 * highest());
    const Interval found = squared_b_entry_at(pose);
    if (!found.positive() || found.upper() > highest()) return std::nullopt;
    return pose;
  }

  const Slopes& here_;
  const Box& box_;
  const Signs& signs_;
  int sign_;
  const BoxPolicy& policy_;
  std::size_t leg_ = 0, y_ = 0;
  std::array<Interval, size> slopes_;  // of g in the given box
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_WEDGE_PROOF_H
