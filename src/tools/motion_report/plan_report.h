// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_PLAN_REPORT_H
#define PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_PLAN_REPORT_H

#include "parallel_aspects/aspects/aspect_graph.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/motion/plan_path.h"
#include "parallel_aspects/motion/roadmap_graph.h"
#include "tools/report/report.h"

#include <optional>
#include <string>

namespace parallel_aspects::tools {

/// `aspects graph`: gates, and the sets of aspects that they join.
Report report_graph(const AspectMap& map, const AspectGraph& graph);

/// The same over a roadmap, whose components are the nodes.
Report report_graph(const PoseRoadmap& roadmap, const RoadmapGraph& found);

/// The graph in the language of Graphviz: a node for each aspect, a box for each set, an edge for each gate;
/// those that are not proved are dashed, and those through det A = 0 red.
std::string graph_as_dot(const AspectMap& map, const AspectGraph& graph);
std::string graph_as_dot(const RoadmapGraph& found);

/// `aspects plan`: the path, or why there is none.
Report report_path(const Manipulator& manipulator, const PlannedPath& path, const PathWish& wish,
                   const std::optional<MapSlice>& slice);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_MOTION_REPORT_PLAN_REPORT_H
