// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_H

#include "aspects/boxes/chart_classifier.h"
#include "aspects/boxes/charts.h"
#include "aspects/simd/box_requests.h"
#include "aspects/tree/neighbour_leaves.h"

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

/// Whether its boxes are examined in lanes.
template <class Chart>
inline constexpr bool has_part_lanes = true;
template <>
inline constexpr bool has_part_lanes<SO3Chart> = false;

/// Boxes of one chart, as many at once as the vectors of an instruction set have lanes. The processor must
/// have it, and a live `RoundingUpward` is required. There is a source for each chart: T2, SE2, T3, SO3.
template <class Chart>
struct ChartLanes {
  using Classifier = ChartClassifier<Chart>;

  /// Writes the states of all requests as `BoxClassifier::classify` does, without whole parts of some charts.
  /// For robots whose only constraints are limits of actuated joints.
  static void classify(const Classifier& classifier, const BoxRequests& requests, Detail detail,
                       InstructionSet instructions) noexcept;

  /// Writes for each box what `BoxClassifier::examine` tells of it. For the same robots, and charts that have
  /// this alone.
  static void examine(const Classifier& classifier, std::size_t mode, int sign,
                      const std::vector<SharedFace>& boxes, Examined* examined,
                      InstructionSet instructions) noexcept;

  /// Writes for each box what intervals and affine forms tell of the index.
  static void enclose_index(const Classifier& classifier, std::size_t mode, int sign, ParallelIndex index,
                            const std::vector<IndexRequest>& boxes, EnclosedIndex* enclosed,
                            InstructionSet instructions) noexcept;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_H
