// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_LEAF_GRAPH_H
#define PARALLEL_ASPECTS_ASPECTS_LEAF_GRAPH_H

#include "parallel_aspects/aspects/box_classifier.h"
#include "parallel_aspects/aspects/disjoint_sets.h"
#include "parallel_aspects/aspects/pose_tree.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The leaves of one working mode that are not outside, joined where they share part of a face: inside leaves
/// of one sign merge into components, undecided leaves are vertices of their own.
class LeafGraph {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  LeafGraph(const PoseTree& tree, std::size_t mode);

  /// An undecided leaf.
  struct Vertex {
    NodeIndex node = no_node;  ///< no_node once it was divided
    std::vector<NodeIndex> neighbours;
  };

  /// Where components of one sign meet: for each vertex the component (root) nearest to it along undecided
  /// leaves of that sign, or `none`; and the vertices where two components meet, with the pairs that do.
  struct Meeting {
    std::vector<std::uint32_t> nearest;
    std::vector<std::uint32_t> contested;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::vector<std::uint32_t>
        hidden;  ///< vertices of that sign that no component is near to: small aspects may hide
  };

  Meeting meeting(const PoseTree& tree, int sign);

  /// Divides the leaf of a vertex in `tree` and classifies its children.
  void refine(PoseTree& tree, const BoxClassifier& classifier, std::uint32_t vertex);

  const std::vector<Vertex>& vertices() const noexcept { return vertices_; }

  /// Inside leaves; the index is what `component` takes.
  const std::vector<NodeIndex>& inside_leaves() const noexcept { return inside_leaves_; }

  /// The root of the component of an inside leaf, by its index in `inside_leaves()`.
  std::uint32_t component(std::uint32_t inside_leaf) noexcept { return components_.find(inside_leaf); }

 private:
  void add_leaf(const PoseTree& tree, NodeIndex node);
  void connect(const PoseTree& tree, NodeIndex a, NodeIndex b);
  void replace(const PoseTree& tree, NodeIndex old_node, const std::vector<NodeIndex>& children,
               NodeIndex neighbour);
  void start_from_components(const PoseTree& tree, int sign, Meeting& meeting,
                             std::vector<std::uint32_t>& queue);

  std::size_t mode_;
  std::vector<std::uint32_t> slot_;  // of a node: index among the vertices or among the inside leaves
  std::vector<Vertex> vertices_;
  std::vector<NodeIndex> inside_leaves_;
  DisjointSets components_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_LEAF_GRAPH_H
