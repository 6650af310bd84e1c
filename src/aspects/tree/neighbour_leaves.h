// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_NEIGHBOUR_LEAVES_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_NEIGHBOUR_LEAVES_H

#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/box.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The leaves of one working mode that share part of a face with `node`, a leaf of that mode or one that has
/// just been divided, and are not outside; glued faces included. Each once or, where they share more than one
/// face, more often.
std::vector<NodeIndex> neighbour_leaves(const PoseTree& tree, std::size_t mode, NodeIndex node);

/// A flat box in the coordinates of a root.
struct SharedFace {
  RootIndex root;
  Box box;
};

/// What two nodes, neither inside the other, share: parts of faces; glued ones in the coordinates of one
/// side.
std::vector<SharedFace> shared_faces(const PoseTree& tree, NodeIndex a, NodeIndex b);

using NodePairs = std::vector<std::pair<NodeIndex, NodeIndex>>;

/// Pairs of one of some nodes and one of others, none of which is inside another, that share part of a face;
/// in the order of the first ones, and of the others.
NodePairs faces_between(const PoseTree& tree, const std::vector<NodeIndex>& ones,
                        const std::vector<NodeIndex>& others);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_NEIGHBOUR_LEAVES_H
