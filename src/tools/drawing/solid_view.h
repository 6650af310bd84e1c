// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_SOLID_VIEW_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_SOLID_VIEW_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "tools/drawing/page.h"

#include <functional>
#include <vector>

namespace parallel_aspects::tools {

/// Adds the aspects of working modes of a map that has surfaces to a page, as shaded bodies of which the half
/// in front is cut away. `checkpoint` is called now and then; it may throw.
void add_solids(const AspectMap& map, const std::vector<WorkingMode>& modes,
                const std::function<void()>& checkpoint, Page& page);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_SOLID_VIEW_H
