// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/contact_choice.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace parallel_aspects {
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
