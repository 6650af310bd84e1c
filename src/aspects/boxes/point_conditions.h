// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_POINT_CONDITIONS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_POINT_CONDITIONS_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/box_stage.h"
#include "aspects/boxes/evaluated_legs.h"
#include "interval/dual.h"
#include "interval/scalar_range.h"
#include "legs/limit_verdict.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {

template <std::size_t N, class Value>
Condition condition(const Dual<N, Value>& function) {
  Condition result{middle_of(range_of(function)), {}};
  for (std::size_t i = 0; i < N; ++i) result.slope[i] = middle_of(range_of(function.gradient[i]));
  return result;
}

/// Of limits of which one is enough, the one that is farther from failing.
template <std::size_t N, class Value>
void add_limits(const LimitFunctions<Dual<N, Value>>& limits, Conditions& result) {
  std::array<Condition, 2> each;
  for (std::size_t k = 0; k < limits.count; ++k) each[k] = condition(limits.values[k]);
  if (limits.any && limits.count == 2) return result.add(each[each[0].value < each[1].value ? 1 : 0]);
  for (std::size_t k = 0; k < limits.count; ++k) result.add(each[k]);
}

/// The conditions of S(s, sigma) at one pose with their partial derivatives, in double precision: see
/// BoxClassifier::conditions. Affine forms of a box without width would be no closer, and cost ten times as
/// much.
template <class Chart>
class PointConditions {
 public:
  static constexpr std::size_t leg_count = Chart::leg_count, coordinate_count = Chart::coordinate_count;
  using Signs = std::array<int, leg_count>;

  /// `at`: a box without width.
  explicit PointConditions(const ChartBox<Chart>& at)
      : at_(at), placed_(at.chart, at.root, coordinates()), legs_(at.chart, placed_, entries()) {}

  /// None unless all legs reach the pose.
  Conditions of(const Signs& signs, int sign) const {
    Conditions result;
    for (std::size_t j = 0; j < leg_count; ++j)
      if (!(placed_.squared_b_entry(j).value.value > 0.0)) return result;
    for (std::size_t j = 0; j < leg_count; ++j) {
      result.entry_of_leg[j] = result.count;
      result.add(condition(placed_.squared_b_entry(j)));
      add_limits(at_.chart.limits(j, placed_.legs[j].displacement, legs_.entry(j), signs[j]), result);
    }
    result.add(condition(Interval(sign) * legs_.determinant(signs)));
    add_margins(signs, result);
    add_constraints(signs, result);
    return result;
  }

 private:
  using Slope = Dual<coordinate_count, PointNumber>;
  using Points = typename EvaluatedLegs<Chart, Slope>::Links;

  std::array<Slope, coordinate_count> coordinates() const {
    std::array<Slope, coordinate_count> result;
    for (std::size_t i = 0; i < coordinate_count; ++i) result[i] = Slope::coordinate(at_.range(i), i);
    return result;
  }

  /// |B_jj|; anything where the leg does not reach the pose.
  std::array<Slope, leg_count> entries() const {
    std::array<Slope, leg_count> result;
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Slope& square = placed_.squared_b_entry(j);
      if (!(square.value.value > 0.0)) continue;
      result[j] = Slope(PointNumber(std::sqrt(square.value.value)));
      for (std::size_t i = 0; i < coordinate_count; ++i)
        result[j].gradient[i] = square.gradient[i].value / (2.0 * result[j].value.value);
    }
    return result;
  }

  void add_margins(const Signs& signs, Conditions& result) const {
    const auto& margins = at_.tests.margins();
    const auto add = [&result](const Slope& function) { result.add(condition(function)); };
    for (std::size_t j = 0; j < leg_count; ++j)
      margins.for_each_serial_function(j, placed_.squared_b_entry(j), add);
    if (margins.has_parallel())
      margins.for_each_parallel_function(square(legs_.determinant(signs)), legs_, signs, add);
  }

  void add_constraints(const Signs& signs, Conditions& result) const {
    const auto& tests = at_.tests;
    if (tests.none()) return;
    const auto add = [&result](const Slope& function) { result.add(condition(function)); };
    tests.for_each_workspace_function(legs_.position(), add);
    tests.for_each_hinge_function(legs_, add);
    if (tests.has_platform()) tests.for_each_clearance(legs_.anchors(), add);
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Points* points = legs_.points(j, signs[j]);
      if (points == nullptr) continue;
      tests.for_each_passive_limit(
          j, *points, legs_, [&](const LimitFunctions<Slope>& passive) { add_limits(passive, result); });
      tests.for_each_cone(j, *points, legs_, add);
      tests.for_each_clearance(j, *points, add);
      for (std::size_t k = j + 1; k < leg_count; ++k)
        if (const Points* other = legs_.points(k, signs[k]))
          tests.for_each_clearance(j, *points, k, *other, add);
    }
  }

  ChartBox<Chart> at_;
  PlacedLegs<Chart, Slope> placed_;
  EvaluatedLegs<Chart, Slope> legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_POINT_CONDITIONS_H
