// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_CLASSIFIER_H
#define PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_CLASSIFIER_H

#include "aspects/batches/box_requests.h"
#include "aspects/boxes/charts.h"

#include <array>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Whether the whole parts of its boxes are found as well, for all working modes at once, where
/// `Detail::parts` is asked for.
template <class Chart>
inline constexpr bool has_slope_lanes = false;
template <>
inline constexpr bool has_slope_lanes<T2Chart> = true;
template <>
inline constexpr bool has_slope_lanes<SE2Chart> = true;

/// The working modes of a chart, by the signs of B_jj.
template <class Chart>
using ModeSigns = std::vector<std::array<int, Chart::leg_count>>;

/// Writes the states of all requests as `BoxClassifier::classify` does, without faces,
/// wedges and slopes of some charts. As many at once as the vectors of this instruction set have lanes; which
/// the processor must have. A live `RoundingUpward` is required.
void classify_in_lanes(const T2Chart& chart, const ModeSigns<T2Chart>& signs, const BoxRequests& requests,
                       Detail detail, InstructionSet instructions) noexcept;
void classify_in_lanes(const SE2Chart& chart, const ModeSigns<SE2Chart>& signs, const BoxRequests& requests,
                       Detail detail, InstructionSet instructions) noexcept;
void classify_in_lanes(const T3Chart& chart, const ModeSigns<T3Chart>& signs, const BoxRequests& requests,
                       Detail detail, InstructionSet instructions) noexcept;
void classify_in_lanes(const SO3Chart& chart, const ModeSigns<SO3Chart>& signs, const BoxRequests& requests,
                       Detail detail, InstructionSet instructions) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BATCHES_LANE_CLASSIFIER_H
