// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_LEAF_GRAPH_H
#define PARALLEL_ASPECTS_ASPECTS_LEAF_GRAPH_H

#include "parallel_aspects/aspects/box_classifier.h"
#include "parallel_aspects/aspects/disjoint_sets.h"
#include "parallel_aspects/aspects/pose_tree.h"

#include <cstddef>
#include <cstdint>
#include <optional>
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
    std::optional<int> center_sign;  ///< once it was asked for
  };

  /// Two undecided leaves side by side (or twice the same) that are nearest to different components, and the
  /// inside leaf of each that they were reached from.
  struct Contact {
    std::uint32_t vertex, other_vertex;
    NodeIndex leaf, other_leaf;
  };

  /// Where components of one sign meet, along undecided leaves that may have that sign.
  struct Meeting {
    std::vector<NodeIndex>
        nearest;  ///< for each vertex an inside leaf of the component nearest to it, or `no_node`
    std::vector<Contact> contacts;
    std::vector<std::uint32_t>
        hidden;  ///< vertices that no component is near to: small aspects may hide there
  };

  Meeting meeting(const PoseTree& tree, int sign);

  /// Joins the components of two inside leaves, after a proof that they are one.
  void unite(NodeIndex leaf, NodeIndex other) { components_.unite(slot_[leaf], slot_[other]); }

  /// The sign of det A that is proved at the center of an undecided leaf, by `proved_sign`. Needs a live
  /// `RoundingUpward`.
  int center_sign(const PoseTree& tree, const BoxClassifier& classifier, std::uint32_t vertex);

  /// Asks for all of them, so that graphs of several working modes can do so at the same time.
  void find_center_signs(const PoseTree& tree, const BoxClassifier& classifier);

  /// Divides the leaf of a vertex in `tree` and classifies its children.
  void refine(PoseTree& tree, const BoxClassifier& classifier, std::uint32_t vertex);

  std::size_t mode() const noexcept { return mode_; }
  const std::vector<Vertex>& vertices() const noexcept { return vertices_; }

  const std::vector<NodeIndex>& inside_leaves() const noexcept { return inside_leaves_; }

  /// The component of an inside leaf: the same number for all leaves of it, below `inside_leaves().size()`.
  std::uint32_t component(NodeIndex inside_leaf) noexcept { return components_.find(slot_[inside_leaf]); }

 private:
  void add_leaf(const PoseTree& tree, NodeIndex node);
  void connect(const PoseTree& tree, NodeIndex a, NodeIndex b);
  void replace(const PoseTree& tree, NodeIndex old_node, const std::vector<NodeIndex>& children,
               NodeIndex neighbour);
  std::vector<std::uint32_t> start_from_components(const PoseTree& tree, int sign, Meeting& meeting);
  void spread(const PoseTree& tree, int sign, std::vector<std::uint32_t> queue, Meeting& meeting);
  void compare(std::uint32_t v, std::uint32_t w, NodeIndex leaf, NodeIndex other, Meeting& meeting);

  std::size_t mode_;
  std::vector<std::uint32_t> slot_;  // of a node: index among the vertices or among the inside leaves
  std::vector<Vertex> vertices_;
  std::vector<NodeIndex> inside_leaves_;
  DisjointSets components_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_LEAF_GRAPH_H
