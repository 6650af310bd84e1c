// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/contact_search.h"

#include <algorithm>

namespace parallel_aspects {

ContactSearch::ContactSearch(const PoseTree& tree, SignGraph& graph, const MapControl& control,
                             const ComponentPolicy& policy)
    : tree_(tree),
      graph_(graph),
      control_(control),
      policy_(policy),
      largest_(graph.largest_component()),
      reached_from_(tree.node_count(), no_node) {
  graph.visit_unknown_faces([this](NodeIndex a, NodeIndex b) {
    across_faces_[a].push_back(b);
    across_faces_[b].push_back(a);
  });
}

std::vector<SignGraph::Contact> ContactSearch::run() {
  std::size_t max_leaves = policy_.least_leaves_to_search;
  for (const NodeIndex leaf : graph_.members()) {
    if (is_cancelled(control_)) break;
    if (!is_source(leaf)) continue;
    go_on(leaf, leaf);
    max_leaves += policy_.leaves_to_search_for_one;
  }
  for (std::size_t head = 0; head < std::min(queue_.size(), max_leaves) && !is_cancelled(control_); ++head)
    go_on(queue_[head], reached_from_[queue_[head]]);
  return std::move(contacts_);
}

// Every contact has a component that is not the largest at one of its ends, and is found from there.
bool ContactSearch::is_source(NodeIndex leaf) {
  if (graph_.holds_nothing(leaf)) return false;
  const std::uint32_t component = graph_.component(leaf);
  return component != largest_ && graph_.is_listed(component) && !graph_.is_given_up(component);
}

template <class Visitor>
void ContactSearch::visit_paths_on(NodeIndex node, const Visitor& visit) const {
  graph_.visit_paths_on(tree_, node, visit);
  const auto found = across_faces_.find(node);
  if (found == across_faces_.end()) return;
  for (const NodeIndex leaf : found->second) visit(leaf);
}

void ContactSearch::go_on(NodeIndex node, NodeIndex from) {
  const std::size_t before = contacts_.size();
  onward_.clear();
  visit_paths_on(node, [&](NodeIndex leaf) {
    if (graph_.is_in_component(leaf) && is_listed(leaf))
      add(node, node, from, leaf);
    else
      onward_.push_back(leaf);
  });
  // A leaf that is in a contact will be worked on; what lies behind it is looked at when that is settled.
  if (contacts_.size() > before) return;
  for (const NodeIndex leaf : onward_) {
    if (reached_from_[leaf] != no_node) {
      add(node == from ? leaf : node, leaf, from, reached_from_[leaf]);
      continue;
    }
    reached_from_[leaf] = from;
    queue_.push_back(leaf);
  }
}

void ContactSearch::add(NodeIndex node, NodeIndex other_node, NodeIndex leaf, NodeIndex other_leaf) {
  if (graph_.component(leaf) != graph_.component(other_leaf))
    contacts_.push_back({node, other_node, leaf, other_leaf});
}

}  // namespace parallel_aspects
