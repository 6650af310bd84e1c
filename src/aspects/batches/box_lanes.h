// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BATCHES_BOX_LANES_H
#define PARALLEL_ASPECTS_ASPECTS_BATCHES_BOX_LANES_H

#include "aspects/batches/box_requests.h"
#include "aspects/batches/lane_classifier.h"
#include "aspects/batches/lane_stages.h"
#include "aspects/batches/slope_lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// Classifies boxes of one chart and root, one in each lane.
template <class Chart, class Numbers>
class BoxLanes {
 public:
  using Types = LaneTypes<Chart, Numbers>;
  using Signs = typename Types::Signs;

  /// `count` requests of one root, at most as many as there are lanes; `signs` of all working modes.
  BoxLanes(const Chart& chart, const std::vector<Signs>& signs, const BoxRequest* requests, std::size_t count)
      : chart_(chart), signs_(signs), requests_(requests), count_(count) {
    for (std::size_t i = 0; i < lane_count<Numbers>; ++i) {
      const BoxRequest& request = requests[i < count ? i : 0];
      modes_[i] = i < count ? static_cast<std::int64_t>(request.modes) : 0;
      for (std::size_t k = 0; k < Types::coordinate_count; ++k)
        ranges_[k].set_lane(i, Interval(request.box.lower[k], request.box.upper[k]));
    }
  }

  /// Writes the states of all requests; see `classify_in_lanes`.
  void classify(Detail detail) {
    const LaneIntervals<Chart, Numbers> intervals(chart_, requests_[0].root, ranges_);
    Mask open{};
    for (std::size_t mode = 0; mode < signs_.size(); ++mode) {
      determinants_[mode] = intervals.determinant(signs_[mode]);
      states_[mode] = state(intervals, determinants_[mode], signs_[mode]);
      open |= open_in(mode);
    }
    if (!in_none(open)) classify_by_forms(LaneForms<Chart, Numbers>(intervals), detail);
    write();
  }

 private:
  static constexpr std::size_t max_modes = std::size_t{1} << Chart::leg_count;
  using Range = typename Types::Range;
  using Form = typename Types::Form;
  using Mask = typename Types::Mask;

  // Bits of a state in a lane.
  static constexpr std::int64_t may_be_positive = 1, may_be_negative = 2, is_inside = 4, center_positive = 8,
                                center_negative = 16, whole_positive = 32, whole_negative = 64;

  /// See BoxStage::state.
  template <class Stage>
  static Mask state(const Stage& stage, const Range& determinant, const Signs& signs) {
    Mask hold = stage.entries().all_clear, fail = stage.entries().reachable_nowhere;
    for (std::size_t j = 0; j < Types::leg_count; ++j) {
      hold &= stage.limits().hold[j][branch_of(signs[j])];
      fail |= stage.limits().fail[j][branch_of(signs[j])];
    }
    const Mask has_sign = determinant.positive() | determinant.negative();
    return ~fail & (((determinant.upper() > 0.0) & may_be_positive) |
                    ((determinant.lower() < 0.0) & may_be_negative) | (has_sign & hold & is_inside));
  }

  static Mask has(const Mask& states, std::int64_t bits) { return (states & bits) != 0; }

  /// Lanes in which the mode is asked for and undecided.
  Mask open_in(std::size_t mode) const {
    const Mask asked = (modes_ >> static_cast<std::int64_t>(mode) & 1) != 0;
    return asked & has(states_[mode], may_be_positive | may_be_negative) & ~has(states_[mode], is_inside);
  }

  void classify_by_forms(const LaneForms<Chart, Numbers>& forms, Detail detail) {
    const bool centers = detail != Detail::states;
    typename Types::ByLegAndBranch reachable;
    if (centers) reachable = forms.reachable_centers();
    Mask still_open{};
    for (std::size_t mode = 0; mode < signs_.size(); ++mode) {
      const Mask open = open_in(mode);
      if (in_none(open)) continue;
      const Range natural = determinants_[mode];
      const Form determinant = forms.legs().determinant(signs_[mode]);
      determinants_[mode] =
          where(natural.positive() | natural.negative(), natural, intersection(natural, determinant.range()));
      Mask found = state(forms, determinants_[mode], signs_[mode]);
      if (centers) found |= center(determinant, reachable, signs_[mode]);
      states_[mode] = open ? found : states_[mode];
      still_open |= open_in(mode);
    }
    if constexpr (has_slope_lanes<Chart>)
      if (!in_none(still_open) && (detail == Detail::parts || detail == Detail::all_parts))
        add_whole_parts(SlopeLanes<Chart, Numbers>(forms));
  }

  /// See BoxForms::center_sign.
  static Mask center(const Form& determinant, const typename Types::ByLegAndBranch& reachable,
                     const Signs& signs) {
    const Range value = determinant.at_center();
    Mask bits = (value.positive() & center_positive) | (value.negative() & center_negative);
    for (std::size_t j = 0; j < Types::leg_count; ++j) bits &= reachable[j][branch_of(signs[j])];
    return bits;
  }

  void add_whole_parts(const SlopeLanes<Chart, Numbers>& slopes) {
    for (std::size_t mode = 0; mode < signs_.size(); ++mode) {
      const Mask open = open_in(mode);
      if (in_none(open)) continue;
      Mask found{};
      for (const int sign : {1, -1}) {
        const Mask asked = open & has(states_[mode], sign > 0 ? may_be_positive : may_be_negative);
        if (in_none(asked)) continue;
        found |= asked & slopes.is_whole(signs_[mode], sign, determinants_[mode]) &
                 (sign > 0 ? whole_positive : whole_negative);
      }
      states_[mode] |= found;
    }
  }

  void write() const {
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t mode = 0; mode < signs_.size(); ++mode)
        if ((requests_[i].modes >> mode & 1U) != 0) requests_[i].states[mode] = state_of(states_[mode][i]);
  }

  static LeafState state_of(std::int64_t bits) {
    const bool positive = (bits & may_be_positive) != 0, negative = (bits & may_be_negative) != 0;
    if ((bits & is_inside) != 0) return LeafState::inside(positive ? 1 : -1);
    LeafState state = LeafState::undecided(positive, negative);
    if (state.is_outside()) return state;
    if ((bits & whole_positive) != 0) state = state.with_whole(1);
    if ((bits & whole_negative) != 0) state = state.with_whole(-1);
    if ((bits & (center_positive | center_negative)) == 0) return state;
    return state.with_center((bits & center_positive) != 0 ? 1 : -1);
  }

  const Chart& chart_;
  const std::vector<Signs>& signs_;
  const BoxRequest* requests_;
  std::size_t count_;
  typename Types::Ranges ranges_;
  Mask modes_;
  std::array<Range, max_modes> determinants_;
  std::array<Mask, max_modes> states_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BATCHES_BOX_LANES_H
