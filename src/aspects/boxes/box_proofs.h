// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_PROOFS_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_PROOFS_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/box_slopes.h"
#include "aspects/boxes/box_states.h"
#include "aspects/boxes/index_on_arcs.h"
#include "aspects/boxes/wedge_proof.h"

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

// What BoxClassifier tells of boxes, from one stage after the other (see box_stage.h).

namespace parallel_aspects {

/// The states of a box in many working modes, or of several in lanes.
template <class Chart, class Number>
class StatesByMode {
 public:
  using Bits = BitsOf<Number>;
  using Mask = MaskOf<Number>;
  using Signs = std::array<int, Chart::leg_count>;

  /// `signs` of all working modes; `modes`: which of them are asked for, bit by bit.
  StatesByMode(const std::vector<Signs>& signs, const Bits& modes) : signs_(signs), modes_(modes) {}

  /// As BoxClassifier has it, but lanes find nothing that only `Detail::all_parts` does. Without slopes
  /// nothing is found whole.
  template <bool has_slopes>
  void find(const ChartBox<Chart, Number>& at, Detail detail, const BoxPolicy& policy) {
    const auto intervals = BoxIntervals<Chart, Number>::of(at);
    Mask open{};
    for_each_in(modes_, [&](std::size_t mode, const Mask& asked) {
      states_[mode] = intervals.states(signs_[mode]);
      open |= asked & is_undecided(states_[mode]);
    });
    if (!in_none(open)) find_by_forms<has_slopes>(BoxForms<Chart, Number>::of(intervals), detail, policy);
  }

  const Bits& operator[](std::size_t mode) const noexcept { return states_[mode]; }

 private:
  /// Calls `act(mode, where it is one of these)`.
  template <class Act>
  void for_each_in(const Bits& modes, const Act& act) const {
    for (std::size_t mode = 0; mode < signs_.size(); ++mode) {
      const Mask asked = (modes >> static_cast<std::int64_t>(mode) & 1) != 0;
      if (!in_none(asked)) act(mode, asked);
    }
  }

  /// Calls `act(mode, where it is asked for and undecided)`.
  template <class Act>
  void for_each_open(const Act& act) const {
    for_each_in(modes_, [&](std::size_t mode, const Mask& asked) {
      const Mask open = asked & is_undecided(states_[mode]);
      if (!in_none(open)) act(mode, open);
    });
  }

  template <bool has_slopes>
  void find_by_forms(const BoxForms<Chart, Number>& forms, Detail detail, const BoxPolicy& policy) {
    Mask still_open{};
    for_each_open([&](std::size_t mode, const Mask& open) {
      Bits found = forms.states(signs_[mode]);
      still_open |= open & is_undecided(found);
      if (detail != Detail::states && !in_none(open & is_undecided(found)))
        found |= forms.centers(signs_[mode]);
      states_[mode] = where(open, found, states_[mode]);
    });
    if constexpr (has_slopes)
      if (!in_none(still_open) && (detail == Detail::parts || detail == Detail::all_parts))
        find_whole_parts(BoxSlopes<Chart, Number>::of(forms), detail == Detail::all_parts, policy);
  }

  void find_whole_parts(const BoxSlopes<Chart, Number>& slopes, bool all, const BoxPolicy& policy) {
    for_each_open([&](std::size_t mode, const Mask& open) {
      for (const int sign : {1, -1}) {
        const Mask asked = open & has_bits(states_[mode], may_be_bit(sign));
        if (in_none(asked)) continue;
        Mask whole = asked & slopes.is_whole(signs_[mode], sign, policy.shells, all && policy.faces);
        if constexpr (std::is_same_v<Number, double>)
          whole =
              whole || (all && policy.wedges && WedgeProof<Chart>(slopes, signs_[mode], sign, policy).find());
        states_[mode] |= bits_where(whole, whole_bit(sign));
      }
    });
  }

  const std::vector<Signs>& signs_;
  Bits modes_;
  std::array<Bits, std::size_t{1} << Chart::leg_count> states_;
};

/// What `BoxClassifier::examine` tells of a box, or of several in lanes.
template <class Chart, class Number>
class ExaminedBoxes {
 public:
  using Signs = std::array<int, Chart::leg_count>;

  ExaminedBoxes(const ChartBox<Chart, Number>& at, const Signs& signs, int sign, bool shells) {
    const auto intervals = BoxIntervals<Chart, Number>::of(at);
    states_ = intervals.states(signs);
    if (!in_none(is_undecided(states_))) examine(BoxForms<Chart, Number>::of(intervals), signs, sign, shells);
  }

  Examined lane(std::size_t i) const {
    Examined result{state_of(lane_of(states_, i)), growth_.lane(i), std::nullopt};
    if (lane_of(is_shell_, i)) result.shell = growth_of_shell_.lane(i);
    return result;
  }

 private:
  using Mask = MaskOf<Number>;
  using Growth = MonotonicityIn<Number>;

  void examine(const BoxForms<Chart, Number>& forms, const Signs& signs, int sign, bool shells) {
    states_ = where(Mask(is_undecided(states_)), forms.states(signs), states_);
    const Mask asked = is_undecided(states_) & has_bits(states_, may_be_bit(sign));
    if (in_none(asked)) return;
    const auto slopes = BoxSlopes<Chart, Number>::of(forms);
    const Growth growth = slopes.monotonicity(signs, sign);
    growth_ = growth.where_or(asked, Growth::unknown());
    const Mask open = asked & !growth.along_all(forms.at());
    if (shells && !in_none(open)) is_shell_ = slopes.shell(signs, sign, open, growth_of_shell_);
  }

  BitsOf<Number> states_;
  Growth growth_ = Growth::unknown(), growth_of_shell_ = Growth::unknown();
  Mask is_shell_{};
};

/// Of an index in a box.
struct EnclosedIndex {
  Interval range;
  bool may_be_closer;  ///< by arcs: see IndexOnArcs
};

/// What intervals and affine forms tell of an index in a box, or in several in lanes; see
/// BoxClassifier::enclose_index.
template <class Chart, class Number>
class BoundedIndices {
 public:
  using Signs = std::array<int, Chart::leg_count>;

  BoundedIndices(const ChartBox<Chart, Number>& at, const Signs& signs, int sign, ParallelIndex index,
                 const Number& share) {
    const auto intervals = BoxIntervals<Chart, Number>::of(at);
    Mask nowhere = intervals.reachable_nowhere();
    if (in_all(nowhere)) return;
    range_ = intervals.index(index, signs, sign);
    open_ = !(nowhere | is_enough(share));
    if (!in_none(open_)) {
      const auto forms = BoxForms<Chart, Number>::of(intervals);
      nowhere |= open_ & forms.reachable_nowhere();
      if (!in_all(forms.reachable_nowhere()))
        range_ = where(open_, intersection(range_, forms.index(index, signs, sign)), range_);
      open_ &= is_near_axis(intervals) & !(nowhere | is_enough(share));
    }
    range_ = where(nowhere, Range(0.0), range_);
  }

  EnclosedIndex lane(std::size_t i) const { return {lane_of(range_, i), lane_of(open_, i) != 0}; }

 private:
  using Range = RangeOf<Number>;
  using Mask = MaskOf<Number>;

  Mask is_enough(const Number& share) const {
    return range_.upper() - range_.lower() <= share * range_.upper();
  }

  static Mask is_near_axis(const BoxIntervals<Chart, Number>& intervals) {
    Mask result{};
    for (std::size_t j = 0; j < Chart::leg_count; ++j) {
      const Range scale = intervals.legs().scale(j);
      result |= scale.lower() < IndexOnArcs<Chart>::near_axis * scale.upper();
    }
    return result;
  }

  Range range_ = Range(0.0);
  Mask open_{};
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_PROOFS_H
