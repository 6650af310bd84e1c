// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_PLAN_LEAF_PASSAGES_H
#define PARALLEL_ASPECTS_MOTION_PLAN_LEAF_PASSAGES_H

#include "aspects/map/map_contents.h"
#include "parallel_aspects/model/pose.h"

#include <unordered_map>
#include <vector>

namespace parallel_aspects {

class FaceComponents;

/// From an inside leaf to another one of the aspect, which may share no face with it.
struct LeafPassage {
  NodeIndex to = no_node;
  std::vector<Pose> poses;  ///< the first in the one leaf, the last in the other
};

/// Those that begin in a leaf.
using LeafPassages = std::unordered_map<NodeIndex, std::vector<LeafPassage>>;

/// From this inside leaf through one undecided leaf beside both, where its faces to them are nearest to each
/// other, maybe in one pose; whether the segment is free is not proved.
std::vector<LeafPassage> passages_beside(const AspectMap::Contents& map, const Aspect& aspect,
                                         NodeIndex leaf);

/// Climbs, as those by which a map joins what no faces of inside leaves connect, from parts other than the
/// largest to the first leaf of another part, and back. Each segment is proved.
LeafPassages climbs_between_parts(const AspectMap::Contents& map, const Aspect& aspect,
                                  FaceComponents& components);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_PLAN_LEAF_PASSAGES_H
