// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/contacts.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace parallel_aspects {

std::vector<SignGraph::Contact> ContactSearch::run() {
  largest_ = graph_.largest_component();
  collect_faces();
  take_in_members();
  items_from_.resize(graph_.indeterminate_leaves().size(), none);
  const std::size_t sources = start_from_sources();
  const std::size_t max_leaves = policy_.least_leaves_to_search + policy_.leaves_to_search_for_one * sources;
  for (std::size_t head = 0; head < std::min(queue_.size(), max_leaves) && !is_cancelled(control_); ++head) {
    const LeafSlot ahead = queue_[std::min(head + IndeterminateLeaves::fetched_ahead, queue_.size() - 1)];
    if (ahead.is_indeterminate()) graph_.indeterminate_leaves().fetch(ahead.item());
    go_on(queue_[head], reached_from(queue_[head]));
  }
  for (const LeafSlot leaf : queue_) reached_from(leaf) = none;
  queue_.clear();
  sources_.clear();
  return std::exchange(contacts_, {});
}

void ContactSearch::collect_faces() {
  across_faces_.clear();
  graph_.visit_unknown_faces([this](NodeIndex a, NodeIndex b) {
    across_faces_[a].push_back(b);
    across_faces_[b].push_back(a);
  });
}

/// New members, and those put aside that are sources now, in the order of the graph's members.
void ContactSearch::take_in_members() {
  bool in_order = true;
  for (auto group = put_aside_.begin(); group != put_aside_.end();) {
    if (!is_source(graph_.current(group->first))) {
      ++group;
      continue;
    }
    for (const std::uint32_t place : group->second) members_.push_back({place});
    group = put_aside_.erase(group);
    in_order = false;
  }
  if (!in_order)
    std::sort(members_.begin(), members_.end(),
              [](const Member& a, const Member& b) { return a.place < b.place; });
  for (; taken_in_ < graph_.members().size(); ++taken_in_)
    members_.push_back({static_cast<std::uint32_t>(taken_in_)});
}

/// Returns from how many leaves. Every contact has a component that is not the largest at one of its ends,
/// and is found from there.
std::size_t ContactSearch::start_from_sources() {
  std::size_t sources = 0;
  for (const auto& [component, count] : closed_)
    if (is_source(graph_.current(component))) sources += count;
  std::size_t kept = 0;
  std::vector<std::uint32_t> beside;
  beside.reserve(beside_.size());
  for (const Member& member : members_) {
    if (is_cancelled(control_)) break;
    const NodeIndex leaf = graph_.members()[member.place];
    if (leaf == no_node) continue;
    const std::uint32_t component = graph_.current(member.place);
    if (!is_source(component)) {
      put_aside_[component].push_back(member.place);
      continue;
    }
    ++sources;
    const std::size_t first = beside.size();
    append_leaves_beside(member, beside);
    sources_.push_back({leaf, component});
    const bool leads_on =
        go_on(leaf, static_cast<std::uint32_t>(sources_.size() - 1), [&](const auto& visit) {
          for (std::size_t i = first; i < beside.size(); ++i) visit(LeafSlot::indeterminate(beside[i]));
          visit_across_faces(leaf, visit);
        });
    if (!leads_on && graph_.is_inside(tree_, leaf))
      ++closed_[component];
    else
      members_[kept++] = {member.place, static_cast<std::uint32_t>(first),
                          static_cast<std::uint32_t>(beside.size() - first)};
  }
  members_.resize(kept);
  beside_.swap(beside);
  return sources;
}

/// The indeterminate leaves beside a leaf of a component, in the order of the tree. They become fewer where
/// they are settled, and others only where one of them is divided: no other division leaves indeterminate
/// leaves.
void ContactSearch::append_leaves_beside(const Member& member, std::vector<std::uint32_t>& items) const {
  const IndeterminateLeaves& leaves = graph_.indeterminate_leaves();
  const std::size_t before = items.size();
  bool is_known = member.count != Member::unknown;
  for (std::size_t i = 0; is_known && i < member.count; ++i) {
    const std::uint32_t beside = beside_[member.first + i];
    if (leaves.node(beside) != no_node)
      items.push_back(beside);
    else
      is_known = !leaves.was_divided(beside);
  }
  if (is_known) return;
  items.resize(before);
  graph_.visit_paths_on(tree_, LeafSlot::member(member.place),
                        [&items](LeafSlot beside) { items.push_back(beside.item()); });
}

bool ContactSearch::is_source(std::uint32_t component) const {
  return component != largest_ && graph_.is_listed(component) && !graph_.is_given_up(component);
}

template <class Visitor>
void ContactSearch::visit_across_faces(NodeIndex node, const Visitor& visit) const {
  if (across_faces_.empty()) return;
  const auto found = across_faces_.find(node);
  if (found == across_faces_.end()) return;
  for (const NodeIndex leaf : found->second) visit(graph_.slot(leaf));
}

/// Whether any path leads on.
bool ContactSearch::go_on(LeafSlot leaf, std::uint32_t from) {
  const NodeIndex node = graph_.node(leaf);
  return go_on(node, from, [&](const auto& visit) {
    graph_.visit_paths_on(tree_, leaf, visit);
    if (leaf.is_member()) visit_across_faces(node, visit);
  });
}

template <class VisitPathsOn>
bool ContactSearch::go_on(NodeIndex node, std::uint32_t from, const VisitPathsOn& visit_paths_on) {
  const Source source = sources_[from];
  const std::size_t before = contacts_.size();
  onward_.clear();
  bool found = false;
  visit_paths_on([&](LeafSlot leaf) {
    found = true;
    const std::uint32_t component = leaf.is_member() ? graph_.current(leaf.place()) : none;
    if (component == none || !graph_.is_listed(component))
      onward_.push_back(leaf);
    else if (component != source.component)
      contacts_.push_back({node, node, source.leaf, graph_.node(leaf)});
  });
  // A leaf that is in a contact will be worked on; what lies behind it is examined when that is settled.
  if (contacts_.size() > before) return true;
  for (const LeafSlot leaf : onward_) {
    std::uint32_t& reached = reached_from(leaf);
    if (reached == none) {
      reached = from;
      queue_.push_back(leaf);
    } else if (sources_[reached].component != source.component) {
      const NodeIndex there = graph_.node(leaf);
      contacts_.push_back({node == source.leaf ? there : node, there, source.leaf, sources_[reached].leaf});
    }
  }
  return found;
}

namespace {

std::vector<NodeIndex> unexamined_of(const SignGraph& graph, const std::vector<NodeIndex>& leaves) {
  std::vector<NodeIndex> result;
  std::copy_if(leaves.begin(), leaves.end(), std::back_inserter(result),
               [&graph](NodeIndex node) { return graph.is_unexamined(node); });
  return result;
}

}  // namespace

std::vector<NodeIndex> coarsest_of(const PoseTree& tree, const std::vector<NodeIndex>& leaves) {
  std::uint32_t coarsest = PoseTree::deepest_level;
  for (const NodeIndex node : leaves) coarsest = std::min(coarsest, tree.place(node).level);
  std::vector<NodeIndex> result;
  for (const NodeIndex node : leaves)
    if (tree.place(node).level == coarsest) result.push_back(node);
  return result;
}

std::vector<NodeIndex> ContactChoice::choose(SignGraph& graph,
                                             const std::vector<SignGraph::Contact>& contacts) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<NodeIndex>> pairs;
  auto last = pairs.end();  // of the contact before, which most are of, too
  for (const SignGraph::Contact& contact : contacts) {
    const std::pair<std::uint32_t, std::uint32_t> pair =
        std::minmax(graph.component(contact.leaf), graph.component(contact.other_leaf));
    if (last == pairs.end() || last->first != pair) last = pairs.try_emplace(pair).first;
    last->second.push_back(contact.node);
    if (contact.other_node != contact.node) last->second.push_back(contact.other_node);
  }
  std::vector<NodeIndex> chosen;
  std::set<std::uint32_t> given_up, worked_on;
  asks_for_more_ = false;
  for (auto& [pair, leaves] : pairs) {
    std::sort(leaves.begin(), leaves.end());
    leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
    const std::vector<NodeIndex> of_pair = choose_of_pair(graph, leaves);
    chosen.insert(chosen.end(), of_pair.begin(), of_pair.end());
    // The contact will be found again from the smaller component.
    if (!of_pair.empty()) worked_on.insert(graph.smaller_of(pair.first, pair.second));
    given_up.insert({pair.first, pair.second});
  }
  for (const std::uint32_t component : given_up)
    if (worked_on.count(component) == 0) graph.give_up(component);
  if (asks_for_more_) tries_ *= policy_.more_tries;
  return chosen;
}

std::vector<NodeIndex> ContactChoice::choose_of_pair(const SignGraph& graph,
                                                     const std::vector<NodeIndex>& leaves) {
  if (leaves.size() <= max_leaves_of_a_point_) return coarsest_of(tree_, leaves);
  if (!policy_.tries) return of_many(graph, leaves);
  std::vector<NodeIndex> tried;
  std::uint32_t deepest = base_level_;
  for (const NodeIndex node : leaves) {
    const std::uint32_t level = tree_.place(node).level;
    deepest = std::max(deepest, level);
    if (level > base_level_) tried.push_back(node);
  }
  if (deepest >= base_level_ + policy_.levels_of_a_try || tried.size() > max_leaves_of_a_point_)
    return of_many(graph, leaves);
  if (!tried.empty()) return coarsest_of(tree_, tried);
  asks_for_more_ = true;
  return spread(leaves);
}

std::vector<NodeIndex> ContactChoice::of_many(const SignGraph& graph,
                                              const std::vector<NodeIndex>& leaves) const {
  return leaves.size() <= policy_.max_leaves_to_examine ? unexamined_of(graph, leaves)
                                                        : std::vector<NodeIndex>();
}

std::vector<NodeIndex> ContactChoice::spread(const std::vector<NodeIndex>& leaves) const {
  std::vector<NodeIndex> result;
  for (std::size_t i = 0; i < tries_; ++i) result.push_back(leaves[i * leaves.size() / tries_]);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace parallel_aspects
