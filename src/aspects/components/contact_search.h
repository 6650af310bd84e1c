// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CONTACT_SEARCH_H
#define PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CONTACT_SEARCH_H

#include "aspects/components/node_numbers.h"
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
  void collect_faces();
  void take_in_members();
  std::size_t start_from_sources();
  bool is_source(std::uint32_t component) const;
  bool is_listed(NodeIndex leaf) { return graph_.is_listed(graph_.component(leaf)); }
  struct Member;
  void append_leaves_beside(const Member& member, NodeIndex leaf, std::vector<NodeIndex>& leaves) const;
  bool is_indeterminate(NodeIndex node) const noexcept {
    return !graph_.holds_nothing(node) && !graph_.is_in_component(node);
  }
  template <class Visitor>
  void visit_across_faces(NodeIndex node, const Visitor& visit) const;
  bool go_on(NodeIndex node, NodeIndex from);
  template <class VisitPathsOn>
  bool go_on(NodeIndex node, NodeIndex from, const VisitPathsOn& visit_paths_on);
  void add(NodeIndex node, NodeIndex other_node, NodeIndex leaf, NodeIndex other_leaf);

  const PoseTree& tree_;
  std::size_t mode_;
  SignGraph& graph_;
  const MapControl& control_;
  const ComponentPolicy& policy_;
  std::uint32_t largest_ = SignGraph::none;
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
  std::vector<NodeIndex> beside_;
  std::size_t taken_in_ = 0;                                                 // of the graph's members
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> put_aside_;  // by component
  std::unordered_map<std::uint32_t, std::size_t> closed_;                    // how many, by component

  NodeNumbers reached_from_;  // a leaf of a component; of no node between two runs
  std::vector<NodeIndex> queue_, onward_;
  std::vector<SignGraph::Contact> contacts_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_COMPONENTS_CONTACT_SEARCH_H
