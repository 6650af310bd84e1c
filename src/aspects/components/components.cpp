// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/components.h"

#include "aspects/components/disjoint_sets.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

// Some tenth of a millisecond of work.
constexpr NodeIndex nodes_between_looks = 4096;

void extend(Box& bounds, const Box& box) {
  if (bounds.dimension == 0) bounds = box;
  for (std::size_t i = 0; i < box.dimension; ++i) {
    bounds.lower[i] = std::min(bounds.lower[i], box.lower[i]);
    bounds.upper[i] = std::max(bounds.upper[i], box.upper[i]);
  }
}

/// Collects the components of one graph.
class Summary {
 public:
  Summary(const PoseTree& tree, std::size_t mode, LeafGraph& graph, const MapControl& control)
      : tree_(tree), mode_(mode), graph_(graph), control_(control) {}

  ModeComponents collect() {
    for (const int sign : {1, -1}) {
      if (is_cancelled(control_)) break;
      collect_components(sign);
      collect_undecided(sign);
      collect_meetings(sign);
      count_indeterminate(sign);
    }
    collect_clusters();
    return std::move(result_);
  }

 private:
  /// Ends early when cancelled.
  template <class Action>
  void for_each_node(const Action& action) const {
    for (NodeIndex node = 0; node < tree_.node_count(); ++node) {
      if (node % nodes_between_looks == 0 && is_cancelled(control_)) return;
      action(node);
    }
  }

  void collect_components(int sign) {
    SignGraph& graph = graph_.of(sign);
    index_.assign(graph.component_bound(), SignGraph::none);
    for_each_node([&](NodeIndex node) {
      if (!tree_.state(node, mode_).is_inside(sign)) return;
      const std::uint32_t root = graph.component(node);
      const Box box = tree_.box(node);
      if (index_[root] == SignGraph::none) start_component(root, sign);
      Component& component = result_.components[index_[root]];
      component.leaves.push_back(node);
      const double measure = tree_.space().measure(box);
      component.measure_inside += measure;
      component.measure_estimated += measure;
      extend(component.bounds[tree_.place(node).root], box);
    });
    undecided_.resize(result_.components.size(), 0.0);
  }

  void start_component(std::uint32_t root, int sign) {
    index_[root] = static_cast<std::uint32_t>(result_.components.size());
    Component component;
    component.determinant_sign = sign;
    component.bounds.resize(tree_.root_count());
    result_.components.push_back(component);
  }

  /// What undecided leaves measure, those that are whole parts, and the bound of the number of aspects: what
  /// hides in no indeterminate leaf is in a component, and there is an aspect in each at most.
  void collect_undecided(int sign) {
    SignGraph& graph = graph_.of(sign);
    std::vector<bool> seen(graph.component_bound(), false);
    for_each_node([&](NodeIndex node) {
      const LeafState state = tree_.state(node, mode_);
      if (sign > 0 && state.is_undecided())
        result_.measure_undecided += tree_.space().measure(tree_.box(node));
      if (!state.may_be(sign)) return;
      if (graph.is_in_component(node)) seen[graph.component(node)] = true;
      if (state.is_undecided() && state.is_whole(sign)) add_undecided(node, node, sign);
    });
    result_.bound += static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
  }

  /// An undecided leaf, or what of it may have the sign, counts for the component of `leaf`.
  void add_undecided(NodeIndex node, NodeIndex leaf, int sign) {
    const std::uint32_t component = index_[graph_.of(sign).component(leaf)];
    if (component == SignGraph::none) return;
    const double measure = tree_.space().measure(tree_.box(node));
    undecided_[component] += measure;
    if (tree_.state(node, mode_).center_sign() == sign)
      result_.components[component].measure_estimated += measure;
  }

  void collect_meetings(int sign) {
    SignGraph& graph = graph_.of(sign);
    const SignGraph::Meeting meeting = graph.meeting();
    add_unresolved(meeting.contacts, graph);
    for (std::size_t v = 0; v < meeting.nearest.size(); ++v)
      if (meeting.nearest[v] != no_node)
        add_undecided(graph.indeterminate_leaves().node(v), meeting.nearest[v], sign);
  }

  void count_indeterminate(int sign) {
    const IndeterminateLeaves& open = graph_.of(sign).indeterminate_leaves();
    for (std::size_t v = 0; v < open.size(); ++v) result_.indeterminate_leaves += open.node(v) != no_node;
  }

  /// Components that have no inside leaf are not listed, but those they meet could be connected through
  /// them.
  void add_unresolved(const std::vector<SignGraph::Contact>& contacts, SignGraph& graph) {
    DisjointSets unlisted(index_.size());
    const auto is_listed = [this](std::uint32_t component) { return index_[component] != SignGraph::none; };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const SignGraph::Contact& contact : contacts) {
      std::uint32_t a = graph.component(contact.leaf), b = graph.component(contact.other_leaf);
      if (!is_listed(a)) std::swap(a, b);
      if (!is_listed(a))
        unlisted.unite(a, b);
      else if (is_listed(b))
        add_unresolved(index_[a], index_[b]);
      else
        pairs.emplace_back(b, a);
    }
    for (auto& [b, a] : pairs) b = unlisted.find(b);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (std::size_t first = 0; first < pairs.size(); ++first)
      for (std::size_t i = first + 1; i < pairs.size() && pairs[i].first == pairs[first].first; ++i)
        add_unresolved(index_[pairs[first].second], index_[pairs[i].second]);
  }

  void add_unresolved(std::size_t a, std::size_t b) {
    result_.unresolved.emplace_back(std::min(a, b), std::max(a, b));
  }

  /// Two components are proved to be different where no chain of unresolved pairs leads from one to the
  /// other, for each pair of the chain may be one. So only clusters are counted.
  void collect_clusters() {
    auto& pairs = result_.unresolved;
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    DisjointSets clusters(result_.components.size());
    for (const auto& [a, b] : result_.unresolved)
      clusters.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    std::vector<double> measure(result_.components.size(), 0.0);
    for (std::uint32_t i = 0; i < result_.components.size(); ++i) {
      Component& component = result_.components[i];
      component.cluster = clusters.find(i);
      if (component.cluster == i) ++result_.cluster_count;
      measure[component.cluster] += component.measure_inside + undecided_[i];
    }
    for (Component& component : result_.components) component.measure_cluster = measure[component.cluster];
  }

  const PoseTree& tree_;
  std::size_t mode_;
  LeafGraph& graph_;
  const MapControl& control_;
  ModeComponents result_;
  std::vector<std::uint32_t> index_;  // of a component, by its number in the graph of the sign
  std::vector<double> undecided_;     // measure of the undecided leaves nearest to a component
};

}  // namespace

ModeComponents find_components(const PoseTree& tree, std::size_t mode, LeafGraph& graph,
                               const MapControl& control) {
  return Summary(tree, mode, graph, control).collect();
}

}  // namespace parallel_aspects
