// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_SEARCH_H
#define PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_SEARCH_H

#include "aspects/star_sets/star_check.h"
#include "aspects/star_sets/star_coordinates.h"
#include "aspects/star_sets/star_finder.h"
#include "aspects/star_sets/star_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {

/// Looks for a pose about which all that S(signs, sign) has in a box is star-shaped, be it a little outside
/// of the box, or for a proof that it has nothing. With heights of `Levels` legs as coordinates.
template <class Chart, std::size_t Levels>
class StarSearch {
 public:
  using Coordinates = StarCoordinates<Chart, Levels>;
  using Survey = StarSurvey<Chart, Levels>;
  using Forms = BoxForms<Chart>;
  using Signs = typename Forms::Signs;
  static constexpr std::size_t size = Coordinates::size, leg_count = Coordinates::leg_count;

  /// `here`: the box; `region`: which a star must not leave.
  StarSearch(const Forms& here, const Box& region, const LegTypes<leg_count>& types, const Signs& signs,
             int sign)
      : here_(here), region_(region), types_(types), signs_(signs), sign_(sign) {}

  /// False where the heights of these legs are no coordinates.
  bool set_levels(const std::array<std::size_t, Levels>& legs) {
    coordinates_.leg = legs;
    for (std::size_t level = 0; level < Levels; ++level) {
      squares_[level] = here_.placed().squared_b_entry(legs[level]);
      coordinates_.lowest[level] = here_.entries().value(legs[level]).lower();
      coordinates_.highest[level] = here_.entries().value(legs[level]).upper();
    }
    return choose_replaced(false);
  }

  /// Replaces coordinates in whose direction the region goes on; false where these are as before, or none.
  bool avoid_ends() {
    const auto before = coordinates_.replaced;
    return choose_replaced(true) && coordinates_.replaced != before;
  }

  /// Whether conditions take |B_jj| of legs that have no slope in the box.
  bool lacks_levels() { return Survey(here_, types_, coordinates_, signs_, sign_).lacks_levels(); }

  Stars find(int halvings = max_halvings, int cuts = max_cuts) {
    const Survey survey(here_, types_, coordinates_, signs_, sign_);
    if (survey.fails()) return Stars::none();
    const CommonPoint common = survey.common_point();
    if (!common.found && survey.is_empty(common.weights)) return Stars::none();
    for (const double reach : {3.0, 1.0}) {
      const Stars found = find_within(reach);
      if (found.is_known) return found;
    }
    return halvings > 0 && cuts > 0 ? find_in_halves(halvings - 1, cuts - 1) : Stars();
  }

 private:
  const ChartBox<Chart>& at() const { return here_.at(); }
  const Box& box() const { return here_.at().box; }

  /// By heights: the boundary is curved by these most, where they are like the root of the edge of a small
  /// box. Where det A falls with a height, the set may be in a small share of that range alone: upper halves
  /// that are empty are cut off, beside the halvings of what is not.
  Stars find_in_halves(int halvings, int cuts) {
    if constexpr (Levels > 0) {
      const Coordinates all = coordinates_;
      std::size_t level = 0;
      for (std::size_t i = 1; i < Levels; ++i)
        if (all.highest[i] - all.lowest[i] > all.highest[level] - all.lowest[level]) level = i;
      const double middle = 0.5 * (all.lowest[level] + all.highest[level]);
      coordinates_.lowest[level] = middle;
      const Stars upper = find(halvings, cuts);
      coordinates_ = all;
      if (!upper.is_known) return upper;
      coordinates_.highest[level] = middle;
      const Stars lower = find(upper.count == 0 ? halvings + 1 : halvings, cuts);
      coordinates_ = all;
      return upper.with(lower);
    }
    return Stars();
  }

  Stars find_within(double reach) {
    const Box wide = enclosure(reached(reach));
    const BoxIntervals<Chart> intervals(at().with(wide));
    if (intervals.reachable_nowhere()) return Stars::none();
    const Forms forms(intervals);
    if (!forms.state(signs_).may_be(sign_)) return Stars::none();
    const Survey survey(forms, types_, coordinates_, signs_, sign_);
    if (survey.lacks_levels()) return Stars();
    const CommonPoint common = survey.common_point();
    if (!common.found) return Stars();
    const MapPoint pose = pose_at(wide, common.point);
    if (!region_.contains(pose) || !is_inside(pose)) return Stars();
    Coordinates coordinates = coordinates_;
    std::array<Interval, Levels> heights;
    for (std::size_t level = 0; level < Levels; ++level) {
      heights[level] = square_root(squared_b_entry_at(pose, level));
      coordinates.lowest[level] = std::min(coordinates.lowest[level], heights[level].lower());
      coordinates.highest[level] = std::max(coordinates.highest[level], heights[level].upper());
    }
    const Box hull = enclosure(with_pose(pose));
    if (!is_within_region(hull)) return Stars();
    StarCheck<Chart, Levels> check(types_, coordinates, pose, heights);
    return check.holds(at().with(hull), signs_, sign_) ? Stars::one(pose) : Stars();
  }

  bool is_within_region(const Box& hull) const {
    for (std::size_t i = 0; i < size; ++i)
      if (!(hull.lower[i] >= region_.lower[i] && hull.upper[i] <= region_.upper[i])) return false;
    return true;
  }

  /// The box, longer by this factor along coordinates that are not replaced.
  Box reached(double factor) const {
    Box result = box();
    for (std::size_t i = 0; i < size; ++i) {
      if (coordinates_.is_replaced(i)) continue;
      const double more = 0.5 * (factor - 1.0) * box().width(i);
      result.lower[i] = std::max(box().lower[i] - more, region_.lower[i]);
      result.upper[i] = std::min(box().upper[i] + more, region_.upper[i]);
    }
    return result;
  }

  Box with_pose(const MapPoint& pose) const {
    Box result = box();
    for (std::size_t i = 0; i < size; ++i) {
      result.lower[i] = std::min(result.lower[i], pose[i]);
      result.upper[i] = std::max(result.upper[i], pose[i]);
    }
    return result;
  }

  /// Half of an edge of the box, which forms have for a unit.
  double half(std::size_t i) const { return 0.5 * box().width(i); }

  double slope(std::size_t level, std::size_t i) const { return squares_[level].slope(i) / half(i); }

  /// A guess at what encloses all poses with heights examined over a box of the other coordinates.
  Box enclosure(Box wide) const {
    if constexpr (Levels > 0) {
      std::array<Interval, Levels> spread;  // of what heights and other coordinates ask of the replaced ones
      for (std::size_t level = 0; level < Levels; ++level) {
        const double center = squares_[level].center();
        double least = coordinates_.lowest[level] * coordinates_.lowest[level] - center,
               most = coordinates_.highest[level] * coordinates_.highest[level] - center;
        for (std::size_t i = 0; i < size; ++i) {
          if (coordinates_.is_replaced(i)) continue;
          const double below = slope(level, i) * (wide.lower[i] - box().center(i)),
                       above = slope(level, i) * (wide.upper[i] - box().center(i));
          least -= std::max(below, above);
          most -= std::min(below, above);
        }
        const double reserve = share_of_reserve * (most - least);
        spread[level] = Interval(least - reserve, most + reserve);
      }
      const Matrix<Levels> by_squares = inverse_slopes();
      for (std::size_t level = 0; level < Levels; ++level) {
        Interval range(box().center(coordinates_.replaced[level]));
        for (std::size_t m = 0; m < Levels; ++m) range += Interval(by_squares[level][m]) * spread[m];
        const std::size_t y = coordinates_.replaced[level];
        wide.lower[y] = std::min(wide.lower[y], range.lower());
        wide.upper[y] = std::max(wide.upper[y], range.upper());
      }
    }
    return wide;
  }

  /// What B_jj^2 of the levels change the replaced coordinates by, in the box.
  Matrix<Levels> inverse_slopes() const {
    Matrix<Levels> slopes{};
    for (std::size_t level = 0; level < Levels; ++level)
      for (std::size_t m = 0; m < Levels; ++m) slopes[level][m] = slope(level, coordinates_.replaced[m]);
    return inverse(slopes);
  }

  /// The coordinates that the heights determine best. Ranges of these grow, for which there may be no room at
  /// an end of the region.
  bool choose_replaced(bool away_from_ends) {
    double best = 0.0;
    const auto take = [&](double determinant, const std::array<std::size_t, Levels>& choice) {
      if (!(std::abs(determinant) > best)) return;
      for (const std::size_t i : choice)
        if (away_from_ends && is_at_end(i)) return;
      best = std::abs(determinant);
      coordinates_.replaced = choice;
    };
    if constexpr (Levels == 1)
      for (std::size_t i = 0; i < size; ++i) take(squares_[0].slope(i), {i});
    if constexpr (Levels == 2)
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t k = i + 1; k < size; ++k)
          take(squares_[0].slope(i) * squares_[1].slope(k) - squares_[0].slope(k) * squares_[1].slope(i),
               {i, k});
    return Levels == 0 || best > 0.0;
  }

  bool is_at_end(std::size_t i) const {
    const double room = std::min(box().lower[i] - region_.lower[i], region_.upper[i] - box().upper[i]);
    return room < room_needed * box().width(i);
  }

  /// The pose with these coordinates, each in [-1, 1] of its range.
  MapPoint pose_at(const Box& wide, const MapPoint& share) const {
    MapPoint pose{};
    for (std::size_t i = 0; i < size; ++i) pose[i] = wide.center(i) + 0.5 * share[i] * wide.width(i);
    if constexpr (Levels > 0) {
      std::array<double, Levels> wanted;
      for (std::size_t level = 0; level < Levels; ++level) {
        const std::size_t y = coordinates_.replaced[level];
        const double low = coordinates_.lowest[level], high = coordinates_.highest[level];
        const double height = low + 0.5 * (high - low) * (1.0 + share[y]);
        wanted[level] = height * height;
        pose[y] = wide.center(y);
      }
      const Matrix<Levels> by_squares = inverse_slopes();
      for (int step = 0; step < newton_steps; ++step) {
        std::array<double, Levels> missing;
        for (std::size_t level = 0; level < Levels; ++level)
          missing[level] = wanted[level] - middle_of(squared_b_entry_at(pose, level));
        for (std::size_t level = 0; level < Levels; ++level)
          for (std::size_t m = 0; m < Levels; ++m)
            pose[coordinates_.replaced[level]] += by_squares[level][m] * missing[m];
      }
    }
    return pose;
  }

  Interval squared_b_entry_at(const MapPoint& pose, std::size_t level) const {
    const Box point{size, pose, pose};
    return BoxIntervals<Chart>(at().with(point)).entries().square(coordinates_.leg[level]);
  }

  bool is_inside(const MapPoint& pose) const {
    const Box point{size, pose, pose};
    const BoxIntervals<Chart> intervals(at().with(point));
    return intervals.state(signs_).is_inside(sign_);
  }

  static constexpr double share_of_reserve = 0.15;
  static constexpr double room_needed = 2.0;  // edges of the box
  static constexpr int newton_steps = 4;
  static constexpr int max_halvings = Levels == 0 ? 0 : 4, max_cuts = 16;

  const Forms& here_;
  const Box& region_;
  const LegTypes<leg_count>& types_;
  const Signs& signs_;
  int sign_;
  Coordinates coordinates_;
  std::array<typename Forms::Form, Levels> squares_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_SEARCH_H
