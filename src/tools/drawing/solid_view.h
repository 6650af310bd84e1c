// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_SOLID_VIEW_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_SOLID_VIEW_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "tools/drawing/page.h"

#include <functional>
#include <vector>

namespace parallel_aspects::tools {

/// Adds the aspects of working modes to a page as shaded bodies, with a quarter cut away: the inside leaves
/// of a map of three coordinates, rounded for the eye by about a point of a grid; of orientations, in the
/// ball of rotation vectors.
void add_solids(const AspectMap& map, const std::vector<WorkingMode>& modes,
                const std::function<void()>& checkpoint, Page& page);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_SOLID_VIEW_H
