// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_GATE_ROUTE_H
#define PARALLEL_ASPECTS_MOTION_PLAN_GATE_ROUTE_H

#include "parallel_aspects/aspects/aspect_graph.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/model/pose.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A pose in an aspect.
struct PoseInAspect {
  Pose pose;
  int aspect = 0;  // id
};

/// Through which gates to go, and where to begin and to end, by index in lists of either.
struct GateRoute {
  std::size_t start = 0, goal = 0;
  std::vector<std::size_t> gates;
};

/// The proved serial gates from one of the starts to one of the goals, such that the way is short as the crow
/// flies and changes the working mode no more often than that is worth; nothing where there is none.
std::optional<GateRoute> find_gate_route(const AspectMap& map, const AspectGraph& graph,
                                         const std::vector<PoseInAspect>& starts,
                                         const std::vector<PoseInAspect>& goals);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_GATE_ROUTE_H
