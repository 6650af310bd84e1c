// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/batches/lane_classifier.h"

#include "aspects/batches/box_lanes.h"
#include "aspects/batches/lane_versions.h"

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
PARALLEL_ASPECTS_FOR_PAIRS void classify_pair(const LaneWork<Chart>& work) noexcept {
  BoxLanes<Chart, Lanes<2>>(work.chart, work.signs, work.requests, work.count).classify(work.detail);
}

template <class Chart>
PARALLEL_ASPECTS_FOR_FOUR void classify_four(const LaneWork<Chart>& work) noexcept {
  BoxLanes<Chart, Lanes<4>>(work.chart, work.signs, work.requests, work.count).classify(work.detail);
}

template <class Chart>
PARALLEL_ASPECTS_FOR_EIGHT void classify_eight(const LaneWork<Chart>& work) noexcept {
  BoxLanes<Chart, Lanes<8>>(work.chart, work.signs, work.requests, work.count).classify(work.detail);
}

template <class Chart>
void classify_all(const Chart& chart, const ModeSigns<Chart>& signs, const BoxRequests& requests,
                  Detail detail, InstructionSet instructions) noexcept {
  const std::size_t lanes = lanes_of(instructions);
  for_each_group(requests, lanes, [&](std::size_t first, std::size_t count) {
    const LaneWork<Chart> work{chart, signs, &requests[first], count, detail};
    if (lanes == 8) return classify_eight(work);
    if (lanes == 4) return classify_four(work);
    classify_pair(work);
  });
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
