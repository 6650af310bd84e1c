// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/leaf_graph.h"

#include "aspects/tree/face_traversal.h"
#include "aspects/tree/neighbour_leaves.h"

namespace parallel_aspects {

LeafGraph::LeafGraph(const PoseTree& tree, std::size_t mode, bool looks_everywhere, const MapControl& control,
                     const ComponentPolicy& policy)
    : mode_(mode),
      looks_everywhere_(looks_everywhere),
      positive_(mode, 1, control, policy),
      negative_(mode, -1, control, policy) {
  SignGraph::LeafCounts positive, negative;
  for (NodeIndex node = 0; node < tree.node_count(); ++node) {
    positive.add(node, tree.state(node, mode), 1);
    negative.add(node, tree.state(node, mode), -1);
  }
  positive_.reserve(tree, positive);
  negative_.reserve(tree, negative);
  for (NodeIndex node = 0; node < tree.node_count() && !is_cancelled(control); ++node) {
    positive_.add_leaf(node, tree.state(node, mode));
    negative_.add_leaf(node, tree.state(node, mode));
  }
  // Most leaves may hold poses of one sign alone, which their states tell sooner than the graph of the other.
  const auto connect = [this, &tree, mode](NodeIndex a, NodeIndex b) {
    const LeafState one = tree.state(a, mode), other = tree.state(b, mode);
    if (one.may_be(1) && other.may_be(1)) positive_.connect(tree, a, b);
    if (one.may_be(-1) && other.may_be(-1)) negative_.connect(tree, a, b);
  };
  if (!is_cancelled(control)) visit_faces(tree, mode, connect, control);
}

void LeafGraph::replace(PoseTree& tree, NodeIndex node) {
  const std::vector<NodeIndex> neighbours = neighbour_leaves(tree, mode_, node);
  std::vector<NodeIndex> children;
  for (NodeIndex rank = 0; rank < tree.children_per_node(); ++rank)
    if (const NodeIndex child = tree.first_child(node) + rank; !tree.state(child, mode_).is_outside())
      children.push_back(child);
  const NodePairs faces = faces_between(tree, children, neighbours);
  positive_.replace(tree, node, neighbours, faces);
  negative_.replace(tree, node, neighbours, faces);
}

}  // namespace parallel_aspects
