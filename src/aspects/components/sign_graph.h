// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_SIGN_GRAPH_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_SIGN_GRAPH_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/boxes/part_proof.h"
#include "aspects/components/component_policy.h"
#include "aspects/components/disjoint_sets.h"
#include "aspects/components/leaf_numbers.h"
#include "aspects/tree/neighbour_leaves.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// How the leaves of one working mode s that may hold poses of S(s, sigma) are connected, for one sigma.
///
/// Leaves that are inside, and whole parts of undecided leaves, are joined to *components*, each proved
/// connected: an inside leaf with everything of S(s, sigma) in leaves that share a face with it, two whole
/// parts where their common face is proved to hold poses of both. All other leaves are *indeterminate*: what
/// of S(s, sigma) is in them, and how it is connected, is not known.
class SignGraph {
 public:
  static constexpr std::uint32_t none = NodeNumbers::none;

  /// Long work ends early, and unfinished, when `control` says that it is cancelled; it
  /// and the policy must outlive this.
  SignGraph(std::size_t mode, int sign, const MapControl& control, const ComponentPolicy& policy)
      : mode_(mode), sign_(sign), control_(control), policy_(policy) {}

  int sign() const noexcept { return sign_; }

  /// How many leaves of a tree are to be added.
  struct LeafCounts {
    std::size_t indeterminate = 0, in_components = 0, blocks = 0;
    NodeIndex last_block = no_node;

    void add(NodeIndex node, LeafState state, int sign) noexcept;
  };

  /// Before they are, takes no more memory than they need.
  void reserve(const PoseTree& tree, const LeafCounts& counts);

  /// Adds a leaf of this state, if it may hold poses of the set; then distinguish it from all its neighbours
  /// by `connect`.
  void add_leaf(NodeIndex node, LeafState state);
  void connect(const PoseTree& tree, NodeIndex a, NodeIndex b);

  /// Joins what is proved to be connected across faces of whole parts, and forgets faces that are proved to
  /// hold nothing of the set. Needs a live `RoundingUpward`.
  void settle_faces(const PoseTree& tree, const BoxClassifier& classifier);

  /// After a leaf was divided and its children were classified; its neighbours are those of
  /// `neighbour_leaves`, and `faces` those between these and the children that are not outside.
  void replace(PoseTree& tree, NodeIndex node, const std::vector<NodeIndex>& neighbours,
               const NodePairs& faces);

  /// Joins components that are new since the last call to others by a `Climb`; those without an inside leaf
  /// only where `bare_too`. Returns leaves of those that have no inside leaf after that. Needs a live
  /// `RoundingUpward`.
  std::vector<NodeIndex> climb_from_new(PoseTree& tree, const BoxClassifier& classifier, bool bare_too);

  /// Joins the components of two leaves, which a path leads to each other, as is proved elsewhere.
  void join(NodeIndex a, NodeIndex b) { unite(slot(a), slot(b)); }

  /// Forgets a whole part that is proved empty.
  void drop(PoseTree& tree, NodeIndex node);

  /// Two leaves through which two components could be connected, and the leaf of each component that is
  /// nearest to them.
  struct Contact {
    NodeIndex node, other_node;
    NodeIndex leaf, other_leaf;
  };

  struct Meeting {
    std::vector<NodeIndex>
        nearest;  ///< a leaf of the component nearest to each indeterminate leaf, or `no_node`
    std::vector<std::uint32_t> components;  ///< the numbers of these components
    std::vector<Contact> contacts;
  };
  Meeting meeting();

  /// The contacts of this component, by its number, are not worth more work.
  void give_up(std::uint32_t component) noexcept { traits_[component].is_given_up = true; }
  bool is_given_up(std::uint32_t component) const noexcept { return traits_[component].is_given_up; }

  /// Whether the component holds an inside leaf, so that it is not empty.
  bool is_listed(std::uint32_t component) const noexcept { return traits_[component].has_inside_leaf; }

  /// Of a component, at least; some may have been divided since.
  std::size_t leaf_count(std::uint32_t component) const noexcept { return traits_[component].leaves; }

  std::uint32_t smaller_of(std::uint32_t a, std::uint32_t b) const noexcept {
    return traits_[a].leaves < traits_[b].leaves ? a : b;
  }

  /// All leaves of components, in the order in which they came; `no_node` for those that were divided or
  /// dropped.
  const std::vector<NodeIndex>& members() const noexcept { return members_; }

  /// The number of the component with the most leaves; `none` where there is none.
  std::uint32_t largest_component();

  /// Calls `visit` with the slot of each neighbour leaf into which the set may continue from this one. Pairs
  /// of whole parts are left to `visit_unknown_faces`.
  template <class Visitor>
  void visit_paths_on(const PoseTree& tree, LeafSlot leaf, const Visitor& visit) const {
    if (leaf.is_indeterminate()) return indeterminate_.visit_neighbours(leaf.item(), visit);
    visit_indeterminate_leaves_beside(tree, node(leaf), visit);
  }

  /// Calls `visit` with pairs of whole parts whose common face is not known to be empty.
  template <class Visitor>
  void visit_unknown_faces(const Visitor& visit) const {
    for (const auto* faces : {&faces_, &unknown_faces_})
      for (const auto& [a, b] : *faces)
        if (!holds_nothing(a) && !holds_nothing(b)) visit(a, b);
  }

  bool is_inside(const PoseTree& tree, NodeIndex node) const noexcept {
    return tree.state(node, mode_).is_inside(sign_);
  }

  LeafSlot slot(NodeIndex node) const noexcept { return LeafSlot(slot_[node]); }

  /// The leaf of a slot; `no_node` where it was divided or dropped since.
  NodeIndex node(LeafSlot slot) const noexcept {
    return slot.is_member() ? members_[slot.place()] : indeterminate_.node(slot.item());
  }

  bool holds_nothing(NodeIndex node) const noexcept { return slot(node).is_nowhere(); }

  const IndeterminateLeaves& indeterminate_leaves() const noexcept { return indeterminate_; }

  /// Whether a leaf that may hold poses of the set is open, and was not looked into again.
  bool is_unexamined(NodeIndex node) const noexcept {
    return slot(node).is_indeterminate() && !indeterminate_.is_examined(slot(node).item());
  }

  /// Whether a leaf is known to hold nothing of the set, or only poses of the component that it is in.
  bool is_settled(NodeIndex node) const noexcept { return !slot(node).is_indeterminate(); }

  /// After more was proved of an indeterminate leaf.
  void take_in_proof(const PoseTree& tree, NodeIndex node);

  /// After an indeterminate leaf was proved to have nothing of the set.
  void take_in_emptiness(PoseTree& tree, NodeIndex node);

  /// After all that an indeterminate leaf has of the set was proved to be connected, with the component of
  /// this leaf unless it is `no_node`.
  void take_in_whole(PoseTree& tree, NodeIndex node, NodeIndex component_leaf);

  /// A leaf of a component but `except` that a climb from a pose of the set comes to; `no_node` where it
  /// comes to none. Needs a live `RoundingUpward`.
  NodeIndex component_leaf_above(const PoseTree& tree, const BoxClassifier& classifier,
                                 const MapPosition& position, std::uint32_t except = none);

  bool is_in_component(NodeIndex node) const noexcept { return slot(node).is_member(); }

  /// The component of a leaf that is in one: the same number for all leaves of it.
  std::uint32_t component(NodeIndex node) noexcept { return components_.find(slot(node).place()); }

  /// The number that a component has now, which had this one before some were joined; of a member's place,
  /// that of its component.
  std::uint32_t current(std::uint32_t component) noexcept { return components_.find(component); }

  /// More than the number of any component.
  std::size_t component_bound() const noexcept { return components_.size(); }

 private:
  template <class Visitor>
  void visit_indeterminate_leaves_beside(const PoseTree& tree, NodeIndex node, const Visitor& visit) const {
    for (const NodeIndex leaf : neighbour_leaves(tree, mode_, node))
      if (const LeafSlot beside = slot(leaf); beside.is_indeterminate()) visit(beside);
  }

  struct Traits {
    bool has_inside_leaf = false, climbed = false, is_given_up = false;
    std::uint32_t leaves = 1;  // at least; some may have been divided since
  };

  void set_slot(NodeIndex node, LeafSlot slot) { slot_.set(node, slot.number()); }
  LeafSlot add_member(NodeIndex node, const Traits& traits);
  void unite(LeafSlot a, LeafSlot b);
  Part witness(const PoseTree& tree, const BoxClassifier& classifier, NodeIndex leaf) const;
  void climb(const PoseTree& tree, const BoxClassifier& classifier, NodeIndex leaf, const MapPoint& pose);
  std::size_t settle_some(const PoseTree& tree, const BoxClassifier& classifier, const NodePairs& faces,
                          std::size_t next);
  void settle(NodeIndex a, NodeIndex b, const Part* parts, std::size_t count);

  /// Whether both are in components, and these are two.
  bool are_apart(NodeIndex a, NodeIndex b) noexcept {
    return !holds_nothing(a) && !holds_nothing(b) && component(a) != component(b);
  }

  void replace_whole(PoseTree& tree, LeafSlot leaf, const std::vector<NodeIndex>& children);
  void forget_neighbour(LeafSlot leaf, LeafSlot old_neighbour);
  void start_from_components(Meeting& meeting, std::vector<std::uint32_t>& queue);
  void spread(Meeting& meeting, std::vector<std::uint32_t>& queue);
  void add_contacts_of_faces(std::vector<Contact>& contacts);

  std::size_t mode_;
  int sign_;
  const MapControl& control_;
  const ComponentPolicy& policy_;
  NodeNumbers slot_;            // a `LeafSlot` each
  DisjointSets components_;     // of the members, by their places
  std::vector<Traits> traits_;  // by component
  IndeterminateLeaves indeterminate_;
  bool has_climbed_ = false;
  std::vector<NodeIndex> new_leaves_;  // in components, since the last climb
  std::vector<NodeIndex> members_;     // by place
  NodePairs faces_;                    // between whole parts, not examined yet
  NodePairs unknown_faces_;            // and those without a proof
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_SIGN_GRAPH_H
