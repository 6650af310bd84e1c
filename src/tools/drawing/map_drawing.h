// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_MAP_DRAWING_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_MAP_DRAWING_H

#include "parallel_aspects/aspects/aspect_map.h"

#include <string>

namespace parallel_aspects::tools {

/// A map with two coordinates as SVG: a panel for each working mode, with the inside leaves of each aspect in
/// a colour of its own, its id where there is room, and undecided leaves in grey.
std::string draw_map(const AspectMap& map);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_MAP_DRAWING_H
