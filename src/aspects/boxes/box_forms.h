// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_FORMS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_FORMS_H

#include "aspects/boxes/box_intervals.h"
#include "aspects/boxes/box_stage.h"
#include "aspects/boxes/evaluated_legs.h"
#include "interval/affine.h"
#include "interval/near_identity.h"
#include "interval/nonsingular.h"
#include "interval/scalar_range.h"
#include "legs/leg_rows.h"
#include "legs/limit_verdict.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace parallel_aspects {

/// The sign of the determinant of a matrix of affine forms over a box; 0 where it is not proved. With C an
/// approximate inverse of the matrix A_0 of centers, A C is near the identity, so that every matrix between
/// is nonsingular and has the sign of A_0 (see `NearIdentity`). Where rows are close to dependent this is
/// much tighter than an affine form of the determinant. Needs a live `RoundingUpward`.
template <std::size_t Size, std::size_t Coordinates>
class PreconditionedSign {
 public:
  using Form = Affine<Coordinates>;
  using Rows = std::array<const Row<Form, Size>*, Size>;

  static int of(const Rows& rows) {
    NearIdentity<order> product(of_entries(rows, [](const Form& entry) { return entry.center(); }));
    product.add_error(of_entries(rows, [](const Form& entry) { return entry.error(); }));
    for (std::size_t i = 0; i < Coordinates; ++i)
      product.add_slope(of_entries(rows, [i](const Form& entry) { return entry.slope(i); }));
    double ratio = 0.0;
    if (!product.is_nonsingular(max_iterations, ratio)) return 0;
    SquareArray<Interval> centers;
    for (std::size_t i = 0; i < Size; ++i)
      for (std::size_t k = 0; k < Size; ++k) centers[i][k] = Interval((*rows[i])[k].center());
    return proved_determinant_sign(Size, centers);
  }

 private:
  static constexpr int order = static_cast<int>(Size);
  static constexpr int max_iterations = 4;
  using Matrix = Eigen::Matrix<double, order, order>;

  template <class Function>
  static Matrix of_entries(const Rows& rows, const Function& function) {
    Matrix result;
    for (std::size_t i = 0; i < Size; ++i)
      for (std::size_t k = 0; k < Size; ++k)
        result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = function((*rows[i])[k]);
    return result;
  }
};

/// The second stage (see box_stage.h): a box by affine forms, and by its intervals where these are tighter.
template <class Chart, class Number = double>
class BoxForms : public BoxStage<Chart, Number, BoxForms<Chart, Number>> {
 public:
  using Stage = BoxStage<Chart, Number, BoxForms<Chart, Number>>;
  using Stage::coordinate_count;
  using Stage::is_allowed;
  using Stage::leg_count;
  using Stage::reachable_nowhere;
  using typename Stage::Bits;
  using typename Stage::Mask;
  using typename Stage::Range;
  using typename Stage::Signs;
  using Form = Affine<coordinate_count, Number>;
  using Intervals = BoxIntervals<Chart, Number>;
  using At = typename Intervals::At;
  using Entries = typename Intervals::Entries;
  using Constraints = typename Intervals::Constraints;

  explicit BoxForms(const Intervals& intervals)
      : intervals_(intervals),
        placed_(at().chart, at().root, coordinates(at())),
        entries_(intervals.entries().with(squares_of(placed_))),
        constraints_(intervals.constraints()) {
    constraints_.expect_tighter();
    if (!in_all(reachable_nowhere())) legs_.emplace(at().chart, placed_, entry_forms());
  }
  explicit BoxForms(Intervals&&) = delete;
  static BoxForms of(const Intervals& intervals) {
    return outlined<Number>([&intervals] { return BoxForms(intervals); });
  }

  static std::array<Form, coordinate_count> coordinates(const At& at) {
    std::array<Form, coordinate_count> result;
    for (std::size_t i = 0; i < coordinate_count; ++i) result[i] = Form::coordinate(at.range(i), i);
    return result;
  }

  const At& at() const noexcept { return intervals_.at(); }
  const Entries& entries() const noexcept { return entries_; }
  const auto& displacement(std::size_t j) const noexcept { return intervals_.displacement(j); }
  Constraints& constraints() const noexcept { return constraints_; }
  const PlacedLegs<Chart, Form>& placed() const noexcept { return placed_; }
  const EvaluatedLegs<Chart, Form>& legs() const noexcept { return *legs_; }

  Range determinant(const Signs& signs) const {
    const Range natural = intervals_.determinant(signs);
    const Mask is_known = natural.positive() | natural.negative();
    if (in_all(is_known)) return natural;
    return where(is_known, natural, intersection(natural, legs_->determinant(signs).range()));
  }

  Verdict parallel_margins_by_squares(const Signs& signs) const {
    const auto& margins = at().tests.margins();
    const Verdict apart = margins.parallel(square(determinant(signs)), *legs_, signs);
    if (apart != Verdict::unknown) return apart;
    Verdict together = Verdict::holds;
    margins.for_each_parallel_function(
        square(legs_->determinant(signs)), *legs_, signs,
        [&together](const Form& value) { together = both(together, is_positive(value.range())); });
    return together;
  }

  /// See BoxIntervals, which know more where squares are not positive.
  Range index(ParallelIndex kind, const Signs& signs, int sign) const {
    const Range all = Interval(0.0, std::numeric_limits<double>::infinity());
    const Form squares = at().tests.margins().index_squares(kind, *legs_, signs);
    const Number least = squares.range().lower();
    if (in_none(least > 0.0)) return all;
    const Form norms = square_root(squares, least),
               over_norms = reciprocal(norms, Number(square_root(Range(least, least)).lower()));
    return where(least > 0.0, of_sign((legs_->determinant(signs) * over_norms).range(), sign), all);
  }

  /// Of det A on the whole box, whose range is known to be in `determinant`. Matrices of six rows are worth
  /// the inverse of one.
  ProvedSign<Mask> proved_sign(const Range& determinant, const Signs& signs) const {
    const ProvedSign<Mask> found = intervals_.proved_sign(determinant, signs);
    if constexpr (leg_count == max_legs) {
      if (found.positive || found.negative) return found;
      typename PreconditionedSign<leg_count, coordinate_count>::Rows rows;
      for (std::size_t j = 0; j < leg_count; ++j) rows[j] = &legs_->rows()[j].of(signs[j]);
      const int sign = PreconditionedSign<leg_count, coordinate_count>::of(rows);
      return {sign > 0, sign < 0};
    }
    return found;
  }

  Range squared_b_entry_at_center(std::size_t j) const { return placed_.squared_b_entry(j).at_center(); }

  /// Whether all legs but j are clear, and all constraints hold on the whole box.
  bool holds_but_for(std::size_t j, const Signs& signs) const {
    return !reachable_nowhere() && entries_.all_clear_but(j) && is_allowed(signs) == Verdict::holds;
  }

  /// The only leg that is not clear, where all else but the sign of det A is proved.
  std::optional<std::size_t> single_unclear_leg(const Signs& signs) const {
    const std::optional<std::size_t> leg = entries_.first_unclear();
    return leg && holds_but_for(*leg, signs) ? leg : std::nullopt;
  }

  Verdict constraint(ConstraintKind kind, const Signs& signs) const {
    if (kind == ConstraintKind::actuated_limits) return this->within_limits(signs);
    if (kind == ConstraintKind::margins) return this->keeps_margins(signs);
    return at().tests.none() ? Verdict::holds : constraints_.of(kind, signs, *legs_);
  }

  /// The constraints, limits of actuated joints among them, that are neither proved to hold in all of the box
  /// nor to fail in all of it.
  ConstraintKinds unknown_constraints(const Signs& signs) const {
    ConstraintKinds kinds;
    if (reachable_nowhere()) return kinds;
    for (const ConstraintKind kind : all_constraint_kinds)
      kinds[index_of(kind)] = constraint(kind, signs) == Verdict::unknown;
    return kinds;
  }

  /// The signs of det A at the centers (see box_states.h), where they are proved and the center is reachable
  /// and allowed by the constraints.
  Bits centers(const Signs& signs) const {
    Mask passes = !reachable_nowhere();
    for (std::size_t j = 0; j < leg_count && !in_none(passes); ++j)
      passes &= center_is_reachable(j, signs[j]);
    if constexpr (Stage::is_of_one_box) passes = passes && center_is_allowed(signs);
    if (in_none(passes)) return Bits{};
    const Range value = legs_->determinant(signs).at_center();
    return bits_where(passes & value.positive(), state_bits::center_positive) |
           bits_where(passes & value.negative(), state_bits::center_negative);
  }

 private:
  // The root has no slope at zero: |B_jj| of a leg that is not clear stays an interval.
  std::array<Form, leg_count> entry_forms() const {
    std::array<Form, leg_count> result;
    for (std::size_t j = 0; j < leg_count; ++j) {
      result[j] = Form(entries_.value(j));
      const Mask clear = entries_.clear(j);
      if (!in_none(clear))
        result[j] =
            where(clear, square_root(placed_.squared_b_entry(j), entries_.square(j).lower()), result[j]);
    }
    return result;
  }

  /// By the constraints besides limits of actuated joints.
  bool center_is_allowed(const Signs& signs) const {
    const Verdict points = at().tests.none() ? Verdict::holds : constraints_.all(signs, *legs_);
    if (both(this->keeps_margins(signs), points) == Verdict::holds) return true;
    const Box center{coordinate_count, at().box.middle(), at().box.middle()};
    const BoxIntervals<Chart> there(at().with(center));
    return !there.reachable_nowhere() && there.is_allowed(signs) == Verdict::holds;
  }

  /// Of leg j, and within the limits of its actuated joint.
  const Mask& center_is_reachable(std::size_t j, int sign) const {
    std::optional<Mask>& found = reachable_centers_[j][branch_of(sign)];
    if (!found) found = outlined<Number>([&] { return find_reachable_center(j, sign); });
    return *found;
  }
  Mask find_reachable_center(std::size_t j, int sign) const {
    const Range square = squared_b_entry_at_center(j);
    if (in_none(square.positive())) return Mask{};
    const Form entry(square_root(square));
    const LimitFunctions<Form> limits = at().chart.limits(j, placed_.legs[j].displacement, entry, sign);
    LimitFunctions<Range> at_center{{}, limits.count, limits.any};
    for (std::size_t k = 0; k < limits.count; ++k) at_center.values[k] = limits.values[k].at_center();
    return square.positive() & proved(at_center).holds;
  }

  const Intervals& intervals_;
  PlacedLegs<Chart, Form> placed_;
  Entries entries_;
  mutable Constraints constraints_;  // tested where they are asked for first
  std::optional<EvaluatedLegs<Chart, Form>> legs_;
  mutable std::array<std::array<std::optional<Mask>, 2>, leg_count> reachable_centers_;  // by leg and branch
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_FORMS_H
