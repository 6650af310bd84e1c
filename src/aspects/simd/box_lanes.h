// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_BOX_LANES_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_BOX_LANES_H

#include "aspects/simd/box_requests.h"
#include "aspects/simd/chart_lanes.h"
#include "aspects/simd/lane_stages.h"
#include "aspects/simd/lane_states.h"
#include "aspects/simd/slope_lanes.h"

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
    const auto intervals = LaneIntervals<Chart, Numbers>::of(chart_, requests_[0].root, ranges_);
    Mask open{};
    for (std::size_t mode = 0; mode < signs_.size(); ++mode) {
      determinants_[mode] = intervals.determinant(signs_[mode]);
      states_[mode] = state_in_lanes(intervals, determinants_[mode], signs_[mode]);
      open |= open_in(mode);
    }
    if (!in_none(open)) classify_by_forms(LaneForms<Chart, Numbers>::of(intervals), detail);
    write();
  }

 private:
  static constexpr std::size_t max_modes = std::size_t{1} << Chart::leg_count;
  using Range = typename Types::Range;
  using Form = typename Types::Form;
  using Mask = typename Types::Mask;

  /// Lanes in which the mode is asked for and undecided.
  Mask open_in(std::size_t mode) const {
    const Mask asked = (modes_ >> static_cast<std::int64_t>(mode) & 1) != 0;
    return asked & undecided_in_lanes(states_[mode]);
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
      determinants_[mode] = LaneForms<Chart, Numbers>::determinant(natural, determinant);
      Mask found = state_in_lanes(forms, determinants_[mode], signs_[mode]);
      if (centers) found |= center(determinant, reachable, signs_[mode]);
      states_[mode] = open ? found : states_[mode];
      still_open |= open_in(mode);
    }
    if constexpr (has_slope_lanes<Chart>)
      if (!in_none(still_open) && detail == Detail::parts)
        add_whole_parts(SlopeLanes<Chart, Numbers>::of(forms));
  }

  /// See BoxForms::center_sign.
  static Mask center(const Form& determinant, const typename Types::ByLegAndBranch& reachable,
                     const Signs& signs) {
    const Range value = determinant.at_center();
    Mask bits =
        (value.positive() & lane_bits::center_positive) | (value.negative() & lane_bits::center_negative);
    for (std::size_t j = 0; j < Types::leg_count; ++j) bits &= reachable[j][branch_of(signs[j])];
    return bits;
  }

  void add_whole_parts(const SlopeLanes<Chart, Numbers>& slopes) {
    for (std::size_t mode = 0; mode < signs_.size(); ++mode) {
      const Mask open = open_in(mode);
      if (in_none(open)) continue;
      Mask found{};
      for (const int sign : {1, -1}) {
        const Mask asked = open & has_bits(states_[mode], sign > 0 ? lane_bits::may_be_positive
                                                                   : lane_bits::may_be_negative);
        if (in_none(asked)) continue;
        found |= asked & slopes.is_whole(signs_[mode], sign, determinants_[mode]) &
                 (sign > 0 ? lane_bits::whole_positive : lane_bits::whole_negative);
      }
      states_[mode] |= found;
    }
  }

  void write() const {
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t mode = 0; mode < signs_.size(); ++mode)
        if ((requests_[i].modes >> mode & 1U) != 0) requests_[i].states[mode] = state_of(states_[mode][i]);
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

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_BOX_LANES_H
