// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_BASINS_DRAWING_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_BASINS_DRAWING_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/basins.h"

#include <string>

namespace parallel_aspects::tools {

/// The basins of a map as SVG: a bar for each, over the index, from where it merges into a deeper one to its
/// largest. What lies between the proved bounds of an end is light. A line leads to the deeper one.
std::string draw_basins(const AspectMap& map, const MapBasins& basins);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_BASINS_DRAWING_H
