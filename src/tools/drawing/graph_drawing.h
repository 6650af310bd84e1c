// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_GRAPH_DRAWING_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_GRAPH_DRAWING_H

#include "parallel_aspects/aspects/aspect_graph.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <string>

namespace parallel_aspects::tools {

/// The aspects of a map and the gates between them as SVG: the aspects of each set on a circle, blue where
/// det A is positive and red where it is negative, as large as they are; serial gates in a color for each
/// leg, parallel ones thin and gray, possible ones dashed.
std::string draw_graph(const AspectMap& map, const AspectGraph& graph);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_GRAPH_DRAWING_H
