// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_SURVEY_H
#define PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_SURVEY_H

#include "aspects/star_sets/star_conditions.h"
#include "aspects/star_sets/star_coordinates.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// A linear function of coordinates in [-1, 1].
struct LinearFunction {
  double at_center = 0.0;
  MapPoint slope{};
};

/// Some linear functions.
struct LinearFunctions {
  static constexpr std::size_t most = 48;

  std::array<LinearFunction, most> items;
  std::size_t count = 0;

  bool is_full() const noexcept { return count == most; }
  void add(const LinearFunction& function) noexcept { items[count++] = function; }
};

/// Where linear functions are positive together, or why they are nowhere.
struct CommonPoint {
  bool found = false;
  MapPoint point{};  ///< with coordinates in [-1, 1]
  /// Of each function, not negative: where no point was found, their sum with these factors is hardly
  /// positive anywhere.
  std::array<double, LinearFunctions::most> weights{};
};

/// Looks for a point where all functions are positive, by a good margin, in double precision.
CommonPoint find_common_point(const LinearFunctions& functions) noexcept;

/// The conditions that do not hold on all of a box, as linear functions of the coordinates of a star.
template <class Chart, std::size_t Levels>
class StarSurvey {
 public:
  using Coordinates = StarCoordinates<Chart, Levels>;
  using Form = typename Coordinates::Form;
  using Forms = BoxForms<Chart>;
  using Signs = typename Forms::Signs;
  static constexpr std::size_t size = Coordinates::size, leg_count = Coordinates::leg_count;

  StarSurvey(const Forms& forms, const LegTypes<leg_count>& types, const Coordinates& coordinates,
             const Signs& signs, int sign)
      : coordinates_(coordinates) {
    const ChartBox<Chart>& at = forms.at();
    const PlacedLegs<Chart, Form> placed(at.chart, at.root, Coordinates::pose(at));
    relations_.emplace(coordinates, squares(placed));
    is_known_ = relations_->are_solved();
    if (!is_known_) return;
    const StarConditions<Chart, Form> conditions(at, types, placed,
                                                 coordinates.entries(forms.entries(), placed));
    const LegSet unknown = unclear_but(coordinates.legs(), forms.entries(), leg_count);
    is_known_ = conditions.visit(signs, sign, coordinates.legs(), [&](const Form& f, LegSet depends) {
      fails_ = fails_ || f.range().upper() <= 0.0;
      if (!f.range().positive()) add(f, (depends & unknown) != 0);
    });
  }

  /// Legs whose heights have to be coordinates: conditions that do not hold on the whole box take |B_jj| of
  /// one that has no slope there.
  bool lacks_levels() const noexcept { return lacks_levels_; }

  /// Whether some condition is proved to hold nowhere.
  bool fails() const noexcept { return fails_; }

  /// Where all conditions hold, if they were linear.
  CommonPoint common_point() const noexcept { return is_known_ ? find_common_point(linear_) : CommonPoint(); }

  /// Whether this mean of the conditions is proved to be positive nowhere, so that some always fails.
  bool is_empty(const std::array<double, LinearFunctions::most>& weights) const {
    if (!is_known_ || lacks_levels_ || linear_.count == 0) return false;
    Form sum;
    for (std::size_t i = 0; i < linear_.count; ++i) sum += Interval(weights[i]) * forms_[i];
    return relations_->without_replaced(sum).range().upper() < 0.0;
  }

 private:
  std::array<Form, Levels> squares(const PlacedLegs<Chart, Form>& placed) const {
    std::array<Form, Levels> result;
    for (std::size_t level = 0; level < Levels; ++level)
      result[level] = placed.squared_b_entry(coordinates_.leg[level]);
    return result;
  }

  void add(const Form& f, bool lacks_level) {
    lacks_levels_ = lacks_levels_ || lacks_level;
    if (linear_.is_full()) return;
    forms_[linear_.count] = f;
    linear_.add(lacks_level ? LinearFunction{1.0, {}} : in_coordinates(f));
  }

  /// With the replaced coordinates taken from the heights, to first order about the middle of these.
  LinearFunction in_coordinates(const Form& f) const {
    LinearFunction result{f.center(), {}};
    for (std::size_t i = 0; i < size; ++i)
      if (!coordinates_.is_replaced(i)) result.slope[i] = f.slope(i);
    for (std::size_t level = 0; level < Levels; ++level) {
      const std::size_t y = coordinates_.replaced[level];
      result.slope[y] += f.slope(size + level);
      for (std::size_t m = 0; m < Levels; ++m) {
        const double over = f.slope(y) * relations_->inverse_slope(level, m);
        const double middle = 0.5 * (coordinates_.highest[m] + coordinates_.lowest[m]),
                     half = 0.5 * (coordinates_.highest[m] - coordinates_.lowest[m]);
        result.at_center += over * (middle * middle - relations_->square_of(m).center());
        result.slope[coordinates_.replaced[m]] += over * 2.0 * middle * half;
        for (std::size_t i = 0; i < size; ++i)
          if (!coordinates_.is_replaced(i)) result.slope[i] -= over * relations_->square_of(m).slope(i);
      }
    }
    return result;
  }

  const Coordinates& coordinates_;
  std::optional<LevelRelations<Chart, Levels>> relations_;
  bool is_known_ = true, lacks_levels_ = false, fails_ = false;
  LinearFunctions linear_;
  std::array<Form, LinearFunctions::most> forms_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_STAR_SETS_STAR_SURVEY_H
