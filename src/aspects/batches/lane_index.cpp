// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/batches/lane_index.h"

#include "aspects/batches/index_lanes.h"
#include "aspects/batches/lane_versions.h"

namespace parallel_aspects {
namespace {

template <class Chart>
struct IndexWork {
  const IndexQuestion<Chart>& of;
  const IndexRequest* boxes;
  std::size_t count;
  EnclosedIndex* enclosed;
};

template <class Chart>
PARALLEL_ASPECTS_FOR_PAIRS void enclose_pair(const IndexWork<Chart>& work) noexcept {
  IndexLanes<Chart, Lanes<2>>(work.of, work.boxes, work.count).enclose(work.enclosed);
}

template <class Chart>
PARALLEL_ASPECTS_FOR_FOUR void enclose_four(const IndexWork<Chart>& work) noexcept {
  IndexLanes<Chart, Lanes<4>>(work.of, work.boxes, work.count).enclose(work.enclosed);
}

template <class Chart>
PARALLEL_ASPECTS_FOR_EIGHT void enclose_eight(const IndexWork<Chart>& work) noexcept {
  IndexLanes<Chart, Lanes<8>>(work.of, work.boxes, work.count).enclose(work.enclosed);
}

template <class Chart>
void enclose_all(const IndexQuestion<Chart>& of, const std::vector<IndexRequest>& boxes,
                 EnclosedIndex* enclosed, InstructionSet instructions) {
  const std::size_t lanes = lanes_of(instructions);
  for_each_group(boxes, lanes, [&](std::size_t first, std::size_t count) {
    const IndexWork<Chart> work{of, &boxes[first], count, enclosed + first};
    if (lanes == 8) return enclose_eight(work);
    if (lanes == 4) return enclose_four(work);
    enclose_pair(work);
  });
}

}  // namespace

void enclose_index_in_lanes(const IndexQuestion<T2Chart>& of, const std::vector<IndexRequest>& boxes,
                            EnclosedIndex* enclosed, InstructionSet instructions) noexcept {
  enclose_all(of, boxes, enclosed, instructions);
}
void enclose_index_in_lanes(const IndexQuestion<SE2Chart>& of, const std::vector<IndexRequest>& boxes,
                            EnclosedIndex* enclosed, InstructionSet instructions) noexcept {
  enclose_all(of, boxes, enclosed, instructions);
}
void enclose_index_in_lanes(const IndexQuestion<T3Chart>& of, const std::vector<IndexRequest>& boxes,
                            EnclosedIndex* enclosed, InstructionSet instructions) noexcept {
  enclose_all(of, boxes, enclosed, instructions);
}
void enclose_index_in_lanes(const IndexQuestion<SO3Chart>& of, const std::vector<IndexRequest>& boxes,
                            EnclosedIndex* enclosed, InstructionSet instructions) noexcept {
  enclose_all(of, boxes, enclosed, instructions);
}

}  // namespace parallel_aspects
