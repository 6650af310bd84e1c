// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_EXAMINER_H
#define PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_EXAMINER_H

#include "aspects/batches/box_requests.h"
#include "aspects/boxes/charts.h"
#include "aspects/tree/neighbour_leaves.h"

#include <array>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Whether its boxes are examined in lanes.
template <class Chart>
inline constexpr bool has_part_lanes = false;
template <>
inline constexpr bool has_part_lanes<T2Chart> = true;
template <>
inline constexpr bool has_part_lanes<SE2Chart> = true;
template <>
inline constexpr bool has_part_lanes<T3Chart> = true;

/// Writes for each box what `BoxClassifier::examine` tells of it in the working mode of these signs of B_jj;
/// as many at once as the vectors of this instruction set have lanes, which the processor must have. A live
/// `RoundingUpward` is required.
void examine_in_lanes(const T2Chart& chart, const std::array<int, T2Chart::leg_count>& signs, int sign,
                      bool shells, const std::vector<SharedFace>& boxes, Examined* examined,
                      InstructionSet instructions) noexcept;
void examine_in_lanes(const SE2Chart& chart, const std::array<int, SE2Chart::leg_count>& signs, int sign,
                      bool shells, const std::vector<SharedFace>& boxes, Examined* examined,
                      InstructionSet instructions) noexcept;
void examine_in_lanes(const T3Chart& chart, const std::array<int, T3Chart::leg_count>& signs, int sign,
                      bool shells, const std::vector<SharedFace>& boxes, Examined* examined,
                      InstructionSet instructions) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_EXAMINER_H
