// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CONTACTS_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CONTACTS_H

#include "aspects/components/leaf_numbers.h"
#include "aspects/components/sign_graph.h"
#include "aspects/tree/pose_tree.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Where the components of one mode and sign could be connected, seen from all but the largest of them and
/// those given up. Only components with an inside leaf count. A path between two of them may run through
/// indeterminate leaves and through whole parts of no such component. The search starts beside the first one
/// and ends at the first leaf that touches another, so it costs little where the components are small.
class ContactSearch {
 public:
  /// All of these must outlive this; `graph` may change between two runs.
  ContactSearch(const PoseTree& tree, std::size_t mode, SignGraph& graph, const MapControl& control,
                const ComponentPolicy& policy)
      : tree_(tree), mode_(mode), graph_(graph), control_(control), policy_(policy) {}

  /// Ends early, unfinished, when cancelled.
  std::vector<SignGraph::Contact> run();

 private:
  static constexpr std::uint32_t none = SignGraph::none;

  void collect_faces();
  void take_in_members();
  std::size_t start_from_sources();
  bool is_source(std::uint32_t component) const;
  struct Member;
  void append_leaves_beside(const Member& member, std::vector<std::uint32_t>& items) const;
  template <class Visitor>
  void visit_across_faces(NodeIndex node, const Visitor& visit) const;
  std::uint32_t& reached_from(LeafSlot slot) {
    if (slot.is_indeterminate()) return items_from_[slot.item()];
    if (slot.place() >= members_from_.size()) members_from_.resize(graph_.members().size(), none);
    return members_from_[slot.place()];
  }
  bool go_on(LeafSlot leaf, std::uint32_t from);
  template <class VisitPathsOn>
  bool go_on(NodeIndex node, std::uint32_t from, const VisitPathsOn& visit_paths_on);

  const PoseTree& tree_;
  std::size_t mode_;
  SignGraph& graph_;
  const MapControl& control_;
  const ComponentPolicy& policy_;
  std::uint32_t largest_ = none;
  std::unordered_map<NodeIndex, std::vector<NodeIndex>> across_faces_;  // of whole parts

  /// A leaf of a component, as its place among the graph's members, and where the indeterminate leaves beside
  /// it are among `beside_`.
  struct Member {
    static constexpr std::uint32_t unknown = 0xffffffffU;

    std::uint32_t place, first = 0, count = unknown;
  };

  // Leaves of components from which paths may lead on. Those of
  // components from which nothing starts now are put aside. Inside leaves that no path leads on from never
  // get one, and are only counted.
  std::vector<Member> members_;
  std::vector<std::uint32_t> beside_;                                        // items
  std::size_t taken_in_ = 0;                                                 // of the graph's members
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> put_aside_;  // by component
  std::unordered_map<std::uint32_t, std::size_t> closed_;                    // how many, by component

  /// Where a path starts. Components stay what they are in one run.
  struct Source {
    NodeIndex leaf;
    std::uint32_t component;
  };
  std::vector<Source> sources_;
  std::vector<std::uint32_t> items_from_, members_from_;  // by slot: a source; of none between two runs
  std::vector<LeafSlot> queue_, onward_;
  std::vector<SignGraph::Contact> contacts_;
};

/// The leaves of the lowest level among some.
std::vector<NodeIndex> coarsest_of(const PoseTree& tree, const std::vector<NodeIndex>& leaves);

/// Chooses leaves to work on where components of one mode and sign could meet, round by round.
///
/// Where two components meet in few leaves, these are all worked on. Where the leaves are many, the two may
/// touch along a curve or a surface, and then no depth separates them; or one leaf of the many may join
/// them. So a few of the leaves are tried first, some levels deep. More follow where those were settled;
/// where they were not, the components are given up.
class ContactChoice {
 public:
  /// `max_leaves_of_a_point`: see ComponentPolicy, which must outlive this.
  ContactChoice(const PoseTree& tree, std::uint32_t base_level, std::size_t max_leaves_of_a_point,
                const ComponentPolicy& policy)
      : tree_(tree),
        base_level_(base_level),
        max_leaves_of_a_point_(max_leaves_of_a_point),
        policy_(policy),
        tries_(policy.first_tries) {}

  std::vector<NodeIndex> choose(SignGraph& graph, const std::vector<SignGraph::Contact>& contacts);

 private:
  std::vector<NodeIndex> choose_of_pair(const SignGraph& graph, const std::vector<NodeIndex>& leaves);
  /// What is left to do of a contact of many leaves that does not seem to end.
  std::vector<NodeIndex> of_many(const SignGraph& graph, const std::vector<NodeIndex>& leaves) const;
  std::vector<NodeIndex> spread(const std::vector<NodeIndex>& leaves) const;

  const PoseTree& tree_;
  std::uint32_t base_level_;
  std::size_t max_leaves_of_a_point_;
  const ComponentPolicy& policy_;
  std::size_t tries_;
  bool asks_for_more_ = false;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CONTACTS_H
