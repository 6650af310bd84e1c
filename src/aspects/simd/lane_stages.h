// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_LANE_STAGES_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_LANE_STAGES_H

#include "aspects/boxes/evaluated_legs.h"
#include "aspects/tree/pose_space.h"
#include "interval/affine_lanes.h"
#include "interval/interval_lanes.h"
#include "legs/limit_verdict.h"

#include <array>
#include <cstddef>

// Boxes of one chart and root, one in each lane, in the stages of box_stage.h: each lane has the numbers that
// its box would have alone, to the last digit. For robots whose only constraints are limits of actuated
// joints.

namespace parallel_aspects {

/// The types of boxes of a chart in the lanes of `Numbers`.
template <class Chart, class Numbers>
struct LaneTypes {
  static constexpr std::size_t leg_count = Chart::leg_count, coordinate_count = Chart::coordinate_count;
  using Range = IntervalLanes<Numbers>;
  using Form = AffineLanes<coordinate_count, Numbers>;
  using Mask = decltype(Numbers{} < Numbers{});
  using Signs = std::array<int, leg_count>;
  using Ranges = std::array<Range, coordinate_count>;
  using ByLegAndBranch = std::array<std::array<Mask, 2>, leg_count>;
};

inline std::size_t branch_of(int sign) noexcept { return sign > 0 ? 1 : 0; }

/// See BoxEntries.
template <class Chart, class Numbers>
struct LaneEntries {
  using Types = LaneTypes<Chart, Numbers>;
  using Squares = std::array<typename Types::Range, Chart::leg_count>;

  Squares squares, values;
  std::array<typename Types::Mask, Chart::leg_count> clear;
  typename Types::Mask all_clear = ~typename Types::Mask{}, reachable_nowhere{};

  explicit LaneEntries(const Squares& of) : squares(of) {
    for (std::size_t j = 0; j < Chart::leg_count; ++j) {
      clear[j] = squares[j].positive();
      all_clear &= clear[j];
      reachable_nowhere |= squares[j].upper() <= 0.0;
      values[j] = square_root(not_negative_part(squares[j]));
    }
  }
};

/// See `verdict`.
template <class Limits, class Mask>
void judge_limits(const Limits& limits, Mask& hold, Mask& fail) {
  const bool any = limits.any && limits.count > 0;
  hold = any ? Mask{} : ~Mask{};
  fail = any ? ~Mask{} : Mask{};
  for (std::size_t k = 0; k < limits.count; ++k) {
    const Mask positive = limits.values[k].positive(), negative = limits.values[k].negative();
    hold = any ? hold | positive : hold & positive;
    fail = any ? fail & negative : fail | negative;
  }
}

/// Of limits of actuated joints.
template <class Chart, class Numbers>
struct LaneLimits {
  typename LaneTypes<Chart, Numbers>::ByLegAndBranch hold, fail;

  template <class Placed>
  LaneLimits(const Chart& chart, const Placed& placed, const LaneEntries<Chart, Numbers>& entries) {
    for (std::size_t j = 0; j < Chart::leg_count; ++j)
      for (const int sign : {-1, 1})
        judge_limits(chart.limits(j, placed.legs[j].displacement, entries.values[j], sign),
                     hold[j][branch_of(sign)], fail[j][branch_of(sign)]);
  }
};

template <class Placed>
auto squares_of(const Placed& placed) {
  std::array<decltype(range_of(placed.squared_b_entry(0))), Placed::leg_count> result;
  for (std::size_t j = 0; j < result.size(); ++j) result[j] = range_of(placed.squared_b_entry(j));
  return result;
}

/// See BoxIntervals.
template <class Chart, class Numbers>
class LaneIntervals {
 public:
  using Types = LaneTypes<Chart, Numbers>;
  using Range = typename Types::Range;
  using Mask = typename Types::Mask;

  static LaneIntervals of(const Chart& chart, RootIndex root, const typename Types::Ranges& ranges) {
    return outlined<Numbers>([&] { return LaneIntervals(chart, root, ranges); });
  }

  const Chart& chart() const { return chart_; }
  RootIndex root() const { return root_; }
  const typename Types::Ranges& ranges() const { return ranges_; }
  const PlacedLegs<Chart, Range>& placed() const { return placed_; }
  const LaneEntries<Chart, Numbers>& entries() const { return entries_; }
  const LaneLimits<Chart, Numbers>& limits() const { return limits_; }
  const EvaluatedLegs<Chart, Range>& legs() const { return legs_; }
  Range determinant(const typename Types::Signs& signs) const {
    return outlined<Numbers>([&] { return legs_.determinant(signs); });
  }

 private:
  LaneIntervals(const Chart& chart, RootIndex root, const typename Types::Ranges& ranges)
      : chart_(chart),
        root_(root),
        ranges_(ranges),
        placed_(chart, root, ranges),
        entries_(squares_of(placed_)),
        limits_(chart, placed_, entries_),
        legs_(chart, placed_, entries_.values) {}

  const Chart& chart_;
  RootIndex root_;
  const typename Types::Ranges& ranges_;
  PlacedLegs<Chart, Range> placed_;
  LaneEntries<Chart, Numbers> entries_;
  LaneLimits<Chart, Numbers> limits_;
  EvaluatedLegs<Chart, Range> legs_;
};

/// See BoxForms.
template <class Chart, class Numbers>
class LaneForms {
 public:
  using Types = LaneTypes<Chart, Numbers>;
  using Range = typename Types::Range;
  using Form = typename Types::Form;
  using Mask = typename Types::Mask;
  static constexpr std::size_t leg_count = Chart::leg_count, coordinate_count = Chart::coordinate_count;

  static LaneForms of(const LaneIntervals<Chart, Numbers>& intervals) {
    return outlined<Numbers>([&] { return LaneForms(intervals); });
  }

  const LaneIntervals<Chart, Numbers>& intervals() const { return intervals_; }
  const PlacedLegs<Chart, Form>& placed() const { return placed_; }
  const LaneEntries<Chart, Numbers>& entries() const { return entries_; }
  const LaneLimits<Chart, Numbers>& limits() const { return limits_; }
  const EvaluatedLegs<Chart, Form>& legs() const { return legs_; }

  /// See BoxForms::determinant; `natural` is that of the intervals.
  static Range determinant(const Range& natural, const Form& form) {
    return where(natural.positive() | natural.negative(), natural, intersection(natural, form.range()));
  }

  static std::array<Form, coordinate_count> coordinates(const typename Types::Ranges& ranges) {
    std::array<Form, coordinate_count> result;
    for (std::size_t i = 0; i < coordinate_count; ++i) result[i] = Form::coordinate(ranges[i], i);
    return result;
  }

  /// Where the centers are reachable and within limits: see BoxForms::center_is_reachable.
  typename Types::ByLegAndBranch reachable_centers() const {
    return outlined<Numbers>([this] { return find_reachable_centers(); });
  }

 private:
  explicit LaneForms(const LaneIntervals<Chart, Numbers>& intervals)
      : intervals_(intervals),
        placed_(intervals.chart(), intervals.root(), coordinates(intervals.ranges())),
        entries_(closer_squares()),
        limits_(intervals.chart(), intervals.placed(), entries_),
        legs_(intervals.chart(), placed_, entry_forms()) {}

  typename Types::ByLegAndBranch find_reachable_centers() const {
    typename Types::ByLegAndBranch reachable;
    for (std::size_t j = 0; j < leg_count; ++j) {
      const Range square = placed_.squared_b_entry(j).at_center();
      const Form entry(square_root(square));
      for (const int sign : {-1, 1}) {
        const LimitFunctions<Form> limits =
            intervals_.chart().limits(j, placed_.legs[j].displacement, entry, sign);
        LimitFunctions<Range> at_center{{}, limits.count, limits.any};
        for (std::size_t k = 0; k < limits.count; ++k) at_center.values[k] = limits.values[k].at_center();
        Mask fail;
        judge_limits(at_center, reachable[j][branch_of(sign)], fail);
        reachable[j][branch_of(sign)] &= square.positive();
      }
    }
    return reachable;
  }

  std::array<Range, leg_count> closer_squares() const {
    std::array<Range, leg_count> result = squares_of(placed_);
    for (std::size_t j = 0; j < leg_count; ++j)
      result[j] = intersection(intervals_.entries().squares[j], result[j]);
    return result;
  }

  std::array<Form, leg_count> entry_forms() const {
    std::array<Form, leg_count> result;
    for (std::size_t j = 0; j < leg_count; ++j)
      result[j] =
          where(entries_.clear[j], square_root(placed_.squared_b_entry(j), entries_.squares[j].lower()),
                Form(entries_.values[j]));
    return result;
  }

  const LaneIntervals<Chart, Numbers>& intervals_;
  PlacedLegs<Chart, Form> placed_;
  LaneEntries<Chart, Numbers> entries_;
  LaneLimits<Chart, Numbers> limits_;
  EvaluatedLegs<Chart, Form> legs_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_LANE_STAGES_H
