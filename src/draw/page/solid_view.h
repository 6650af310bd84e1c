// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_PAGE_SOLID_VIEW_H
#define PARALLEL_ASPECTS_DRAW_PAGE_SOLID_VIEW_H

#include "draw/page/page.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <functional>
#include <memory>
#include <vector>

namespace parallel_aspects {

/// Adds the aspects of working modes of a map that has surfaces to a page, as shaded bodies of which the half
/// in front is cut away. `checkpoint` is called now and then; it may throw.
void add_solids(const std::shared_ptr<const AspectMap>& map, const std::vector<WorkingMode>& modes,
                const std::function<void()>& checkpoint, Page& page);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_PAGE_SOLID_VIEW_H
