// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_SLOPES_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_SLOPES_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/box_forms.h"
#include "aspects/tree/monotonicity.h"
#include "interval/dual.h"
#include "interval/scalar_range.h"
#include "legs/limit_verdict.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

template <std::size_t N, class Value>
std::array<Interval, N> ranges(const std::array<Value, N>& values) {
  std::array<Interval, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = range_of(values[i]);
  return result;
}

/// Leaves the directions in which the poses grow where the function is positive.
template <std::size_t N, class Value>
void require_positive(const Dual<N, Value>& function, Monotonicity& monotonicity) {
  if (is_positive(range_of(function)) == Verdict::unknown) monotonicity.require(ranges(function.gradient));
}

/// The last stage (see box_stage.h), of a box that may be reachable: partial derivatives, by affine forms.
/// With them how S(s, sigma) grows in the box, and whether it is connected; docs/theory/maps.md has the
/// proofs.
template <class Chart>
class BoxSlopes {
 public:
  static constexpr std::size_t leg_count = Chart::leg_count, coordinate_count = Chart::coordinate_count;
  using Forms = BoxForms<Chart>;
  using Form = typename Forms::Form;
  using Slope = Dual<coordinate_count, Form>;
  using Signs = typename Forms::Signs;
  using Gradient = std::array<Interval, coordinate_count>;

  explicit BoxSlopes(const Forms& forms)
      : forms_(forms),
        placed_(at().chart, at().root, coordinates()),
        legs_(at().chart, placed_, entry_slopes()) {
    assert(!forms.reachable_nowhere());
  }
  explicit BoxSlopes(Forms&&) = delete;

  const Forms& forms() const noexcept { return forms_; }
  const ChartBox<Chart>& at() const noexcept { return forms_.at(); }

  /// Partial derivatives of B_jj^2.
  Gradient squared_b_entry_gradient(std::size_t j) const {
    return ranges(placed_.squared_b_entry(j).gradient);
  }

  /// Partial derivatives of det A, where all legs are clear.
  Gradient determinant_gradient(const Signs& signs) const {
    return ranges(legs_.determinant(signs).gradient);
  }

  /// How S(signs, sign) grows in the box.
  Monotonicity monotonicity(const Signs& signs, int sign) const {
    Monotonicity all = Monotonicity::of_everything();
    visit_open_conditions(signs, sign, [&all](const Monotonicity& each) { all = all.with(each); });
    return all;
  }

  /// Whether all of S(signs, sign) in the box is proved to be connected, be it empty.
  bool is_whole(const Signs& signs, int sign, Detail detail, const BoxPolicy& policy) const {
    const Monotonicity here = monotonicity(signs, sign);
    return here.along_all(at().box) || (policy.shells && shell(signs, sign)) ||
           (policy.faces && detail == Detail::all_parts && is_whole_on_face(here, signs, sign, policy));
  }

  /// Where S(signs, sign) is a shell along the serial singularity: with the box oriented as the result tells,
  /// growing upward along every coordinate, the lowest corner is not reachable, reachable poses are monotone
  /// upward, det A has the sign all along the serial singularity and, if at all, loses it upward. Every ray
  /// from the lowest corner then meets the set in an interval that begins at the serial singularity, if it
  /// comes to it, and the rays that do are those to the reachable poses of the upper faces, which are
  /// connected with the highest corner. So the set is connected, and empty only where the highest corner is
  /// not reachable.
  std::optional<Monotonicity> shell(const Signs& signs, int sign) const {
    if (entries().all_clear() || forms_.is_allowed(signs) != Verdict::holds) return std::nullopt;
    Monotonicity reachable = Monotonicity::of_everything();
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (entries().clear(j)) continue;
      reachable.require(squared_b_entry_gradient(j));
      const Interval at_boundary = determinant_without_entry(j, signs).range();
      if (!(sign > 0 ? at_boundary.positive() : at_boundary.negative())) return std::nullopt;
    }
    const Monotonicity both = reachable.with(monotonicity_of_determinant(signs, -sign));
    if (!both.along_all(at().box) || !is_unreachable(both.lowest(at().box))) return std::nullopt;
    return both;
  }

  /// With g = B_jj^2 of a leg that is not clear, F = det A as a function of the pose and of |B_jj|, and
  /// indices for partial derivatives at constant |B_jj|: F_i g_k - F_k g_i for each i.
  Gradient level_slopes(const Signs& signs, std::size_t j, std::size_t k) const {
    const auto slope = legs_.determinant(signs).gradient;
    const auto& of_entry = placed_.squared_b_entry(j).gradient;
    Gradient result;
    for (std::size_t i = 0; i < coordinate_count; ++i)
      result[i] = i == k ? Interval(0.0) : (slope[i] * of_entry[k] - slope[k] * of_entry[i]).range();
    return result;
  }

 private:
  using Points = typename EvaluatedLegs<Chart, Slope>::Links;

  const BoxEntries<leg_count>& entries() const noexcept { return forms_.entries(); }
  const auto& tests() const noexcept { return at().tests; }
  const auto& margins() const noexcept { return tests().margins(); }

  std::array<Slope, coordinate_count> coordinates() const {
    const std::array<Form, coordinate_count> forms = Forms::coordinates(at());
    std::array<Slope, coordinate_count> result;
    for (std::size_t i = 0; i < coordinate_count; ++i) result[i] = Slope::coordinate(forms[i], i);
    return result;
  }

  // d|B_jj| = d(B_jj^2) / (2 |B_jj|). A leg that is not clear has none: |B_jj| is taken as one more variable.
  std::array<Slope, leg_count> entry_slopes() const {
    std::array<Slope, leg_count> result;
    for (std::size_t j = 0; j < leg_count; ++j) {
      result[j] = Slope(forms_.legs().entry(j));
      if (!entries().clear(j)) continue;
      const Form factor = reciprocal(Interval(2.0) * forms_.legs().entry(j), entries().value(j).lower());
      for (std::size_t i = 0; i < coordinate_count; ++i)
        result[j].gradient[i] = factor * placed_.squared_b_entry(j).gradient[i];
    }
    return result;
  }

  LimitFunctions<Slope> limits(std::size_t j, int sign) const {
    return at().chart.limits(j, placed_.legs[j].displacement, legs_.entry(j), sign);
  }

  /// Calls `take` with how { condition > 0 } grows, for each condition of S(signs, sign) that does not hold
  /// on the whole box.
  template <class Take>
  void visit_open_conditions(const Signs& signs, int sign, const Take& take) const {
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (!entries().clear(j)) take(monotone_with(placed_.squared_b_entry(j)));
      visit_open_limits(j, signs[j], take);
    }
    visit_open_margins(signs, take);
    visit_open_constraints(signs, take);
    const Interval value = forms_.determinant(signs);
    if (!(sign > 0 ? value.positive() : value.negative())) take(monotonicity_of_determinant(signs, sign));
  }

  static Monotonicity monotone_with(const Slope& function) {
    Monotonicity monotonicity = Monotonicity::of_everything();
    monotonicity.require(ranges(function.gradient));
    return monotonicity;
  }

  template <class Take>
  void visit_open_limits(std::size_t j, int sign, const Take& take) const {
    const LimitFunctions<Interval> values =
        at().chart.limits(j, forms_.displacement(j), entries().value(j), sign);
    if (verdict(values) == Verdict::holds) return;
    if (!entries().clear(j)) return take(Monotonicity::unknown());
    const LimitFunctions<Slope> slopes = limits(j, sign);
    Monotonicity all = Monotonicity::of_everything();
    for (std::size_t k = 0; k < values.count; ++k) {
      if (is_positive(values.values[k]) != Verdict::unknown) continue;
      if (!values.any) take(monotone_with(slopes.values[k]));
      all = all.with(monotone_with(slopes.values[k]));
    }
    if (values.any) take(all);
  }

  /// Margins of det A depend on |B_jj|, whose slope is not known of legs that are not clear.
  template <class Take>
  void visit_open_margins(const Signs& signs, const Take& take) const {
    if (forms_.keeps_margins(signs) == Verdict::holds) return;
    for (std::size_t j = 0; j < leg_count; ++j)
      if (margins().serial(j, entries().square(j)) != Verdict::holds)
        take(monotone_with(placed_.squared_b_entry(j)));
    if (!margins().has_parallel() || forms_.keeps_parallel_margins(signs) == Verdict::holds) return;
    if (!entries().all_clear()) return take(Monotonicity::unknown());
    margins().for_each_parallel_function(square(legs_.determinant(signs)), legs_, signs,
                                         [&take](const Slope& value) { take(monotone_with(value)); });
  }

  template <class Take>
  void visit_open_constraints(const Signs& signs, const Take& take) const {
    if (tests().none()) return;
    Monotonicity all = Monotonicity::of_everything();
    require_constraints(signs, all);
    take(all);
  }

  /// Constraints besides limits of actuated joints.
  void require_constraints(const Signs& signs, Monotonicity& monotonicity) const {
    if (forms_.constraint(ConstraintKind::obstacles, signs) != Verdict::holds)
      require_no_contact(signs, monotonicity);
    if (forms_.constraint(ConstraintKind::self_collision, signs) != Verdict::holds)
      require_no_collision(signs, monotonicity);
    const auto require = [&monotonicity](const Slope& f) { require_positive(f, monotonicity); };
    if (forms_.constraint(ConstraintKind::workspace, signs) != Verdict::holds)
      tests().for_each_workspace_function(legs_.position(), require);
    if (forms_.constraints().hinge_limits(forms_.legs()) != Verdict::holds)
      tests().for_each_hinge_function(legs_, require);
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (both(forms_.constraints().passive_limits(j, signs[j], forms_.legs()),
               forms_.constraints().cones(j, signs[j], forms_.legs())) == Verdict::holds)
        continue;
      const Points* points = clear_points(j, signs, monotonicity);
      if (points == nullptr) return;
      tests().for_each_passive_limit(j, *points, legs_, [&](const LimitFunctions<Slope>& passive) {
        for (std::size_t k = 0; k < passive.count; ++k) require(passive.values[k]);
      });
      tests().for_each_cone(j, *points, legs_, require);
    }
  }

  /// Where the links of a leg are that reaches all over the box; else null, and monotonicity is unknown.
  const Points* clear_points(std::size_t j, const Signs& signs, Monotonicity& monotonicity) const {
    const Points* points = entries().clear(j) ? legs_.points(j, signs[j]) : nullptr;
    if (points == nullptr) monotonicity = Monotonicity::unknown();
    return points;
  }

  void require_no_contact(const Signs& signs, Monotonicity& monotonicity) const {
    if (tests().has_platform()) tests().require_no_contact(legs_.anchors(), monotonicity);
    for (std::size_t j = 0; j < leg_count; ++j)
      if (const Points* points = clear_points(j, signs, monotonicity))
        tests().require_no_contact(j, *points, monotonicity);
  }

  void require_no_collision(const Signs& signs, Monotonicity& monotonicity) const {
    for (std::size_t j = 0; j < leg_count; ++j)
      for (std::size_t k = j + 1; k < leg_count; ++k) {
        if (!tests().can_collide(j, k)) continue;
        const Points *one = clear_points(j, signs, monotonicity),
                     *other = clear_points(k, signs, monotonicity);
        if (one != nullptr && other != nullptr)
          tests().require_no_collision(j, *one, k, *other, monotonicity);
      }
  }

  /// How { sign det A > 0 } grows. With g = B_jj^2 of the one leg that is not clear, d = d/dx at constant
  /// |B_jj| and D = d det A / d|B_jj|, the slope of det A times 2 |B_jj| is  2 |B_jj| d(det A) + D dg.  With
  /// several such legs each term is asked to have the sign.
  Monotonicity monotonicity_of_determinant(const Signs& signs, int sign) const {
    Monotonicity monotonicity = Monotonicity::of_everything();
    const Interval factor(sign);
    const Slope function = factor * legs_.determinant(signs);
    const std::size_t unclear = entries().unclear_count();
    if (unclear != 1) monotonicity.require(ranges(function.gradient));
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (entries().clear(j)) continue;
      const Form lever = factor * slope_along_entry(j, signs),
                 weight = Interval(2.0) * forms_.legs().entry(j);
      std::array<Form, coordinate_count> term;
      for (std::size_t i = 0; i < coordinate_count; ++i) {
        term[i] = lever * placed_.squared_b_entry(j).gradient[i];
        if (unclear == 1) term[i] += weight * function.gradient[i];
      }
      monotonicity.require(ranges(term));
    }
    return monotonicity;
  }

  /// Where the set is monotone along some coordinates, it is connected if what it has of the face that it
  /// grows to is.
  bool is_whole_on_face(const Monotonicity& monotonicity, const Signs& signs, int sign,
                        const BoxPolicy& policy) const {
    Box face = at().box;
    if (!monotonicity.flatten(face)) return false;
    const BoxIntervals<Chart> intervals(at().with(face));
    if (!intervals.is_indeterminate(signs, sign)) return true;
    const Forms forms(intervals);
    return !forms.is_indeterminate(signs, sign) ||
           BoxSlopes(forms).is_whole(signs, sign, Detail::all_parts, policy);
  }

  /// d det A / d|B_jj|: det A with row j turned.
  Form slope_along_entry(std::size_t j, const Signs& signs) const {
    typename EvaluatedLegs<Chart, Form>::Rows rows = forms_.legs().rows();
    rows[j].positive = forms_.placed().legs[j].rows.turned;
    for (std::size_t i = 0; i < leg_count; ++i) rows[j].negative[i] = -rows[j].positive[i];
    return Determinants<Form, leg_count>(rows).of(signs);
  }

  /// det A where B_jj = 0.
  Form determinant_without_entry(std::size_t j, const Signs& signs) const {
    typename EvaluatedLegs<Chart, Form>::Rows rows = forms_.legs().rows();
    rows[j].positive = rows[j].negative = forms_.placed().legs[j].rows.fixed;
    return Determinants<Form, leg_count>(rows).of(signs);
  }

  bool is_unreachable(const MapPoint& point) const {
    const Box box{coordinate_count, point, point};
    return BoxIntervals<Chart>(at().with(box)).reachable_nowhere();
  }

  const Forms& forms_;
  PlacedLegs<Chart, Slope> placed_;
  EvaluatedLegs<Chart, Slope> legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_SLOPES_H
