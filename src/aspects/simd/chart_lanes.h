// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_H
#define PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_H

#include "aspects/boxes/charts.h"
#include "aspects/constraints/margin_tests.h"
#include "aspects/simd/box_requests.h"
#include "aspects/tree/neighbour_leaves.h"

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

/// Whether its boxes are examined in lanes.
template <class Chart>
inline constexpr bool has_part_lanes = true;
template <>
inline constexpr bool has_part_lanes<SO3Chart> = false;

/// The working modes of a chart, by the signs of B_jj.
template <class Chart>
using ModeSigns = std::vector<std::array<int, Chart::leg_count>>;

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

/// Boxes of one chart, as many at once as the vectors of an instruction set have lanes. The processor must
/// have it, and a live `RoundingUpward` is required. There is a source for each chart: T2, SE2, T3, SO3.
template <class Chart>
struct ChartLanes {
  using Signs = std::array<int, Chart::leg_count>;

  /// Writes the states of all requests as `BoxClassifier::classify` does, without faces, wedges and slopes of
  /// some charts.
  static void classify(const Chart& chart, const ModeSigns<Chart>& signs, const BoxRequests& requests,
                       Detail detail, InstructionSet instructions) noexcept;

  /// Writes for each box what `BoxClassifier::examine` tells of it in the working mode of these signs of
  /// B_jj. For charts that have this alone.
  static void examine(const Chart& chart, const Signs& signs, int sign, bool shells,
                      const std::vector<SharedFace>& boxes, Examined* examined,
                      InstructionSet instructions) noexcept;

  /// Writes for each box what intervals and affine forms tell of the index.
  static void enclose_index(const IndexQuestion<Chart>& of, const std::vector<IndexRequest>& boxes,
                            EnclosedIndex* enclosed, InstructionSet instructions) noexcept;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIMD_CHART_LANES_H
