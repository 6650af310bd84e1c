// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BASINS_INDEX_PEAKS_H
#define PARALLEL_ASPECTS_ASPECTS_BASINS_INDEX_PEAKS_H

#include "aspects/map/map_contents.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/basins.h"
#include "parallel_aspects/aspects/map_control.h"

#include <cstddef>
#include <map>

namespace parallel_aspects {

/// An index in one working mode and for one sign of det A.
struct IndexOfMode {
  std::size_t mode;
  int sign;
  ParallelIndex index;
};

/// Of the share of `BoxClassifier::enclose_index`: every enclosure is close enough.
inline constexpr double any_index_gap = 1.0;

/// At one pose; 0 to the largest where it is not known.
IndexRange index_at(const AspectMap::Contents& map, const IndexOfMode& what, const MapPosition& position);

/// No index in the region of the map is larger.
double largest_in_region(const AspectMap::Contents& map, const IndexOfMode& what);

/// A position at which the index is no less than this.
struct IndexPeak {
  double index = 0.0;
  MapPosition at;
};

/// One of each aspect of the mode and sign, by id. Each is as high as steps to neighbours in finer and finer
/// grids lead from the highest of some leaves; others may be higher.
std::map<int, IndexPeak> find_index_peaks(const AspectMap::Contents& map, const IndexOfMode& what,
                                          const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BASINS_INDEX_PEAKS_H
