// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_GATE_ROUTE_H
#define PARALLEL_ASPECTS_MOTION_PLAN_GATE_ROUTE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/motion/plan_path.h"

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// A pose in an aspect.
struct PoseInAspect {
  Pose pose;
  int aspect = 0;            // id
  std::vector<Pose> lead{};  // of an end that another pose leads into: from that pose to this one
};

/// One crossing of one gate, by index in their lists.
struct GateStep {
  std::size_t gate = 0, crossing = 0;
};

/// Through which gates to go, and where to begin and to end, by index in lists of either.
struct GateRoute {
  std::size_t start = 0, goal = 0;
  std::vector<GateStep> steps;

  /// The stretches within one aspect: to the first gate, from each to the next, and from the last one. Places
  /// are numbered by the search.
  std::vector<std::pair<std::size_t, std::size_t>> stretches;
};

/// Stretches within one aspect that were tried in vain.
using BarredStretches = std::set<std::pair<std::size_t, std::size_t>>;

/// Which gates may be passed.
struct GateChoice {
  PathPolicy policy = PathPolicy::stay;
  bool is_clear = false;  // of each gate the best crossing alone
};

/// The proved gates from one of the starts to one of the goals, such that the path is short as the crow
/// flies, with a cost for each change of the working mode and each loss of control of the platform; nothing
/// where there is none.
std::optional<GateRoute> find_gate_route(const AspectMap& map, const AspectGraph& graph,
                                         const std::vector<PoseInAspect>& starts,
                                         const std::vector<PoseInAspect>& goals, const GateChoice& choice,
                                         const BarredStretches& barred);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_GATE_ROUTE_H
