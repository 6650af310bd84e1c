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
  if (is_positive(range_of(function)) == Verdict::unknown) monotonicity.require(function.gradient);
}

/// The last stage (see box_stage.h), of a box that may be reachable: partial derivatives, by affine forms.
/// With them how S(s, sigma) grows in the box, and whether it is connected; docs/theory/maps.md has the
/// proofs.
template <class Chart, class Number = double>
class BoxSlopes {
 public:
  static constexpr std::size_t leg_count = Chart::leg_count, coordinate_count = Chart::coordinate_count;
  using Forms = BoxForms<Chart, Number>;
  using Form = typename Forms::Form;
  using Range = typename Forms::Range;
  using Mask = typename Forms::Mask;
  using Slope = Dual<coordinate_count, Form>;
  using Signs = typename Forms::Signs;
  using Gradient = std::array<Interval, coordinate_count>;
  using Growth = MonotonicityIn<Number>;

  explicit BoxSlopes(const Forms& forms)
      : forms_(forms),
        placed_(at().chart, at().root, coordinates()),
        legs_(at().chart, placed_, entry_slopes()) {
    assert(!in_all(forms.reachable_nowhere()));
  }
  explicit BoxSlopes(Forms&&) = delete;
  static BoxSlopes of(const Forms& forms) {
    return outlined<Number>([&forms] { return BoxSlopes(forms); });
  }

  const Forms& forms() const noexcept { return forms_; }
  const auto& at() const noexcept { return forms_.at(); }

  /// Partial derivatives of B_jj^2.
  Gradient squared_b_entry_gradient(std::size_t j) const {
    return ranges(placed_.squared_b_entry(j).gradient);
  }

  /// Partial derivatives of det A, where all legs are clear.
  Gradient determinant_gradient(const Signs& signs) const {
    return ranges(legs_.determinant(signs).gradient);
  }

  /// How S(signs, sign) grows in the box: as { condition > 0 } does for each condition that does not hold on
  /// the whole box.
  Growth monotonicity(const Signs& signs, int sign) const {
    Growth growth = Growth::of_everything();
    for (std::size_t j = 0; j < leg_count; ++j) {
      growth.require(placed_.squared_b_entry(j).gradient, !entries().clear(j));
      restrict_by_limits(j, signs[j], growth);
    }
    if constexpr (Forms::is_of_one_box) {
      restrict_by_margins(signs, growth);
      if (!tests().none()) require_constraints(signs, growth);
    }
    const Mask known = has_sign(forms_.determinant(signs), sign);
    if (in_all(known)) return growth;
    return growth.with(Growth::of_everything().where_or(known, monotonicity_of_determinant(signs, sign)));
  }

  /// Whether all of S(signs, sign) in the box is proved to be connected, be it empty. `faces`: looks at
  /// faces, too, of one box.
  Mask is_whole(const Signs& signs, int sign, bool shells, bool faces) const {
    const Growth growth = monotonicity(signs, sign);
    Mask whole = growth.along_all(at());
    Growth of_shell = Growth::unknown();
    if (shells && !in_all(whole)) whole |= shell(signs, sign, !whole, of_shell);
    if constexpr (Forms::is_of_one_box)
      whole = whole || (faces && is_whole_on_face(growth, signs, sign, shells));
    return whole;
  }

  /// Where S(signs, sign) is a shell along the serial singularity, of the boxes that are asked for; writes
  /// how it grows. With the box oriented as that tells, growing upward along every coordinate, the lowest
  /// corner is not reachable, reachable poses are monotone upward, det A has the sign all along the serial
  /// singularity and, if at all, loses it upward. Every ray from the lowest corner then meets the set in an
  /// interval that begins at the serial singularity, if it comes to it, and the rays that do are those to the
  /// reachable poses of the upper faces, which are connected with the highest corner. So the set is
  /// connected, and empty only where the highest corner is not reachable.
  Mask shell(const Signs& signs, int sign, Mask asked, Growth& growth) const {
    asked &= !entries().all_clear();
    if (in_none(asked)) return asked;
    asked &= forms_.is_allowed_where_reached(signs).holds;
    if (in_none(asked)) return asked;
    growth = Growth::of_everything();
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Mask clear = entries().clear(j);
      if (in_all(clear)) continue;
      growth.require(placed_.squared_b_entry(j).gradient, !clear);
      asked &= clear | has_sign(determinant_without_entry(j, signs).range(), sign);
    }
    if (in_none(asked)) return asked;
    growth = growth.with(monotonicity_of_determinant(signs, -sign));
    asked &= growth.along_all(at());
    return in_none(asked) ? asked : asked & is_lowest_unreachable(growth);
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

  const auto& entries() const noexcept { return forms_.entries(); }
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
      const Form& entry = forms_.legs().entry(j);
      result[j] = Slope(entry);
      const Mask clear = entries().clear(j);
      if (in_none(clear)) continue;
      const Form factor = reciprocal(Interval(2.0) * entry, entries().value(j).lower());
      for (std::size_t i = 0; i < coordinate_count; ++i)
        result[j].gradient[i] = where(clear, factor * placed_.squared_b_entry(j).gradient[i], Form());
    }
    return result;
  }

  void restrict_by_limits(std::size_t j, int sign, Growth& growth) const {
    const Mask open = !forms_.limits(j, sign).holds, clear = entries().clear(j);
    growth = Growth::unknown().where_or(open & !clear, growth);
    if (!in_none(open & clear))
      outlined<Number>([&] { require_limits(j, sign, Mask(open & clear), growth); });
  }
  void require_limits(std::size_t j, int sign, const Mask& open, Growth& growth) const {
    const LimitFunctions<Range> values =
        at().chart.limits(j, forms_.displacement(j), entries().value(j), sign);
    const LimitFunctions<Slope> slopes =
        at().chart.limits(j, placed_.legs[j].displacement, legs_.entry(j), sign);
    for (std::size_t k = 0; k < values.count; ++k) {
      const Mask known = values.values[k].positive() | values.values[k].negative();
      growth.require(slopes.values[k].gradient, open & !known);
    }
  }

  /// Margins of det A depend on |B_jj|, whose slope is not known of legs that are not clear.
  void restrict_by_margins(const Signs& signs, Growth& growth) const {
    if (forms_.keeps_margins(signs) == Verdict::holds) return;
    for (std::size_t j = 0; j < leg_count; ++j)
      if (margins().serial(j, entries().square(j)) != Verdict::holds)
        growth.require(placed_.squared_b_entry(j).gradient);
    if (!margins().has_parallel() || forms_.keeps_parallel_margins(signs) == Verdict::holds) return;
    if (!entries().all_clear()) {
      growth = Growth::unknown();
      return;
    }
    margins().for_each_parallel_function(square(legs_.determinant(signs)), legs_, signs,
                                         [&growth](const Slope& value) { growth.require(value.gradient); });
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
  Growth monotonicity_of_determinant(const Signs& signs, int sign) const {
    return outlined<Number>([&] { return growth_of_determinant(signs, sign); });
  }
  Growth growth_of_determinant(const Signs& signs, int sign) const {
    Growth growth = Growth::of_everything();
    const Interval factor(sign);
    const Slope function = factor * legs_.determinant(signs);
    const Mask is_single = entries().single_unclear();
    growth.require(function.gradient, !is_single);
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Mask unclear = !entries().clear(j);
      if (in_none(unclear)) continue;
      const Form lever = factor * slope_along_entry(j, signs),
                 weight = Interval(2.0) * forms_.legs().entry(j);
      std::array<Form, coordinate_count> term;
      for (std::size_t i = 0; i < coordinate_count; ++i) {
        term[i] = lever * placed_.squared_b_entry(j).gradient[i];
        if (!in_none(is_single)) term[i] = where(is_single, term[i] + weight * function.gradient[i], term[i]);
      }
      growth.require(term, unclear);
    }
    return growth;
  }

  /// Where the set is monotone along some coordinates, it is connected if what it has of the face that it
  /// grows to is.
  bool is_whole_on_face(const Growth& growth, const Signs& signs, int sign, bool shells) const {
    Box face = at().box;
    if (!growth.flatten(face)) return false;
    const BoxIntervals<Chart> intervals(at().with(face));
    if (!intervals.is_indeterminate(signs, sign)) return true;
    const Forms forms(intervals);
    return !forms.is_indeterminate(signs, sign) || BoxSlopes(forms).is_whole(signs, sign, shells, true);
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
    return outlined<Number>([&] {
      typename EvaluatedLegs<Chart, Form>::Rows rows = forms_.legs().rows();
      rows[j].positive = rows[j].negative = forms_.placed().legs[j].rows.fixed;
      return Determinants<Form, leg_count>(rows).of(signs);
    });
  }

  Mask is_lowest_unreachable(const Growth& growth) const {
    std::array<Range, coordinate_count> corner;
    for (std::size_t i = 0; i < coordinate_count; ++i) {
      const Range range = at().range(i);
      const Number lowest = where(growth.upward(i), Number(range.lower()), Number(range.upper()));
      corner[i] = Range(lowest, lowest);
    }
    const PlacedLegs<Chart, Range> placed(at().chart, at().root, corner);
    Mask result{};
    for (std::size_t j = 0; j < leg_count; ++j) result |= placed.squared_b_entry(j).upper() <= 0.0;
    return result;
  }

  const Forms& forms_;
  PlacedLegs<Chart, Slope> placed_;
  EvaluatedLegs<Chart, Slope> legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_SLOPES_H
