// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/components.h"

#include "aspects/components/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <iterator>
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
    collect_leaves();
    for (const int sign : {1, -1}) {
      if (is_cancelled(control_)) break;
      collect_undecided(sign);
      collect_meetings(sign);
      count_indeterminate(sign);
    }
    collect_clusters();
    return std::move(result_);
  }

 private:
  /// What is collected of one sign.
  struct OfSign {
    std::vector<Component> components;   // until those of both are in the result
    std::vector<std::uint32_t> index;    // of a component, by its number in the graph
    std::vector<NodeIndex> whole_parts;  // that are not inside
  };
  OfSign& of(int sign) noexcept { return of_sign_[sign > 0 ? 0 : 1]; }

  /// All leaves, in one pass, as trees are large. Ends early when cancelled.
  void collect_leaves() {
    for (const int sign : {1, -1}) of(sign).index.assign(graph_.of(sign).component_bound(), SignGraph::none);
    for (NodeIndex node = 0; node < tree_.node_count(); ++node) {
      if (node % nodes_between_looks == 0 && is_cancelled(control_)) return;
      const LeafState state = tree_.state(node, mode_);
      if (state.is_inside())
        add_inside(node, state.is_inside(1) ? 1 : -1);
      else if (state.is_undecided())
        add_undecided(node, state);
    }
    std::vector<Component>& all = result_.components;
    for (const int sign : {1, -1}) {
      for (std::uint32_t& index : of(sign).index)
        if (index != SignGraph::none) index += static_cast<std::uint32_t>(all.size());
      std::move(of(sign).components.begin(), of(sign).components.end(), std::back_inserter(all));
    }
    undecided_.assign(all.size(), 0.0);
  }

  void add_inside(NodeIndex node, int sign) {
    SignGraph& graph = graph_.of(sign);
    const std::uint32_t root = graph.component(node);
    std::uint32_t& index = of(sign).index[root];
    if (index == SignGraph::none) {
      index = static_cast<std::uint32_t>(of(sign).components.size());
      start_component(graph.leaf_count(root), sign);
    }
    Component& component = of(sign).components[index];
    const Box box = tree_.box(node);
    component.leaves.push_back(node);
    const double measure = tree_.space().measure(box);
    component.measure_inside += measure;
    component.measure_estimated += measure;
    extend(component.bounds[tree_.place(node).root], box);
  }

  void start_component(std::size_t leaf_count, int sign) {
    Component component;
    component.determinant_sign = sign;
    component.bounds.resize(tree_.root_count());
    component.leaves.reserve(leaf_count);
    of(sign).components.push_back(std::move(component));
  }

  void add_undecided(NodeIndex node, LeafState state) {
    result_.measure_undecided += tree_.space().measure(tree_.box(node));
    for (const int sign : {1, -1})
      if (state.may_be(sign) && state.is_whole(sign)) of(sign).whole_parts.push_back(node);
  }

  /// What whole parts measure, and the bound of the number of aspects: what hides in no indeterminate leaf is
  /// in a component, and there is an aspect in each at most.
  void collect_undecided(int sign) {
    SignGraph& graph = graph_.of(sign);
    std::vector<bool> seen(graph.component_bound(), false);
    for (std::uint32_t place = 0; place < graph.members().size(); ++place)
      if (graph.members()[place] != no_node) seen[graph.current(place)] = true;
    result_.bound += static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
    for (const NodeIndex node : of(sign).whole_parts) add_undecided(node, graph.component(node), sign);
  }

  /// An undecided leaf, or what of it may have the sign, counts for a component of the graph.
  void add_undecided(NodeIndex node, std::uint32_t of_graph, int sign) {
    const std::uint32_t component = of(sign).index[of_graph];
    if (component == SignGraph::none) return;
    const double measure = tree_.space().measure(tree_.box(node));
    undecided_[component] += measure;
    if (tree_.state(node, mode_).center_sign() == sign)
      result_.components[component].measure_estimated += measure;
  }

  void collect_meetings(int sign) {
    SignGraph& graph = graph_.of(sign);
    const SignGraph::Meeting meeting = graph.meeting();
    add_unresolved(meeting.contacts, sign);
    for (std::size_t v = 0; v < meeting.components.size(); ++v)
      if (meeting.components[v] != SignGraph::none)
        add_undecided(graph.indeterminate_leaves().node(v), meeting.components[v], sign);
  }

  void count_indeterminate(int sign) {
    const IndeterminateLeaves& open = graph_.of(sign).indeterminate_leaves();
    for (std::size_t v = 0; v < open.size(); ++v) result_.indeterminate_leaves += open.node(v) != no_node;
  }

  /// Components that have no inside leaf are not listed, but those they meet could be connected through
  /// them.
  void add_unresolved(const std::vector<SignGraph::Contact>& contacts, int sign) {
    SignGraph& graph = graph_.of(sign);
    const std::vector<std::uint32_t>& index = of(sign).index;
    DisjointSets unlisted(index.size());
    const auto is_listed = [&index](std::uint32_t component) { return index[component] != SignGraph::none; };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const SignGraph::Contact& contact : contacts) {
      std::uint32_t a = graph.component(contact.leaf), b = graph.component(contact.other_leaf);
      if (!is_listed(a)) std::swap(a, b);
      if (!is_listed(a))
        unlisted.unite(a, b);
      else if (is_listed(b))
        add_unresolved(index[a], index[b]);
      else
        pairs.emplace_back(b, a);
    }
    for (auto& [b, a] : pairs) b = unlisted.find(b);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (std::size_t first = 0; first < pairs.size(); ++first)
      for (std::size_t i = first + 1; i < pairs.size() && pairs[i].first == pairs[first].first; ++i)
        add_unresolved(index[pairs[first].second], index[pairs[i].second]);
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
  std::array<OfSign, 2> of_sign_;
  std::vector<double> undecided_;  // measure of the undecided leaves nearest to a component
};

}  // namespace

ModeComponents find_components(const PoseTree& tree, std::size_t mode, LeafGraph& graph,
                               const MapControl& control) {
  return Summary(tree, mode, graph, control).collect();
}

}  // namespace parallel_aspects
