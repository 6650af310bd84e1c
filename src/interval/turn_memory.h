// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_TURN_MEMORY_H
#define PARALLEL_ASPECTS_INTERVAL_TURN_MEMORY_H

#include "interval/half_turns.h"

namespace parallel_aspects {

/// `turn_of_half_turns`, which each thread remembers for some hundred of the last angles: sines cost more
/// than many other operations. The result is valid until the next call.
const Turn<Interval>& remembered_turn(const Interval& a) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_TURN_MEMORY_H
