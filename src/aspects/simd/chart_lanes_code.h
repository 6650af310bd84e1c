// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_CODE_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_CODE_H

#include "aspects/boxes/box_proofs.h"
#include "aspects/simd/chart_lanes.h"
#include "interval/lanes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// The members of ChartLanes. A source that has them compiled for one chart takes ten seconds.

namespace parallel_aspects {

/// Calls `act(first, count, at)` with parts of a row of boxes, each of one root and with a lane for each box;
/// the first is in the lanes that are left.
template <class Numbers, class Chart, class Boxes, class Act>
void for_each_group(const ChartClassifier<Chart>& classifier, const Boxes& boxes, const Act& act) {
  std::array<IntervalLanes<Numbers>, Chart::coordinate_count> ranges;
  for (std::size_t first = 0; first < boxes.size();) {
    const std::size_t end = std::min(boxes.size(), first + lane_count<Numbers>);
    std::size_t last = first + 1;
    while (last < end && boxes[last].root == boxes[first].root) ++last;
    outlined<Numbers>([&] {
      for (std::size_t i = 0; i < lane_count<Numbers>; ++i)
        for (std::size_t k = 0; k < ranges.size(); ++k) {
          const Box& box = boxes[first + i < last ? first + i : first].box;
          ranges[k].set_lane(i, Interval(box.lower[k], box.upper[k]));
        }
      act(first, last - first,
          ChartBox<Chart, Numbers>{classifier.chart(), classifier.tests(), boxes[first].root, ranges});
    });
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
void ChartLanes<Chart>::classify(const Classifier& classifier, const BoxRequests& requests, Detail detail,
                                 InstructionSet instructions) noexcept {
  with_lanes_of(instructions, [&](auto lanes) {
    using Numbers = typename decltype(lanes)::Numbers;
    for_each_group<Numbers>(classifier, requests, [&](std::size_t first, std::size_t count, const auto& at) {
      BitsOf<Numbers> modes{};
      for (std::size_t i = 0; i < count; ++i) modes[i] = static_cast<std::int64_t>(requests[first + i].modes);
      StatesByMode<Chart, Numbers> found(classifier.signs(), modes);
      found.template find<has_slope_lanes<Chart>>(at, detail, classifier.policy());
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t mode = 0; mode < classifier.signs().size(); ++mode)
          if ((requests[first + i].modes >> mode & 1U) != 0)
            requests[first + i].states[mode] = state_of(found[mode][i]);
    });
  });
}

template <class Chart>
void ChartLanes<Chart>::examine(const Classifier& classifier, std::size_t mode, int sign,
                                const std::vector<SharedFace>& boxes, Examined* examined,
                                InstructionSet instructions) noexcept {
  with_lanes_of(instructions, [&](auto lanes) {
    using Numbers = typename decltype(lanes)::Numbers;
    for_each_group<Numbers>(classifier, boxes, [&](std::size_t first, std::size_t count, const auto& at) {
      const ExaminedBoxes<Chart, Numbers> found(at, classifier.signs()[mode], sign,
                                                classifier.policy().shells);
      for (std::size_t i = 0; i < count; ++i) examined[first + i] = found.lane(i);
    });
  });
}

template <class Chart>
void ChartLanes<Chart>::enclose_index(const Classifier& classifier, std::size_t mode, int sign,
                                      ParallelIndex index, const std::vector<IndexRequest>& boxes,
                                      EnclosedIndex* enclosed, InstructionSet instructions) noexcept {
  with_lanes_of(instructions, [&](auto lanes) {
    using Numbers = typename decltype(lanes)::Numbers;
    for_each_group<Numbers>(classifier, boxes, [&](std::size_t first, std::size_t count, const auto& at) {
      Numbers share{};
      for (std::size_t i = 0; i < count; ++i) share[i] = boxes[first + i].share;
      const BoundedIndices<Chart, Numbers> found(at, classifier.signs()[mode], sign, index, share);
      for (std::size_t i = 0; i < count; ++i) enclosed[first + i] = found.lane(i);
    });
  });
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_CODE_H
