// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FACE_TRAVERSAL_H
#define PARALLEL_ASPECTS_ASPECTS_FACE_TRAVERSAL_H

#include "parallel_aspects/aspects/pose_tree.h"

#include <cstddef>

namespace parallel_aspects {

/// Visits every pair of leaves of one working mode that share part of a face, once, in time linear in their
/// number. Leaves that are proved outside are passed over.
template <class Visitor>
class FaceTraversal {
 public:
  /// Calls `visitor(NodeIndex, NodeIndex)`, the leaf at smaller coordinates first.
  FaceTraversal(const PoseTree& tree, std::size_t mode, Visitor visitor)
      : tree_(tree), mode_(mode), visitor_(visitor) {}

  void run() { inside(0); }

 private:
  bool divided(NodeIndex node) const { return tree_.state(node, mode_).is_divided(); }
  bool outside(NodeIndex node) const { return tree_.state(node, mode_) == LeafState::outside(); }

  void inside(NodeIndex node) {
    if (!divided(node)) return;
    const NodeIndex first = tree_.first_child(node);
    for (NodeIndex rank = 0; rank < tree_.children_per_node(); ++rank) {
      inside(first + rank);
      for (NodeIndex axis_bit = 1; axis_bit < tree_.children_per_node(); axis_bit <<= 1)
        if ((rank & axis_bit) == 0) across(axis_bit, first + rank, first + rank + axis_bit);
    }
  }

  void across(NodeIndex axis_bit, NodeIndex low, NodeIndex high) {
    if (outside(low) || outside(high)) return;
    const bool low_divided = divided(low), high_divided = divided(high);
    if (!low_divided && !high_divided) return visitor_(low, high);
    for (NodeIndex rank = 0; rank < tree_.children_per_node(); ++rank) {
      if ((rank & axis_bit) != 0) continue;
      across(axis_bit, low_divided ? tree_.first_child(low) + rank + axis_bit : low,
             high_divided ? tree_.first_child(high) + rank : high);
    }
  }

  const PoseTree& tree_;
  std::size_t mode_;
  Visitor visitor_;
};

template <class Visitor>
void visit_faces(const PoseTree& tree, std::size_t mode, const Visitor& visitor) {
  FaceTraversal<Visitor>(tree, mode, visitor).run();
}

/// Whether two nodes, neither inside the other, share part of a face (more than an edge or a corner).
bool share_face(const PoseTree& tree, NodeIndex a, NodeIndex b) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FACE_TRAVERSAL_H
