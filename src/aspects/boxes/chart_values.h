// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_VALUES_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_VALUES_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/evaluated_legs.h"
#include "aspects/boxes/preconditioned_sign.h"
#include "aspects/boxes/slope_functions.h"
#include "aspects/constraints/constraint_tests.h"
#include "aspects/constraints/constraint_verdicts.h"
#include "aspects/tree/leaf_state.h"
#include "aspects/tree/pose_space.h"
#include "interval/affine.h"
#include "interval/dual.h"
#include "legs/leg_rows.h"
#include "legs/limit_verdict.h"
#include "parallel_aspects/aspects/box.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// Values over one box of a chart (see charts.h): B_jj^2, det A and the constraints, enclosed by intervals
/// first and then, much tighter in small boxes, by affine forms; their slopes too. A leg is *clear* where
/// B_jj^2 is positive on the whole box. Where it is not, its row of A is taken as a function of the pose and
/// of |B_jj|, for |B_jj| has no slope at zero.
template <class Chart>
class ChartValues {
 public:
  static constexpr std::size_t leg_count = Chart::leg_count, coordinate_count = Chart::coordinate_count;
  using Signs = std::array<int, leg_count>;
  using Tests = ConstraintTests<Chart::point_dimension>;

  ChartValues(const Chart& chart, const Tests& tests, RootIndex root, const Box& box)
      : chart_(chart), tests_(tests), root_(root), box_(box), constraints_(tests) {
    assert_rounding_upward();
  }

  /// To be looked at only where B_jj^2 of this leg, if it vanishes in the box, is at most `most`.
  void bound_squared_entry(std::size_t j, double most) noexcept {
    bounded_leg_ = j;
    most_squared_entry_ = most;
  }

  const Box& box() const noexcept { return box_; }
  const Tests& tests() const noexcept { return tests_; }

  void evaluate_by_intervals() {
    std::array<Interval, coordinate_count> position;
    for (std::size_t i = 0; i < coordinate_count; ++i) position[i] = range(i);
    intervals_.place(chart_, root_, position);
    for (std::size_t j = 0; j < leg_count; ++j) squared_entries_[j] = intervals_.legs[j].rows.squared_entry;
    find_entries();
    if (reachable_nowhere_) return;
    for (std::size_t j = 0; j < leg_count; ++j) intervals_.entries[j] = entries_[j];
    intervals_.combine();
  }

  /// Needs the intervals.
  void evaluate_by_affine_forms() {
    std::array<Form, coordinate_count> position;
    for (std::size_t i = 0; i < coordinate_count; ++i) position[i] = Form::coordinate(range(i), i);
    forms_.emplace();
    forms_->place(chart_, root_, position);
    constraints_.expect_tighter();
    for (std::size_t j = 0; j < leg_count; ++j)
      squared_entries_[j] = intersection(squared_entries_[j], forms_->legs[j].rows.squared_entry.range());
    find_entries();
    if (reachable_nowhere_) return;
    for (std::size_t j = 0; j < leg_count; ++j)
      forms_->entries[j] = clear_[j]
                               ? square_root(forms_->legs[j].rows.squared_entry, squared_entries_[j].lower())
                               : Form(entries_[j]);
    forms_->combine();
  }

  /// Both; false where no pose of the box is reachable.
  bool evaluate_by_both() {
    evaluate_by_intervals();
    if (!reachable_nowhere_) evaluate_by_affine_forms();
    return !reachable_nowhere_;
  }

  LeafState state(const Signs& signs) {
    if (reachable_nowhere_) return LeafState::outside();
    const Verdict allowed = is_allowed(signs);
    if (allowed == Verdict::fails) return LeafState::outside();
    const Interval value = determinant(signs);
    const int sign = determinant_sign(value, signs);
    if (sign != 0 && allowed == Verdict::holds && clear_everywhere()) return LeafState::inside(sign);
    if (sign != 0) return LeafState::undecided(sign > 0, sign < 0);
    return LeafState::undecided(value.upper() > 0.0, value.lower() < 0.0);
  }

  /// Needs affine forms.
  BoxFacts facts(const Signs& signs) {
    BoxFacts facts;
    for (std::size_t j = 0; j < leg_count; ++j) {
      facts.legs |= BoxFacts::bit(j);
      if (clear_[j]) facts.clear |= BoxFacts::bit(j);
      if (squared_entries_[j].upper() <= 0.0) facts.unreachable |= BoxFacts::bit(j);
    }
    if (reachable_nowhere_) return facts;
    facts.within_limits = is_allowed(signs) == Verdict::holds;
    const Interval value = determinant(signs);
    facts.determinant_sign = determinant_sign(value, signs);
    if (facts.determinant_sign != 0 || !clear_everywhere()) return facts;
    evaluate_slopes();
    const auto slope = ranges(slopes_->determinants->of(signs).gradient);
    std::copy(slope.begin(), slope.end(), facts.determinant_slope.begin());
    return facts;
  }

  /// The constraints, limits of actuated joints among them, that are neither proved to hold in all of the box
  /// nor to fail in all of it.
  ConstraintKinds unknown_constraints(const Signs& signs) {
    ConstraintKinds kinds;
    if (reachable_nowhere_) return kinds;
    for (const ConstraintKind kind : all_constraint_kinds)
      kinds[index_of(kind)] = constraint(kind, signs) == Verdict::unknown;
    return kinds;
  }

  /// Enclosure of B_jj^2, and of its value at the center. Needs affine forms.
  const Interval& squared_entry(std::size_t j) const noexcept { return squared_entries_[j]; }
  Interval squared_entry_at_center(std::size_t j) const {
    return forms_->legs[j].rows.squared_entry.at_center();
  }

  /// Partial derivatives of B_jj^2. Needs affine forms.
  std::array<Interval, coordinate_count> entry_slopes(std::size_t j) {
    evaluate_slopes();
    return ranges(slopes_->legs[j].rows.squared_entry.gradient);
  }

  /// Whether all legs but j are clear, and all constraints hold on the whole box.
  bool holds_but_for(std::size_t j, const Signs& signs) const {
    for (std::size_t i = 0; i < leg_count; ++i)
      if (i != j && !clear_[i]) return false;
    return !reachable_nowhere_ && is_allowed(signs) == Verdict::holds;
  }

  /// The only leg that is not clear, where all else but the sign of det A is proved.
  std::optional<std::size_t> single_unclear_leg(const Signs& signs) const {
    const auto found = std::find(clear_.begin(), clear_.end(), false);
    const auto j = static_cast<std::size_t>(found - clear_.begin());
    if (j == leg_count || !holds_but_for(j, signs)) return std::nullopt;
    return j;
  }

  Interval determinant(const Signs& signs) {
    const Interval natural = intervals_.determinants->of(signs);
    if (!forms_ || natural.positive() || natural.negative()) return natural;
    return intersection(natural, forms_->determinants->of(signs).range());
  }

  /// The sign of det A at the center, where it is proved and the center is reachable and allowed by the
  /// constraints; else 0. Needs affine forms.
  int center_sign(const Signs& signs) {
    if (reachable_nowhere_ || !center_is_reachable(signs) || !center_is_allowed(signs)) return 0;
    const Interval value = forms_->determinants->of(signs).at_center();
    return value.positive() ? 1 : value.negative() ? -1 : 0;
  }

 protected:
  using Form = Affine<coordinate_count>;
  using Slope = Dual<coordinate_count, Form>;

  template <class Scalar>
  EvaluatedLinks<Chart, Scalar> links(const EvaluatedLegs<Chart, Scalar>& legs) const {
    return {chart_, legs};
  }

  void find_entries() {
    for (std::size_t j = 0; j < leg_count; ++j) {
      clear_[j] = squared_entries_[j].positive();
      reachable_nowhere_ = reachable_nowhere_ || squared_entries_[j].upper() <= 0.0;
      if (!reachable_nowhere_) entries_[j] = square_root(squared_entry_looked_at(j));
    }
  }

  Interval squared_entry_looked_at(std::size_t j) const {
    const Interval all = not_negative_part(squared_entries_[j]);
    if (j != bounded_leg_ || clear_[j]) return all;
    return {all.lower(), std::min(all.upper(), most_squared_entry_)};
  }

  void evaluate_slopes() {
    if (slopes_) return;
    slopes_.emplace();
    std::array<Slope, coordinate_count> position;
    for (std::size_t i = 0; i < coordinate_count; ++i)
      position[i] = Slope::coordinate(Form::coordinate(range(i), i), i);
    slopes_->place(chart_, root_, position);
    for (std::size_t j = 0; j < leg_count; ++j) {
      slopes_->entries[j] = Slope(forms_->entries[j]);
      if (!clear_[j]) continue;
      const Form factor = reciprocal(Interval(2.0) * forms_->entries[j], entries_[j].lower());
      for (std::size_t i = 0; i < coordinate_count; ++i)
        slopes_->entries[j].gradient[i] = factor * slopes_->legs[j].rows.squared_entry.gradient[i];
    }
    slopes_->combine();
  }

  bool clear_everywhere() const {
    return std::all_of(clear_.begin(), clear_.end(), [](bool clear) { return clear; });
  }

  /// Of det A on the whole box, whose range is known to be in `value`; 0 where it is not proved. Matrices of
  /// six rows are worth the inverse of one.
  int determinant_sign(const Interval& value, const Signs& signs) const {
    if (value.positive() || value.negative()) return value.positive() ? 1 : -1;
    if constexpr (leg_count == max_legs) {
      if (!forms_) return 0;
      typename PreconditionedSign<leg_count, coordinate_count>::Rows rows;
      for (std::size_t j = 0; j < leg_count; ++j) rows[j] = &forms_->rows[j].of(signs[j]);
      return PreconditionedSign<leg_count, coordinate_count>::of(rows);
    }
    return 0;
  }

  Verdict within_limits(const Signs& signs) const {
    Verdict all = Verdict::holds;
    for (std::size_t j = 0; j < leg_count && all != Verdict::fails; ++j)
      all = both(all, verdict(chart_.limits(j, intervals_.legs[j].displacement, entries_[j], signs[j])));
    return all;
  }

  Verdict constraint(ConstraintKind kind, const Signs& signs) const {
    if (kind == ConstraintKind::actuated_limits) return within_limits(signs);
    if (tests_.none()) return Verdict::holds;
    return forms_ ? constraints_.of(kind, signs, links(*forms_))
                  : constraints_.of(kind, signs, links(intervals_));
  }

  /// By limits and all other constraints.
  Verdict is_allowed(const Signs& signs) const {
    const Verdict limits = within_limits(signs);
    if (tests_.none() || limits == Verdict::fails) return limits;
    return both(limits, forms_ ? constraints_.all(signs, links(*forms_))
                               : constraints_.all(signs, links(intervals_)));
  }

  Interval range(std::size_t i) const { return {box_.lower[i], box_.upper[i]}; }

  bool is_indeterminate(const Signs& signs, int sign) {
    const LeafState found = state(signs);
    return found.may_be(sign) && !found.is_inside();
  }

  /// By the constraints besides limits of actuated joints.
  bool center_is_allowed(const Signs& signs) {
    if (tests_.none() || constraints_.all(signs, links(*forms_)) == Verdict::holds) return true;
    const Box center{coordinate_count, box_.middle(), box_.middle()};
    ChartValues evaluation(chart_, tests_, root_, center);
    evaluation.evaluate_by_intervals();
    return !evaluation.reachable_nowhere_ && evaluation.is_allowed(signs) == Verdict::holds;
  }

  bool center_is_reachable(const Signs& signs) const {
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Interval squared_entry = forms_->legs[j].rows.squared_entry.at_center();
      if (!squared_entry.positive()) return false;
      const Form entry(square_root(squared_entry));
      const LimitFunctions<Form> limits = chart_.limits(j, forms_->legs[j].displacement, entry, signs[j]);
      LimitFunctions<Interval> at_center{{}, limits.count, limits.any};
      for (std::size_t k = 0; k < limits.count; ++k) at_center.values[k] = limits.values[k].at_center();
      if (verdict(at_center) != Verdict::holds) return false;
    }
    return true;
  }

  const Chart& chart_;
  const Tests& tests_;
  RootIndex root_;
  const Box& box_;
  std::array<Interval, leg_count> squared_entries_, entries_;  // B_jj^2 and |B_jj|, from the best enclosures
  std::array<bool, leg_count> clear_{};
  bool reachable_nowhere_ = false;
  std::size_t bounded_leg_ = leg_count;
  double most_squared_entry_ = 0.0;
  mutable ConstraintVerdicts<leg_count, Chart::point_dimension> constraints_;
  EvaluatedLegs<Chart, Interval> intervals_;
  std::optional<EvaluatedLegs<Chart, Form>> forms_;  // made where they are needed: they are large
  std::optional<EvaluatedLegs<Chart, Slope>> slopes_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_VALUES_H
