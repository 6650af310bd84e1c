// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SIGN_GRAPH_H
#define PARALLEL_ASPECTS_ASPECTS_SIGN_GRAPH_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/box_classifier.h"
#include "parallel_aspects/aspects/disjoint_sets.h"
#include "parallel_aspects/aspects/part_proof.h"
#include "parallel_aspects/aspects/pose_tree.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// How the leaves of one working mode s that may hold poses of S(s, sigma) hang together, for one sigma.
///
/// Leaves that are inside, and whole parts of undecided leaves, are joined to *components*, each proved
/// connected: an inside leaf with everything of S(s, sigma) in leaves that share a face with it, two whole
/// parts where their common face is proved to hold poses of both. All other leaves are *open*: what of
/// S(s, sigma) is in them, and how it hangs together, is not known.
class SignGraph {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// Long work ends early, and unfinished, when `control` says that it is cancelled; it must outlive this.
  SignGraph(std::size_t mode, int sign, const MapControl& control)
      : mode_(mode), sign_(sign), control_(control) {}

  int sign() const noexcept { return sign_; }

  /// Takes in a leaf, if it may hold poses of the set; then tell it from all its neighbours by `connect`.
  void add_leaf(const PoseTree& tree, NodeIndex node);
  void connect(const PoseTree& tree, NodeIndex a, NodeIndex b);

  /// Joins what is proved to hang together across faces of whole parts, and forgets faces that are proved to
  /// hold nothing of the set. Needs a live `RoundingUpward`.
  void settle_faces(const PoseTree& tree, const BoxClassifier& classifier);

  /// After a leaf was divided and its children were classified.
  void replace(PoseTree& tree, NodeIndex node);

  /// Joins components that are new since the last call to others by a `Climb`. Returns leaves of those that
  /// have no inside leaf after that. Needs a live `RoundingUpward`.
  std::vector<NodeIndex> climb_from_new(PoseTree& tree, const BoxClassifier& classifier);

  /// Forgets a whole part that is proved empty.
  void drop(PoseTree& tree, NodeIndex node);

  /// Two leaves through which two components could hang together, and the leaf of each component that is
  /// nearest to them.
  struct Contact {
    NodeIndex node, other_node;
    NodeIndex leaf, other_leaf;
  };

  struct Meeting {
    std::vector<NodeIndex> nearest;  ///< a leaf of the component nearest to each open leaf, or `no_node`
    std::vector<Contact> contacts;
    std::vector<NodeIndex> hidden;  ///< open leaves that no component is near to: aspects may hide there
  };
  Meeting meeting();

  /// An undecided leaf of which it is not known what it holds.
  struct OpenLeaf {
    NodeIndex node = no_node;  ///< no_node once it was divided
    std::vector<NodeIndex> neighbours;
  };
  const std::vector<OpenLeaf>& open_leaves() const noexcept { return open_; }

  bool is_in_component(NodeIndex node) const noexcept { return (slot_[node] & open_flag) == 0; }

  /// The component of a leaf that is in one: the same number for all leaves of it.
  std::uint32_t component(NodeIndex node) noexcept { return components_.find(slot_[node]); }

  /// More than the number of any component.
  std::size_t component_bound() const noexcept { return components_.size(); }

 private:
  static constexpr std::uint32_t open_flag = 0x80000000U;

  bool is_open(NodeIndex node) const noexcept { return slot_[node] != none && !is_in_component(node); }
  OpenLeaf& open_leaf(NodeIndex node) noexcept { return open_[slot_[node] & ~open_flag]; }

  struct Traits {
    bool has_inside_leaf, climbed;
  };

  void unite(NodeIndex a, NodeIndex b);
  Part witness(const PoseTree& tree, const BoxClassifier& classifier, NodeIndex leaf) const;
  std::uint32_t largest_component(const std::vector<NodeIndex>& leaves);
  void climb(const PoseTree& tree, const BoxClassifier& classifier, NodeIndex leaf, const MapPoint& pose);
  void settle(const PoseTree& tree, const BoxClassifier& classifier, NodeIndex a, NodeIndex b);
  void replace_whole(PoseTree& tree, NodeIndex node, const std::vector<NodeIndex>& children);
  void forget_neighbour(NodeIndex node, NodeIndex old_neighbour);
  void start_from_components(Meeting& meeting, std::vector<std::uint32_t>& queue);
  void spread(Meeting& meeting, std::vector<std::uint32_t>& queue);
  void compare(const Contact& contact, Meeting& meeting);

  std::size_t mode_;
  int sign_;
  const MapControl& control_;
  std::vector<std::uint32_t> slot_;  // of a node: element of `components_`, or open leaf with `open_flag`
  DisjointSets components_;
  std::vector<Traits> traits_;  // by component
  std::vector<OpenLeaf> open_;
  bool has_climbed_ = false;
  std::vector<NodeIndex> new_leaves_;                   // in components, since the last climb
  std::vector<std::pair<NodeIndex, NodeIndex>> faces_;  // between whole parts, not settled
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SIGN_GRAPH_H
