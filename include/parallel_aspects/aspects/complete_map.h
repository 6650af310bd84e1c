// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPLETE_MAP_H
#define PARALLEL_ASPECTS_ASPECTS_COMPLETE_MAP_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/map_control.h"

#include <memory>

namespace parallel_aspects {

/// The same as `compute_aspect_map`, but a map of all poses with three degrees of freedom looks into every
/// leaf in which an aspect could hide that is smaller than the resolution, so that `AspectMap::count_at_most`
/// may be known. That takes many times as long as the rest (docs/maps.md). With fewer degrees of freedom all
/// maps do so.
MapResult compute_complete_map(std::shared_ptr<const Manipulator> manipulator, const MapOptions& options = {},
                               const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPLETE_MAP_H
