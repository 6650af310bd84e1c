// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/simd/chart_lanes_code.h"

namespace parallel_aspects {

template void ChartLanes<SO3Chart>::classify(const ChartClassifier<SO3Chart>&, const BoxRequests&, Detail,
                                             InstructionSet) noexcept;
template void ChartLanes<SO3Chart>::enclose_index(const ChartClassifier<SO3Chart>&, std::size_t, int,
                                                  ParallelIndex, const std::vector<IndexRequest>&,
                                                  EnclosedIndex*, InstructionSet) noexcept;

}  // namespace parallel_aspects
