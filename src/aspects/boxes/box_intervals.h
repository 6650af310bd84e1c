// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_INTERVALS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_INTERVALS_H

#include "aspects/boxes/box_stage.h"
#include "aspects/boxes/evaluated_legs.h"
#include "aspects/constraints/constraint_verdicts.h"
#include "interval/interval.h"
#include "parallel_aspects/singularity/indices.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

namespace parallel_aspects {

inline Interval every_index(ParallelIndex kind) noexcept {
  return {0.0, kind == ParallelIndex::normalised ? 1.0 : std::numeric_limits<double>::infinity()};
}

/// The size of a determinant that has this sign, and 0 of others.
template <class Range>
Range of_sign(const Range& determinant, int sign) noexcept {
  return not_negative_part(sign > 0 ? determinant : -determinant);
}

/// In place of the verdicts of constraints where there are none but limits.
struct NoConstraints {
  template <class Tests>
  explicit NoConstraints(const Tests&) noexcept {}
  void expect_tighter() noexcept {}
};

/// The first stage (see box_stage.h): a box by intervals.
template <class Chart, class Number = double>
class BoxIntervals : public BoxStage<Chart, Number, BoxIntervals<Chart, Number>> {
 public:
  using Stage = BoxStage<Chart, Number, BoxIntervals<Chart, Number>>;
  using Stage::leg_count;
  using Stage::reachable_nowhere;
  using typename Stage::Mask;
  using typename Stage::Range;
  using typename Stage::Signs;
  using At = ChartBox<Chart, Number>;
  using Entries = BoxEntries<leg_count, Number>;
  using Constraints =
      std::conditional_t<Stage::is_of_one_box, ConstraintVerdicts<leg_count, Chart::point_dimension>,
                         NoConstraints>;

  explicit BoxIntervals(const At& at)
      : at_(at),
        placed_(at.chart, at.root, at.ranges()),
        entries_(squares_of(placed_), at.bound),
        constraints_(at.tests) {
    assert_rounding_upward();
    if (!in_all(reachable_nowhere())) legs_.emplace(at.chart, placed_, entries_.values());
  }
  static BoxIntervals of(const At& at) {
    return outlined<Number>([&at] { return BoxIntervals(at); });
  }

  const At& at() const noexcept { return at_; }
  const Entries& entries() const noexcept { return entries_; }
  const auto& displacement(std::size_t j) const noexcept { return placed_.legs[j].displacement; }
  Constraints& constraints() const noexcept { return constraints_; }
  const EvaluatedLegs<Chart, Range>& legs() const noexcept { return *legs_; }
  const auto& placement() const noexcept { return placed_.placement; }

  const Range& determinant(const Signs& signs) const { return legs_->determinant(signs); }

  /// At every pose of the box that all legs reach; 0 where det A has another sign.
  Range index(ParallelIndex kind, const Signs& signs, int sign) const {
    const Range all = every_index(kind), squares = at_.tests.margins().index_squares(kind, *legs_, signs);
    if (in_none(squares.positive())) return all;
    const Range index = of_sign(determinant(signs), sign) * reciprocal(square_root(squares));
    return where(squares.positive(), intersection(all, index), all);
  }

  Verdict parallel_margins_by_squares(const Signs& signs) const {
    return at_.tests.margins().parallel(square(determinant(signs)), *legs_, signs);
  }

  ProvedSign<Mask> proved_sign(const Range& determinant, const Signs&) const {
    return {determinant.positive(), determinant.negative()};
  }

 private:
  At at_;
  PlacedLegs<Chart, Range> placed_;
  Entries entries_;
  mutable Constraints constraints_;  // tested where they are asked for first
  std::optional<EvaluatedLegs<Chart, Range>> legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_INTERVALS_H
