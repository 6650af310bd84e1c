// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_MAP_DEEPEST_POINT_H
#define PARALLEL_ASPECTS_ASPECTS_MAP_DEEPEST_POINT_H

#include "aspects/map/map_contents.h"

#include <cstddef>

namespace parallel_aspects {

/// A position and the radius of a ball around it, in the weighted coordinates of its `PoseSpace`.
struct ClearPoint {
  MapPosition position;
  double clearance = 0.0;
};

/// Distance from a position to the nearest leaf of its working mode that is not an inside leaf of this
/// aspect, or to a face of its root box that no periodic coordinate goes through; 0 outside the aspect. Where
/// it is no more than `of_interest` only that is reported: it is then somewhat larger, but no more than that.
double clearance(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode,
                 const MapPosition& position, double of_interest = 0.0);

/// The center of the largest ball within the inside leaves of an aspect, within one part in a hundred of the
/// radius, or one in ten after 20,000 boxes (best-first search with a Lipschitz bound, as "polylabel" does
/// for polygons). Ends early when cancelled.
ClearPoint deepest_point(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode,
                         const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_MAP_DEEPEST_POINT_H
