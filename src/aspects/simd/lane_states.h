// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_LANE_STATES_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_LANE_STATES_H

#include "aspects/simd/lane_stages.h"
#include "aspects/tree/leaf_state.h"

#include <cstdint>

// The states of boxes, one in each lane, as bits.

namespace parallel_aspects {

namespace lane_bits {
inline constexpr std::int64_t may_be_positive = 1, may_be_negative = 2, is_inside = 4, center_positive = 8,
                              center_negative = 16, whole_positive = 32, whole_negative = 64;
}  // namespace lane_bits

/// See BoxStage::state.
template <class Stage>
typename Stage::Mask state_in_lanes(const Stage& stage, const typename Stage::Range& determinant,
                                    const typename Stage::Types::Signs& signs) {
  using Mask = typename Stage::Mask;
  Mask hold = stage.entries().all_clear, fail = stage.entries().reachable_nowhere;
  for (std::size_t j = 0; j < signs.size(); ++j) {
    hold &= stage.limits().hold[j][branch_of(signs[j])];
    fail |= stage.limits().fail[j][branch_of(signs[j])];
  }
  const Mask has_sign = determinant.positive() | determinant.negative();
  return ~fail & (((determinant.upper() > 0.0) & lane_bits::may_be_positive) |
                  ((determinant.lower() < 0.0) & lane_bits::may_be_negative) |
                  (has_sign & hold & lane_bits::is_inside));
}

template <class Mask>
Mask has_bits(const Mask& states, std::int64_t bits) {
  return (states & bits) != 0;
}

/// Lanes that hold an undecided box.
template <class Mask>
Mask undecided_in_lanes(const Mask& states) {
  return has_bits(states, lane_bits::may_be_positive | lane_bits::may_be_negative) &
         ~has_bits(states, lane_bits::is_inside);
}

/// Of one lane.
inline LeafState state_of(std::int64_t bits) {
  const bool positive = (bits & lane_bits::may_be_positive) != 0,
             negative = (bits & lane_bits::may_be_negative) != 0;
  if ((bits & lane_bits::is_inside) != 0) return LeafState::inside(positive ? 1 : -1);
  LeafState state = LeafState::undecided(positive, negative);
  if (state.is_outside()) return state;
  if ((bits & lane_bits::whole_positive) != 0) state = state.with_whole(1);
  if ((bits & lane_bits::whole_negative) != 0) state = state.with_whole(-1);
  if ((bits & (lane_bits::center_positive | lane_bits::center_negative)) == 0) return state;
  return state.with_center((bits & lane_bits::center_positive) != 0 ? 1 : -1);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_LANE_STATES_H
