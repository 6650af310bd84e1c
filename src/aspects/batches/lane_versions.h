// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_VERSIONS_H
#define PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_VERSIONS_H

#include "aspects/batches/box_requests.h"

#include <algorithm>
#include <cstddef>

// Compiled once for each instruction set, from one source: everything is inlined into functions that are
// compiled for it, and nothing else of the program is. Vectors that are wider than those of the processor
// would be slower, so that each has its own number of lanes. Sanitizers would make such functions huge.
#if defined(__x86_64__) && defined(__OPTIMIZE__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PARALLEL_ASPECTS_VERSIONS
#define PARALLEL_ASPECTS_FOR(instructions) [[gnu::target(instructions), gnu::flatten]]
#else
#define PARALLEL_ASPECTS_FOR(instructions)
#endif
#define PARALLEL_ASPECTS_FOR_PAIRS PARALLEL_ASPECTS_FOR("sse2")
#define PARALLEL_ASPECTS_FOR_FOUR PARALLEL_ASPECTS_FOR("avx2")
#define PARALLEL_ASPECTS_FOR_EIGHT PARALLEL_ASPECTS_FOR("avx512f,avx512dq,avx512vl,prefer-vector-width=512")

namespace parallel_aspects {

inline std::size_t lanes_of(InstructionSet instructions) noexcept {
  return instructions == InstructionSet::avx512 ? 8 : instructions == InstructionSet::avx2 ? 4 : 2;
}

/// Calls `act(first, count)` with parts of a row of boxes, each of one root and with a lane for each box.
template <class Boxes, class Act>
void for_each_group(const Boxes& boxes, std::size_t lanes, const Act& act) {
  for (std::size_t first = 0; first < boxes.size();) {
    std::size_t last = first + 1;
    while (last < std::min(boxes.size(), first + lanes) && boxes[last].root == boxes[first].root) ++last;
    act(first, last - first);
    first = last;
  }
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_VERSIONS_H
