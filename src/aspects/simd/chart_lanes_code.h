// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_CODE_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_CODE_H

#include "aspects/simd/box_lanes.h"
#include "aspects/simd/chart_lanes.h"
#include "aspects/simd/index_lanes.h"
#include "aspects/simd/part_lanes.h"
#include "interval/lanes.h"

#include <algorithm>
#include <cstddef>
#include <vector>

// The members of ChartLanes. A source that has them compiled for one chart takes ten seconds.

namespace parallel_aspects {

/// Calls `act(first, count)` with parts of a row of boxes, each of one root and with a lane for each box.
template <class Numbers, class Boxes, class Act>
void for_each_group(const Boxes& boxes, const Act& act) {
  for (std::size_t first = 0; first < boxes.size();) {
    const std::size_t end = std::min(boxes.size(), first + lane_count<Numbers>);
    std::size_t last = first + 1;
    while (last < end && boxes[last].root == boxes[first].root) ++last;
    outlined<Numbers>([&] { act(first, last - first); });
    first = last;
  }
}

/// Calls `act(LanesOf<...>())` of the vectors of this instruction set.
template <class Act>
void with_lanes_of(InstructionSet instructions, const Act& act) {
#ifdef PARALLEL_ASPECTS_HAS_WIDE_LANES
  if (instructions == InstructionSet::avx2) return act(LanesOf<4>());
#else
  static_cast<void>(instructions);
#endif
  act(LanesOf<2>());
}

template <class Chart>
void ChartLanes<Chart>::classify(const Chart& chart, const ModeSigns<Chart>& signs,
                                 const BoxRequests& requests, Detail detail,
                                 InstructionSet instructions) noexcept {
  with_lanes_of(instructions, [&](auto lanes) {
    using Numbers = typename decltype(lanes)::Numbers;
    for_each_group<Numbers>(requests, [&](std::size_t first, std::size_t count) {
      BoxLanes<Chart, Numbers>(chart, signs, &requests[first], count).classify(detail);
    });
  });
}

template <class Chart>
void ChartLanes<Chart>::examine(const Chart& chart, const Signs& signs, int sign, bool shells,
                                const std::vector<SharedFace>& boxes, Examined* examined,
                                InstructionSet instructions) noexcept {
  with_lanes_of(instructions, [&](auto lanes) {
    using Numbers = typename decltype(lanes)::Numbers;
    for_each_group<Numbers>(boxes, [&](std::size_t first, std::size_t count) {
      PartLanes<Chart, Numbers>(chart, signs, sign, &boxes[first], count).examine(shells, examined + first);
    });
  });
}

template <class Chart>
void ChartLanes<Chart>::enclose_index(const IndexQuestion<Chart>& of, const std::vector<IndexRequest>& boxes,
                                      EnclosedIndex* enclosed, InstructionSet instructions) noexcept {
  with_lanes_of(instructions, [&](auto lanes) {
    using Numbers = typename decltype(lanes)::Numbers;
    for_each_group<Numbers>(boxes, [&](std::size_t first, std::size_t count) {
      IndexLanes<Chart, Numbers>(of, &boxes[first], count).enclose(enclosed + first);
    });
  });
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_CODE_H
