// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_PART_LANES_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_PART_LANES_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/simd/lane_stages.h"
#include "aspects/simd/lane_states.h"
#include "aspects/simd/slope_lanes.h"
#include "aspects/tree/neighbour_leaves.h"

#include <cstddef>
#include <cstdint>

namespace parallel_aspects {

/// What `ChartClassifier::examine` tells of boxes of one chart and root in one working mode, one in each
/// lane.
template <class Chart, class Numbers>
class PartLanes {
 public:
  using Types = LaneTypes<Chart, Numbers>;
  using Signs = typename Types::Signs;

  /// `count` boxes of one root, at most as many as there are lanes.
  PartLanes(const Chart& chart, const Signs& signs, int sign, const SharedFace* boxes, std::size_t count)
      : chart_(chart), signs_(signs), sign_(sign), root_(boxes[0].root), count_(count) {
    for (std::size_t i = 0; i < lane_count<Numbers>; ++i)
      for (std::size_t k = 0; k < Types::coordinate_count; ++k) {
        const Box& box = boxes[i < count ? i : 0].box;
        ranges_[k].set_lane(i, Interval(box.lower[k], box.upper[k]));
      }
  }

  void examine(bool shells, Examined* examined) {
    growth_.forget(~Mask{});
    const auto intervals = LaneIntervals<Chart, Numbers>::of(chart_, root_, ranges_);
    const Range natural = intervals.determinant(signs_);
    states_ = state_in_lanes(intervals, natural, signs_);
    const Mask undecided = undecided_in_lanes(states_);
    if (!in_none(undecided))
      examine_by_forms(LaneForms<Chart, Numbers>::of(intervals), natural, undecided, shells);
    write(examined);
  }

 private:
  using Range = typename Types::Range;
  using Mask = typename Types::Mask;
  using Slopes = SlopeLanes<Chart, Numbers>;

  void examine_by_forms(const LaneForms<Chart, Numbers>& forms, const Range& natural, const Mask& undecided,
                        bool shells) {
    const Range determinant =
        LaneForms<Chart, Numbers>::determinant(natural, forms.legs().determinant(signs_));
    states_ = undecided ? state_in_lanes(forms, determinant, signs_) : states_;
    const Mask asked = undecided & undecided_in_lanes(states_) &
                       has_bits(states_, sign_ > 0 ? lane_bits::may_be_positive : lane_bits::may_be_negative);
    if (in_none(asked)) return;
    const Slopes slopes = Slopes::of(forms);
    growth_ = slopes.monotonicity(signs_, sign_, determinant);
    const Mask along = slopes.along_all(growth_);
    growth_.forget(~asked);
    if (shells) is_shell_ = slopes.shell(signs_, sign_, asked & ~along, growth_of_shell_);
  }

  using Growth = typename Slopes::Growth;

  static Monotonicity monotonicity_of(const Growth& growth, std::size_t lane) {
    std::uint8_t upward = 0, downward = 0;
    for (std::size_t k = 0; k < Types::coordinate_count; ++k) {
      if (growth.upward[k][lane] != 0) upward |= static_cast<std::uint8_t>(1U << k);
      if (growth.downward[k][lane] != 0) downward |= static_cast<std::uint8_t>(1U << k);
    }
    return {upward, downward};
  }

  void write(Examined* examined) const {
    for (std::size_t i = 0; i < count_; ++i) {
      examined[i] = {state_of(states_[i]), monotonicity_of(growth_, i), std::nullopt};
      if (is_shell_[i] != 0) examined[i].shell = monotonicity_of(growth_of_shell_, i);
    }
  }

  const Chart& chart_;
  const Signs& signs_;
  int sign_;
  RootIndex root_;
  std::size_t count_;
  typename Types::Ranges ranges_;
  Mask states_, is_shell_{};
  Growth growth_, growth_of_shell_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_PART_LANES_H
