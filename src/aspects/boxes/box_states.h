// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_STATES_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_STATES_H

#include "aspects/tree/leaf_state.h"
#include "interval/lanes.h"

#include <cstdint>

// The state of a box, or of several in lanes, as bits: no bit stands for a box outside.

namespace parallel_aspects {

namespace state_bits {
inline constexpr std::int64_t may_be_positive = 1, may_be_negative = 2, is_inside = 4, center_positive = 8,
                              center_negative = 16, whole_positive = 32, whole_negative = 64;
}  // namespace state_bits

inline std::int64_t may_be_bit(int sign) noexcept {
  return sign > 0 ? state_bits::may_be_positive : state_bits::may_be_negative;
}

inline std::int64_t whole_bit(int sign) noexcept {
  return sign > 0 ? state_bits::whole_positive : state_bits::whole_negative;
}

/// Whether there is any of them.
template <class Bits>
auto has_bits(const Bits& states, std::int64_t bits) noexcept {
  return (states & bits) != 0;
}

template <class Bits>
auto is_undecided(const Bits& states) noexcept {
  return has_bits(states, state_bits::may_be_positive | state_bits::may_be_negative) &
         !has_bits(states, state_bits::is_inside);
}

/// Of one box.
inline LeafState state_of(std::int64_t bits) noexcept {
  const bool positive = has_bits(bits, state_bits::may_be_positive),
             negative = has_bits(bits, state_bits::may_be_negative);
  if (has_bits(bits, state_bits::is_inside)) return LeafState::inside(positive ? 1 : -1);
  LeafState state = LeafState::undecided(positive, negative);
  if (state.is_outside()) return state;
  for (const int sign : {1, -1})
    if (has_bits(bits, whole_bit(sign))) state = state.with_whole(sign);
  if (!has_bits(bits, state_bits::center_positive | state_bits::center_negative)) return state;
  return state.with_center(has_bits(bits, state_bits::center_positive) ? 1 : -1);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_BOX_STATES_H
