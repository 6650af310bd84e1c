// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_GRAPH_JOINED_SETS_H
#define PARALLEL_ASPECTS_ASPECTS_GRAPH_JOINED_SETS_H

#include "parallel_aspects/aspects/aspect_graph.h"
#include "parallel_aspects/aspects/neighbours.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace parallel_aspects {

/// Sets of aspects that proved serial gates join, by their lowest id, without their workspace. `signs` are
/// those of det A, by id - 1.
std::vector<AspectSet> joined_sets(const std::vector<int>& signs, const std::vector<Neighbours>& gates);

/// Groups the sets of a graph: those of one sign of which `may_join(id, id)`, of an aspect of either, says
/// that they may be joined.
void group_sets(const std::function<bool(int, int)>& may_join, AspectGraph& graph);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_GRAPH_JOINED_SETS_H
