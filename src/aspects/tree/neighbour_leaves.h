// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_TREE_NEIGHBOUR_LEAVES_H
#define PARALLEL_ASPECTS_ASPECTS_TREE_NEIGHBOUR_LEAVES_H

#include "aspects/tree/pose_space.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Which children of two neighbours face each other: ranks in the first, and across the face in the second.
using FacingRanks = std::vector<std::pair<NodeIndex, NodeIndex>>;

/// For neighbours along a coordinate of one root box, the one at smaller coordinates first.
FacingRanks facing_ranks(std::size_t dimension, std::size_t axis);

/// For neighbours across a glued face.
FacingRanks facing_ranks(std::size_t dimension, const Gluing& gluing);

/// Visits every pair of leaves of one working mode that share part of a face, in time linear in their number;
/// glued faces included. Leaves that are proved outside are passed over.
template <class Visitor>
class FaceTraversal {
 public:
  /// Calls `visitor(NodeIndex, NodeIndex)`.
  FaceTraversal(const PoseTree& tree, std::size_t mode, Visitor visitor, const MapControl& control)
      : tree_(tree), mode_(mode), visitor_(visitor), control_(control) {
    for (std::size_t axis = 0; axis < tree.dimension(); ++axis)
      along_.push_back(facing_ranks(tree.dimension(), axis));
  }

  void run() {
    for (RootIndex root = 0; root < tree_.root_count(); ++root) inside(root);
    for (const Gluing& gluing : tree_.space().gluings())
      across(facing_ranks(tree_.dimension(), gluing), gluing.first.root, gluing.second.root);
  }

 private:
  bool divided(NodeIndex node) const { return tree_.state(node, mode_).is_divided(); }
  bool outside(NodeIndex node) const { return tree_.state(node, mode_).is_outside(); }

  void inside(NodeIndex node) {
    if (!divided(node) || is_cancelled(control_)) return;
    const NodeIndex first = tree_.first_child(node);
    for (NodeIndex rank = 0; rank < tree_.children_per_node(); ++rank) inside(first + rank);
    for (const FacingRanks& facing : along_)
      for (const auto& [upper, lower] : facing) across(facing, first + lower, first + upper);
  }

  void across(const FacingRanks& facing, NodeIndex a, NodeIndex b) {
    if (outside(a) || outside(b)) return;
    const bool a_divided = divided(a), b_divided = divided(b);
    if (!a_divided && !b_divided) return visitor_(a, b);
    for (const auto& [rank_a, rank_b] : facing)
      across(facing, a_divided ? tree_.first_child(a) + rank_a : a,
             b_divided ? tree_.first_child(b) + rank_b : b);
  }

  const PoseTree& tree_;
  std::size_t mode_;
  Visitor visitor_;
  const MapControl& control_;
  std::vector<FacingRanks> along_;
};

/// Ends early when cancelled.
template <class Visitor>
void visit_faces(const PoseTree& tree, std::size_t mode, const Visitor& visitor,
                 const MapControl& control = {}) {
  FaceTraversal<Visitor>(tree, mode, visitor, control).run();
}

/// One of the faces of a node: that at the lower or at the upper end of a coordinate.
struct NodeFace {
  std::size_t axis = 0;
  bool upper = false;
};

/// The place of the same level on the other side of a face, glued faces of the space included; nothing where
/// the space ends there.
std::optional<NodePlace> place_across(const PoseSpace& space, const NodePlace& place,
                                      const NodeFace& face) noexcept;

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
