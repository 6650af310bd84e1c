// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_NEIGHBOUR_LEAVES_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_NEIGHBOUR_LEAVES_H

#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/box.h"

#include <cstddef>
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

/// Whether there are any.
bool share_face(const PoseTree& tree, NodeIndex a, NodeIndex b);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_TREE_NEIGHBOUR_LEAVES_H
