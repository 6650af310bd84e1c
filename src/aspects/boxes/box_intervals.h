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

namespace parallel_aspects {

inline Interval every_index(ParallelIndex kind) noexcept {
  return {0.0, kind == ParallelIndex::normalised ? 1.0 : std::numeric_limits<double>::infinity()};
}

/// The size of a determinant that has this sign, and 0 of others.
template <class Range>
Range of_sign(const Range& determinant, int sign) noexcept {
  return not_negative_part(sign > 0 ? determinant : -determinant);
}

/// The first stage (see box_stage.h): a box by intervals.
template <class Chart>
class BoxIntervals : public BoxStage<Chart, BoxIntervals<Chart>> {
 public:
  using Stage = BoxStage<Chart, BoxIntervals<Chart>>;
  using Stage::coordinate_count;
  using Stage::leg_count;
  using Stage::reachable_nowhere;
  using typename Stage::Signs;
  using Entries = BoxEntries<leg_count>;
  using Constraints = ConstraintVerdicts<leg_count, Chart::point_dimension>;

  explicit BoxIntervals(const ChartBox<Chart>& at)
      : at_(at),
        placed_(at.chart, at.root, ranges(at)),
        entries_(squares(placed_), at.bound),
        constraints_(at.tests) {
    if (!reachable_nowhere()) legs_.emplace(at.chart, placed_, entries_.values());
  }

  const ChartBox<Chart>& at() const noexcept { return at_; }
  const Entries& entries() const noexcept { return entries_; }
  const auto& displacement(std::size_t j) const noexcept { return placed_.legs[j].displacement; }
  Constraints& constraints() const noexcept { return constraints_; }
  const EvaluatedLegs<Chart, Interval>& legs() const noexcept { return *legs_; }
  const auto& placement() const noexcept { return placed_.placement; }

  Interval determinant(const Signs& signs) const { return legs_->determinant(signs); }

  /// At every pose of the box that all legs reach; 0 where det A has another sign.
  Interval index(ParallelIndex kind, const Signs& signs, int sign) const {
    const auto& margins = at_.tests.margins();
    const bool normalised = kind == ParallelIndex::normalised;
    const Interval all = every_index(kind);
    const Interval squares =
        normalised ? margins.squared_norms(*legs_, signs) : margins.squared_scales(*legs_);
    if (!squares.positive()) return all;
    return intersection(all, of_sign(determinant(signs), sign) * reciprocal(square_root(squares)));
  }

  Verdict parallel_margins_by_squares(const Signs& signs) const {
    return at_.tests.margins().parallel(square(determinant(signs)), *legs_, signs);
  }

  int sign_of(const Interval& determinant, const Signs&) const {
    return determinant.positive() ? 1 : determinant.negative() ? -1 : 0;
  }

 private:
  static std::array<Interval, coordinate_count> ranges(const ChartBox<Chart>& at) {
    assert_rounding_upward();
    std::array<Interval, coordinate_count> result;
    for (std::size_t i = 0; i < coordinate_count; ++i) result[i] = at.range(i);
    return result;
  }

  static typename Entries::Values squares(const PlacedLegs<Chart, Interval>& placed) {
    typename Entries::Values result;
    for (std::size_t j = 0; j < leg_count; ++j) result[j] = placed.squared_b_entry(j);
    return result;
  }

  ChartBox<Chart> at_;
  PlacedLegs<Chart, Interval> placed_;
  Entries entries_;
  mutable Constraints constraints_;  // tested where they are asked for first
  std::optional<EvaluatedLegs<Chart, Interval>> legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_INTERVALS_H
