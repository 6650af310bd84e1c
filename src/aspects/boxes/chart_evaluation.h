// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_EVALUATION_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_EVALUATION_H

#include "aspects/boxes/box_policy.h"
#include "aspects/boxes/chart_values.h"
#include "aspects/tree/monotonicity.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// What is proved of S(s, sigma) in one box of a chart, beyond its values there: how it grows, and whether it
/// is connected. See docs/maps.md for the proofs.
template <class Chart>
class ChartEvaluation : public ChartValues<Chart> {
 public:
  using Base = ChartValues<Chart>;
  using Base::Base;
  using Base::coordinate_count;
  using Base::determinant;
  using Base::leg_count;
  using typename Base::Signs;

  /// How S(signs, sign) grows in the box. Needs affine forms.
  Monotonicity monotonicity(const Signs& signs, int sign) {
    Monotonicity all = reachable_nowhere_ ? Monotonicity::unknown() : Monotonicity::of_everything();
    visit_open_conditions(signs, sign, [&all](const Monotonicity& each) { all = all.with(each); });
    return all;
  }

  /// Whether all of S(signs, sign) in the box is proved to be connected, be it empty. Needs affine forms.
  bool is_whole(const Signs& signs, int sign, Detail detail, const BoxPolicy& policy) {
    const Monotonicity here = monotonicity(signs, sign);
    return here.along_all(box_) || (policy.shells && shell(signs, sign)) ||
           (policy.faces && detail == Detail::all_parts && is_whole_on_face(here, signs, sign, policy));
  }

  /// Where S(signs, sign) is a shell along the serial singularity: with the box oriented as the result tells,
  /// growing upward along every coordinate, the lowest corner is not reachable, reachable poses are monotone
  /// upward, det A has the sign all along the serial singularity and, if at all, loses it upward. Every ray
  /// from the lowest corner then meets the set in an interval that begins at the serial singularity, if it
  /// comes to it, and the rays that do are those to the reachable poses of the upper faces, which are
  /// connected with the highest corner. So the set is connected, and empty only where the highest corner is
  /// not reachable. Needs affine forms.
  std::optional<Monotonicity> shell(const Signs& signs, int sign) {
    if (reachable_nowhere_ || clear_everywhere() || is_allowed(signs) != Verdict::holds) return std::nullopt;
    evaluate_slopes();
    Monotonicity reachable = Monotonicity::of_everything();
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (clear_[j]) continue;
      reachable.require(ranges(slopes_->legs[j].rows.squared_entry.gradient));
      const Interval at_boundary = determinant_without_entry(j, signs).range();
      if (!(sign > 0 ? at_boundary.positive() : at_boundary.negative())) return std::nullopt;
    }
    const Monotonicity both = reachable.with(monotonicity_of_determinant(signs, -sign));
    if (!both.along_all(box_) || !is_unreachable(both.lowest(box_))) return std::nullopt;
    return both;
  }

  /// With g = B_jj^2 of a leg that is not clear, F = det A as a function of the pose and of |B_jj|, and
  /// indices for partial derivatives at constant |B_jj|: F_i g_k - F_k g_i for each i. Needs affine forms.
  std::array<Interval, coordinate_count> level_slopes(const Signs& signs, std::size_t j, std::size_t k) {
    evaluate_slopes();
    const auto slope = slopes_->determinants->of(signs).gradient;
    const auto& of_entry = slopes_->legs[j].rows.squared_entry.gradient;
    std::array<Interval, coordinate_count> result;
    for (std::size_t i = 0; i < coordinate_count; ++i)
      result[i] = i == k ? Interval(0.0) : (slope[i] * of_entry[k] - slope[k] * of_entry[i]).range();
    return result;
  }

  /// See BoxClassifier::conditions. Needs affine forms.
  Conditions conditions(const Signs& signs, int sign) {
    Conditions result;
    if (reachable_nowhere_ || !clear_everywhere()) return result;
    evaluate_slopes();
    for (std::size_t j = 0; j < leg_count; ++j) {
      result.add(condition(slopes_->legs[j].rows.squared_entry));
      add_limits(chart_.limits(j, slopes_->legs[j].displacement, slopes_->entries[j], signs[j]), result);
    }
    result.add(condition(Interval(sign) * slopes_->determinants->of(signs)));
    add_constraints(signs, result);
    return result;
  }

 private:
  using Base::box_;
  using Base::chart_;
  using Base::clear_;
  using Base::clear_everywhere;
  using Base::constraint;
  using Base::constraints_;
  using Base::entries_;
  using Base::evaluate_slopes;
  using Base::forms_;
  using Base::intervals_;
  using Base::is_allowed;
  using Base::links;
  using Base::reachable_nowhere_;
  using Base::root_;
  using Base::slopes_;
  using Base::tests_;
  using typename Base::Form;
  using typename Base::Slope;

  /// Calls `take` with how { condition > 0 } grows, for each condition of S(signs, sign) that does not hold
  /// on the whole box.
  template <class Take>
  void visit_open_conditions(const Signs& signs, int sign, const Take& take) {
    if (reachable_nowhere_) return;
    evaluate_slopes();
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (!clear_[j]) take(monotone_with(slopes_->legs[j].rows.squared_entry));
      visit_open_limits(j, signs[j], take);
    }
    visit_open_constraints(signs, take);
    const Interval value = determinant(signs);
    if (!(sign > 0 ? value.positive() : value.negative())) take(monotonicity_of_determinant(signs, sign));
  }

  static Monotonicity monotone_with(const Slope& function) {
    Monotonicity monotonicity = Monotonicity::of_everything();
    monotonicity.require(ranges(function.gradient));
    return monotonicity;
  }

  template <class Take>
  void visit_open_limits(std::size_t j, int sign, const Take& take) const {
    const LimitFunctions<Interval> limits =
        chart_.limits(j, intervals_.legs[j].displacement, entries_[j], sign);
    if (verdict(limits) == Verdict::holds) return;
    if (!clear_[j]) return take(Monotonicity::unknown());
    const LimitFunctions<Slope> slopes =
        chart_.limits(j, slopes_->legs[j].displacement, slopes_->entries[j], sign);
    Monotonicity all = Monotonicity::of_everything();
    for (std::size_t k = 0; k < limits.count; ++k) {
      if (is_positive(limits.values[k]) != Verdict::unknown) continue;
      if (!limits.any) take(monotone_with(slopes.values[k]));
      all = all.with(monotone_with(slopes.values[k]));
    }
    if (limits.any) take(all);
  }

  template <class Take>
  void visit_open_constraints(const Signs& signs, const Take& take) const {
    if (tests_.none()) return;
    Monotonicity all = Monotonicity::of_everything();
    require_constraints(signs, all);
    take(all);
  }

  /// Constraints besides limits of actuated joints.
  void require_constraints(const Signs& signs, Monotonicity& monotonicity) const {
    if (tests_.none()) return;
    const auto slopes = links(*slopes_);
    if (constraint(ConstraintKind::obstacles, signs) != Verdict::holds)
      require_no_contact(signs, monotonicity);
    if (constraint(ConstraintKind::self_collision, signs) != Verdict::holds)
      require_no_collision(signs, monotonicity);
    const auto require = [&monotonicity](const Slope& f) { require_positive(f, monotonicity); };
    if (constraint(ConstraintKind::workspace, signs) != Verdict::holds)
      tests_.for_each_workspace_function(slopes.position(), require);
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (constraints_.passive_limits(j, signs[j], links(*forms_)) == Verdict::holds) continue;
      const auto* points = clear_points(j, signs, monotonicity);
      if (points == nullptr) return;
      tests_.for_each_passive_limit(j, *points, slopes.heading(), [&](const LimitFunctions<Slope>& limits) {
        for (std::size_t k = 0; k < limits.count; ++k) require(limits.values[k]);
      });
    }
  }

  /// Where the links of a leg are that reaches all over the box; else null, and monotonicity is unknown.
  const LinkPoints<Slope, Chart::point_dimension>* clear_points(std::size_t j, const Signs& signs,
                                                                Monotonicity& monotonicity) const {
    const auto* points = clear_[j] ? links(*slopes_).points(j, signs[j]) : nullptr;
    if (points == nullptr) monotonicity = Monotonicity::unknown();
    return points;
  }

  void require_no_contact(const Signs& signs, Monotonicity& monotonicity) const {
    if (tests_.has_platform()) tests_.require_no_contact(links(*slopes_).anchors(), monotonicity);
    for (std::size_t j = 0; j < leg_count; ++j)
      if (const auto* points = clear_points(j, signs, monotonicity))
        tests_.require_no_contact(j, *points, monotonicity);
  }

  void require_no_collision(const Signs& signs, Monotonicity& monotonicity) const {
    for (std::size_t j = 0; j < leg_count; ++j)
      for (std::size_t k = j + 1; k < leg_count; ++k) {
        if (!tests_.can_collide(j, k)) continue;
        const auto *one = clear_points(j, signs, monotonicity), *other = clear_points(k, signs, monotonicity);
        if (one != nullptr && other != nullptr) tests_.require_no_collision(j, *one, k, *other, monotonicity);
      }
  }

  /// How { sign det A > 0 } grows. With g = B_jj^2 of the one leg that is not clear, d = d/dx at constant
  /// |B_jj| and D = d det A / d|B_jj|, the slope of det A times 2 |B_jj| is  2 |B_jj| d(det A) + D dg.  With
  /// several such legs each term is asked to have the sign.
  Monotonicity monotonicity_of_determinant(const Signs& signs, int sign) {
    Monotonicity monotonicity = Monotonicity::of_everything();
    const Interval factor(sign);
    const Slope function = factor * slopes_->determinants->of(signs);
    const auto unclear = static_cast<std::size_t>(std::count(clear_.begin(), clear_.end(), false));
    if (unclear != 1) monotonicity.require(ranges(function.gradient));
    for (std::size_t j = 0; j < leg_count; ++j) {
      if (clear_[j]) continue;
      const Form lever = factor * slope_along_entry(j, signs), weight = Interval(2.0) * forms_->entries[j];
      std::array<Form, coordinate_count> term;
      for (std::size_t i = 0; i < coordinate_count; ++i) {
        term[i] = lever * slopes_->legs[j].rows.squared_entry.gradient[i];
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
    Box face = box_;
    if (!monotonicity.flatten(face)) return false;
    ChartEvaluation evaluation(chart_, tests_, root_, face);
    evaluation.evaluate_by_intervals();
    if (!evaluation.is_indeterminate(signs, sign)) return true;
    evaluation.evaluate_by_affine_forms();
    return !evaluation.is_indeterminate(signs, sign) ||
           evaluation.is_whole(signs, sign, Detail::all_parts, policy);
  }

  /// d det A / d|B_jj|: det A with row j turned.
  Form slope_along_entry(std::size_t j, const Signs& signs) const {
    std::array<BranchRows<Form, leg_count>, leg_count> rows = forms_->rows;
    rows[j].positive = forms_->legs[j].rows.turned;
    for (std::size_t i = 0; i < leg_count; ++i) rows[j].negative[i] = -forms_->legs[j].rows.turned[i];
    return Determinants<Form, leg_count>(rows).of(signs);
  }

  /// det A where B_jj = 0.
  Form determinant_without_entry(std::size_t j, const Signs& signs) const {
    std::array<BranchRows<Form, leg_count>, leg_count> rows = forms_->rows;
    rows[j].positive = rows[j].negative = forms_->legs[j].rows.fixed;
    return Determinants<Form, leg_count>(rows).of(signs);
  }

  bool is_unreachable(const MapPoint& point) const {
    const Box box{coordinate_count, point, point};
    ChartEvaluation evaluation(chart_, tests_, root_, box);
    evaluation.evaluate_by_intervals();
    return evaluation.reachable_nowhere_;
  }

  void add_constraints(const Signs& signs, Conditions& result) {
    if (tests_.none()) return;
    const auto at = links(*slopes_);
    const auto add = [&result](const Slope& function) { result.add(condition(function)); };
    tests_.for_each_workspace_function(at.position(), add);
    if (tests_.has_platform()) tests_.for_each_clearance(at.anchors(), add);
    for (std::size_t j = 0; j < leg_count; ++j) {
      const auto* points = at.points(j, signs[j]);
      if (points == nullptr) continue;
      tests_.for_each_passive_limit(j, *points, at.heading(),
                                    [&](const LimitFunctions<Slope>& limits) { add_limits(limits, result); });
      tests_.for_each_clearance(j, *points, add);
      for (std::size_t k = j + 1; k < leg_count; ++k)
        if (const auto* other = at.points(k, signs[k])) tests_.for_each_clearance(j, *points, k, *other, add);
    }
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_CHART_EVALUATION_H
