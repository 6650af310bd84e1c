// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/batches/lane_classifier.h"

#include "aspects/batches/box_lanes.h"

#include <algorithm>

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

namespace parallel_aspects {
namespace {

template <class Chart>
struct LaneWork {
  const Chart& chart;
  const ModeSigns<Chart>& signs;
  const BoxRequest* requests;
  std::size_t count;
  Detail detail;
};

template <class Chart>
PARALLEL_ASPECTS_FOR("sse2")
void classify_pair(const LaneWork<Chart>& work) noexcept {
  BoxLanes<Chart, Lanes<2>>(work.chart, work.signs, work.requests, work.count).classify(work.detail);
}

template <class Chart>
PARALLEL_ASPECTS_FOR("avx2")
void classify_four(const LaneWork<Chart>& work) noexcept {
  BoxLanes<Chart, Lanes<4>>(work.chart, work.signs, work.requests, work.count).classify(work.detail);
}

template <class Chart>
PARALLEL_ASPECTS_FOR("avx512f,avx512dq,avx512vl,prefer-vector-width=512")
void classify_eight(const LaneWork<Chart>& work) noexcept {
  BoxLanes<Chart, Lanes<8>>(work.chart, work.signs, work.requests, work.count).classify(work.detail);
}

std::size_t lanes_of(InstructionSet instructions) noexcept {
  return instructions == InstructionSet::avx512 ? 8 : instructions == InstructionSet::avx2 ? 4 : 2;
}

template <class Chart>
void classify_all(const Chart& chart, const ModeSigns<Chart>& signs, const BoxRequests& requests,
                  Detail detail, InstructionSet instructions) noexcept {
  const std::size_t lanes = lanes_of(instructions);
  for (std::size_t first = 0; first < requests.size();) {
    std::size_t last = first + 1;
    while (last < std::min(requests.size(), first + lanes) && requests[last].root == requests[first].root)
      ++last;
    const LaneWork<Chart> work{chart, signs, &requests[first], last - first, detail};
    if (lanes == 8)
      classify_eight(work);
    else if (lanes == 4)
      classify_four(work);
    else
      classify_pair(work);
    first = last;
  }
}

}  // namespace

bool has_instructions(InstructionSet instructions) noexcept {
#ifdef PARALLEL_ASPECTS_VERSIONS
  __builtin_cpu_init();  // this may run before other initialisation
  if (instructions == InstructionSet::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  if (instructions == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
#endif
  return instructions == InstructionSet::none || instructions == InstructionSet::sse2;
}

InstructionSet widest_instructions() noexcept {
  for (const InstructionSet instructions : {InstructionSet::avx512, InstructionSet::avx2})
    if (has_instructions(instructions)) return instructions;
  return InstructionSet::sse2;
}

void classify_in_lanes(const T2Chart& chart, const ModeSigns<T2Chart>& signs, const BoxRequests& requests,
                       Detail detail, InstructionSet instructions) noexcept {
  classify_all(chart, signs, requests, detail, instructions);
}
void classify_in_lanes(const SE2Chart& chart, const ModeSigns<SE2Chart>& signs, const BoxRequests& requests,
                       Detail detail, InstructionSet instructions) noexcept {
  classify_all(chart, signs, requests, detail, instructions);
}
void classify_in_lanes(const T3Chart& chart, const ModeSigns<T3Chart>& signs, const BoxRequests& requests,
                       Detail detail, InstructionSet instructions) noexcept {
  classify_all(chart, signs, requests, detail, instructions);
}
void classify_in_lanes(const SO3Chart& chart, const ModeSigns<SO3Chart>& signs, const BoxRequests& requests,
                       Detail detail, InstructionSet instructions) noexcept {
  classify_all(chart, signs, requests, detail, instructions);
}

}  // namespace parallel_aspects
