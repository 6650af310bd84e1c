// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_CHECK_H
#define PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_CHECK_H

#include "aspects/star_sets/star_conditions.h"
#include "aspects/star_sets/star_coordinates.h"
#include "interval/dual.h"
#include "interval/interval.h"

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// Whether all that S(signs, sign) has in a box is proved to be star-shaped about a pose of it, in the given
/// coordinates. With p the pose, z(x) the coordinates of a pose x, and v the field along which z runs
/// straight to z(p): for each function f that is positive in the set, f + v f >= 0 on the box. Then f e^t
/// does not fall on the way, so that f stays positive.
template <class Chart, std::size_t Levels>
class StarCheck {
 public:
  using Coordinates = StarCoordinates<Chart, Levels>;
  using Form = typename Coordinates::Form;
  using Slope = Dual<1, Form>;
  using Forms = BoxForms<Chart>;
  using Signs = typename Forms::Signs;
  static constexpr std::size_t size = Coordinates::size, leg_count = Coordinates::leg_count;

  /// `heights`: those at the pose, enclosed.
  StarCheck(const LegTypes<leg_count>& types, const Coordinates& coordinates, const MapPoint& pose,
            const std::array<Interval, Levels>& heights)
      : types_(types), coordinates_(coordinates), pose_(pose), heights_(heights) {}

  /// The box must hold the pose.
  bool holds(const ChartBox<Chart>& at, const Signs& signs, int sign) {
    const BoxIntervals<Chart> intervals(at);
    if (intervals.reachable_nowhere()) return false;
    const Forms forms(intervals);
    if (forms.reachable_nowhere() || !is_clear_of_obstacles(forms, signs)) return false;
    if (!find_field(at)) return false;
    const PlacedLegs<Chart, Slope> placed(at.chart, at.root, moving_);
    const StarConditions<Chart, Slope> conditions(at, types_, placed, entries(forms.entries(), placed));
    const LegSet unknown = unclear_but(coordinates_.legs(), forms.entries(), leg_count);
    bool all = true;
    const bool known =
        conditions.visit(signs, sign, coordinates_.legs(), [&](const Slope& f, LegSet depends) {
          if (!all || range_of(f).positive()) return;
          all = (depends & unknown) == 0 && does_not_fall(f);
        });
    return known && all;
  }

 private:
  static bool is_clear_of_obstacles(const Forms& forms, const Signs& signs) {
    return forms.constraint(ConstraintKind::obstacles, signs) == Verdict::holds &&
           forms.constraint(ConstraintKind::self_collision, signs) == Verdict::holds;
  }

  /// Whether f + v f >= 0.
  bool does_not_fall(const Slope& f) const {
    Form sum = scale_ * f.value + f.gradient[0];
    if constexpr (Levels > 0) sum = relations_->without_replaced(sum);
    return sum.range().lower() >= 0.0;
  }

  /// The field, times a positive function; false where it is not proved to be one.
  bool find_field(const ChartBox<Chart>& at) {
    const auto x = Coordinates::pose(at);
    for (std::size_t i = 0; i < size; ++i) {
      moving_[i] = Slope(x[i]);
      moving_[i].gradient[0] = Form(pose_[i]) - x[i];
    }
    if constexpr (Levels == 0) {
      scale_ = Form(1.0);
      return true;
    } else {
      find_level_slopes(at, x);
      if (!relations_->are_solved() || !can_solve() || !sides_are_free(at)) return false;
      solve();
      return true;
    }
  }

  /// Of B_jj^2 of the levels.
  void find_level_slopes(const ChartBox<Chart>& at, const std::array<Form, size>& x) {
    using All = Dual<size, Form>;
    std::array<All, size> coordinates;
    for (std::size_t i = 0; i < size; ++i) coordinates[i] = All::coordinate(x[i], i);
    const PlacedLegs<Chart, All> placed(at.chart, at.root, coordinates);
    std::array<Form, Levels> squares;
    for (std::size_t level = 0; level < Levels; ++level) {
      const All& square = placed.squared_b_entry(coordinates_.leg[level]);
      slopes_[level] = square.gradient;
      squares[level] = square.value;
    }
    relations_.emplace(coordinates_, squares);
  }

  const Form& slope(std::size_t level, std::size_t other) const {
    return slopes_[level][coordinates_.replaced[other]];
  }

  /// Whether the heights determine the replaced coordinates where the others are fixed. Each row of the
  /// matrix of slopes may be that of another pose, as the mean value theorem has it, so that intervals are
  /// multiplied.
  bool can_solve() {
    Interval determinant;
    if constexpr (Levels == 1) determinant = slope(0, 0).range();
    if constexpr (Levels == 2)
      determinant = slope(0, 0).range() * slope(1, 1).range() - slope(0, 1).range() * slope(1, 0).range();
    orientation_ = determinant.positive() ? 1.0 : -1.0;
    return determinant.positive() || determinant.negative();
  }

  /// Whether no pose with heights examined lies on the sides of the box at the ends of replaced coordinates.
  bool sides_are_free(const ChartBox<Chart>& at) const {
    for (const std::size_t i : coordinates_.replaced)
      for (const bool upper : {false, true}) {
        Box side = at.box;
        (upper ? side.lower : side.upper)[i] = (upper ? side.upper : side.lower)[i];
        if (!is_free(at, side, max_halvings)) return false;
      }
    return true;
  }

  bool is_free(const ChartBox<Chart>& at, const Box& side, int halvings) const {
    const auto x = BoxForms<Chart>::coordinates(at.with(side));
    const PlacedLegs<Chart, typename Forms::Form> placed(at.chart, at.root, x);
    for (std::size_t level = 0; level < Levels; ++level) {
      const Interval square = placed.squared_b_entry(coordinates_.leg[level]).range();
      if ((square - squared(coordinates_.lowest[level])).negative() ||
          (square - squared(coordinates_.highest[level])).positive())
        return true;
    }
    if (halvings == 0) return false;
    std::size_t widest = 0;
    for (std::size_t i = 1; i < size; ++i)
      if (side.width(i) * at.box.width(widest) > side.width(widest) * at.box.width(i)) widest = i;
    Box lower = side, upper = side;
    lower.upper[widest] = upper.lower[widest] = side.center(widest);
    return is_free(at, lower, halvings - 1) && is_free(at, upper, halvings - 1);
  }

  static Interval squared(double height) { return square(Interval(height)); }

  void solve() {
    std::array<Form, Levels> wanted;  // d B_jj^2 / dt that the other coordinates leave to the replaced ones
    for (std::size_t level = 0; level < Levels; ++level) {
      const Form height = coordinates_.height(level);
      wanted[level] = Interval(2.0) * (height * (Form(heights_[level]) - height));
      for (std::size_t i = 0; i < size; ++i)
        if (!coordinates_.is_replaced(i)) wanted[level] += -(slopes_[level][i] * moving_[i].gradient[0]);
    }
    const Interval orientation(orientation_);
    if constexpr (Levels == 1) {
      scale_ = orientation * slope(0, 0);
      moving_[coordinates_.replaced[0]].gradient[0] = orientation * wanted[0];
    } else if constexpr (Levels == 2) {
      scale_ = orientation * (slope(0, 0) * slope(1, 1) - slope(0, 1) * slope(1, 0));
      moving_[coordinates_.replaced[0]].gradient[0] =
          orientation * (slope(1, 1) * wanted[0] - slope(0, 1) * wanted[1]);
      moving_[coordinates_.replaced[1]].gradient[0] =
          orientation * (slope(0, 0) * wanted[1] - slope(1, 0) * wanted[0]);
    }
    for (std::size_t i = 0; i < size; ++i)
      if (!coordinates_.is_replaced(i)) moving_[i].gradient[0] = scale_ * moving_[i].gradient[0];
  }

  template <class Entries>
  std::array<Slope, leg_count> entries(const Entries& known, const PlacedLegs<Chart, Slope>& placed) const {
    std::array<Slope, leg_count> result;
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (!known.clear(j)) {
        result[j] = Slope(Form(known.value(j)));
        continue;
      }
      const Slope& square = placed.squared_b_entry(j);
      result[j] = Slope(square_root(square.value, known.square(j).lower()));
      result[j].gradient[0] =
          reciprocal(Interval(2.0) * result[j].value, known.value(j).lower()) * square.gradient[0];
    }
    for (std::size_t level = 0; level < Levels; ++level) {
      Slope& height = result[coordinates_.leg[level]];
      height = Slope(coordinates_.height(level));
      height.gradient[0] = scale_ * (Form(heights_[level]) - height.value);
    }
    return result;
  }

  static constexpr int max_halvings = Levels == 1 ? 0 : 8;

  const LegTypes<leg_count>& types_;
  const Coordinates& coordinates_;
  const MapPoint& pose_;
  const std::array<Interval, Levels>& heights_;
  std::array<Slope, size> moving_;  // pose coordinates, with their speeds along the field
  Form scale_;                      // what the field is multiplied by
  std::array<std::array<Form, size>, Levels> slopes_;
  std::optional<LevelRelations<Chart, Levels>> relations_;
  double orientation_ = 1.0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_CHECK_H
