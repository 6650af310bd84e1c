// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_INDEX_H
#define PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_INDEX_H

#include "aspects/batches/box_requests.h"
#include "aspects/boxes/charts.h"
#include "aspects/constraints/margin_tests.h"

#include <array>
#include <vector>

namespace parallel_aspects {

/// Which index of which working mode, by its signs of B_jj, and sign of det A.
template <class Chart>
struct IndexQuestion {
  const Chart& chart;
  const MarginTests<Chart::point_dimension>& margins;
  const std::array<int, Chart::leg_count>& signs;
  int sign;
  ParallelIndex index;
};

struct EnclosedIndex {
  Interval range;
  bool may_be_closer;  ///< by arcs: see IndexOnArcs
};

/// Writes for each box what intervals and affine forms tell of the index; as many at once as the vectors of
/// this instruction set have lanes, which the processor must have. A live `RoundingUpward` is required.
void enclose_index_in_lanes(const IndexQuestion<T2Chart>& of, const std::vector<IndexRequest>& boxes,
                            EnclosedIndex* enclosed, InstructionSet instructions) noexcept;
void enclose_index_in_lanes(const IndexQuestion<SE2Chart>& of, const std::vector<IndexRequest>& boxes,
                            EnclosedIndex* enclosed, InstructionSet instructions) noexcept;
void enclose_index_in_lanes(const IndexQuestion<T3Chart>& of, const std::vector<IndexRequest>& boxes,
                            EnclosedIndex* enclosed, InstructionSet instructions) noexcept;
void enclose_index_in_lanes(const IndexQuestion<SO3Chart>& of, const std::vector<IndexRequest>& boxes,
                            EnclosedIndex* enclosed, InstructionSet instructions) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_INDEX_H
