// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_GRAPH_JOINED_SETS_H
#define PARALLEL_ASPECTS_ASPECTS_GRAPH_JOINED_SETS_H

#include "aspects/map/map_contents.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace parallel_aspects {

/// Sets of aspects that proved serial gates join, by their lowest id, without their workspace. `signs` are
/// those of det A, by id - 1.
std::vector<AspectSet> joined_sets(const std::vector<int>& signs, const std::vector<Neighbours>& gates);

/// Groups the sets of a graph: two sets of one sign are in one group where `may_join(id, id)` is true for an
/// aspect of either.
void group_sets(const std::function<bool(int, int)>& may_join, AspectGraph& graph);

/// By id - 1, a label of each aspect with this sign of det A, and -1 for the others. Where labels differ, no
/// path in the region of the map joins the aspects. Such a path is one on which det A keeps the sign, the
/// legs reach within limits, and the working mode changes only where B_jj = 0.
///
/// Such a path is, at every moment, in a leaf of its working mode that is proved neither outside nor to have
/// the other sign; and where it changes sides of B_jj = 0, in a leaf of either mode where B_jj^2 > 0 is not
/// proved. So all leaves that may hold a part of one path are united: neighbours of one mode, and leaves of
/// two modes that share poses where B_jj may vanish. Aspects of one of the `sets`, which are joined, have one
/// label; the search ends where all have.
std::vector<int> possibly_joined(const AspectMap::Contents& map, const std::vector<AspectSet>& sets, int sign,
                                 const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_GRAPH_JOINED_SETS_H
