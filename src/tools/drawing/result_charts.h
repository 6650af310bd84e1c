// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_DRAWING_RESULT_CHARTS_H
#define PARALLEL_ASPECTS_TOOLS_DRAWING_RESULT_CHARTS_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "tools/motion_report/check_table.h"

#include <string>
#include <vector>

// Charts of results that have no picture in the plane, as SVG.
namespace parallel_aspects::tools {

/// The basins of a map: a bar for each, over the index, from where it merges into a deeper one to its
/// largest. What lies between the proved bounds of an end is light. A line leads to the deeper one.
std::string draw_basins(const AspectMap& map, const MapBasins& basins);

/// The aspects of a map and the gates between them: the aspects of each set on a circle, blue where det A is
/// positive and red where it is negative, as large as they are; serial gates in a color for each leg,
/// parallel ones thin and gray, possible ones dashed.
std::string draw_graph(const AspectMap& map, const AspectGraph& graph);

/// The samples of a check over time: the indices, the distances where there are any, and lines at the
/// crossings.
std::string draw_check(const Manipulator& manipulator, const TrajectoryCheck& check,
                       const std::vector<SampleDistances>& distances);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_DRAWING_RESULT_CHARTS_H
