// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BASINS_H
#define PARALLEL_ASPECTS_ASPECTS_BASINS_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/singularity/indices.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What is proved of an index: it is no less than `lower` and no more than `upper`.
struct IndexRange {
  double lower = 0.0;                                      ///< 0 where nothing is proved
  double upper = std::numeric_limits<double>::infinity();  ///< infinite where nothing is proved
};

/// A part of an aspect that is deep: around its deepest pose the index is proved to be higher than on any
/// path to a deeper part. As a margin from parallel singularities grows, an aspect falls apart into its
/// basins.
struct Basin {
  int aspect = 0;    ///< id
  Pose deepest;      ///< where the index is the lower end of `depth` or more
  IndexRange depth;  ///< the largest index on any path from there that stays above `saddle.upper`

  /// Index, in the list, of the deeper basin that it is connected with first as the margin falls; none where
  /// the index is not proved to be higher in it than on the way to a deeper one.
  std::optional<std::size_t> deeper;

  /// The largest index that a path to that basin can keep; its lower end is 0 where the two are not proved to
  /// lie in one aspect. Below the lower end of `depth`.
  IndexRange saddle;
};

/// How deep the aspects of a map are, and how well they are connected.
struct MapBasins {
  ParallelIndex index = ParallelIndex::normalised;  ///< by which all of it is measured

  /// The largest index in each aspect, by id - 1, and in what is connected with it and in no other aspect
  /// that is listed.
  std::vector<IndexRange> deepest;

  /// The largest index that a path between the two aspects of each pair of `AspectMap::unresolved` can keep,
  /// in that order. Its lower end is 0.
  std::vector<IndexRange> bottlenecks;

  std::vector<Basin> basins;  ///< where asked for: by working mode and sign of det A, the deepest first
};

/// How much is looked for.
enum class BasinDetail {
  depths,  ///< no basins
  basins,  ///< all, in about three times the time
};

/// Finds them in the leaves of a map, by two passes over them: by falling lower and by falling upper bounds
/// of the index. Nothing when cancelled.
std::optional<MapBasins> find_basins(const AspectMap& map, ParallelIndex index, BasinDetail detail,
                                     const MapControl& control = {});

/// What is known of the paths between two poses of a map.
enum class BottleneckStatus {
  found,          ///< they lie in one aspect or could do so
  separate,       ///< proved: no path in the region of the map connects them
  not_in_aspect,  ///< one of them is not proved to lie in an aspect, or the signs of det A differ
  cancelled,
};

/// The largest index that a path between two poses can keep.
struct Bottleneck {
  BottleneckStatus status = BottleneckStatus::not_in_aspect;  ///< what is known
  std::string message;                                        ///< why, unless found
  IndexRange index;        ///< where found; its lower end is 0 where they are not proved to be connected
  std::size_t halved = 0;  ///< how many boxes were divided for it
};

/// How precisely it is looked for. The search ends where the bounds differ by no more than the larger of
/// `relative` and `absolute`, or have taken too much work; they hold either way.
struct BottleneckPrecision {
  double relative = 0.05;        ///< of the upper bound
  double absolute = 0.001;       ///< of the normalised index; for |det A|, whose unit varies, none
  std::size_t boxes = 400000;    ///< that are divided at most
  std::size_t visits = 2000000;  ///< of boxes while paths are looked for, after which no more are divided
};

/// Looks for it in one working mode, within the region of the map, dividing leaves where that matters.
Bottleneck find_bottleneck(const AspectMap& map, const WorkingMode& mode, const Pose& from, const Pose& to,
                           ParallelIndex index, const BottleneckPrecision& precision = {},
                           const MapControl& control = {});

/// "parallel" or "det_a", as questions name them.
const char* name(ParallelIndex index) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BASINS_H
