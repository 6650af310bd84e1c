// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/components.h"

#include "parallel_aspects/aspects/interval.h"
#include "parallel_aspects/aspects/segment_proof.h"

#include <algorithm>
#include <map>
#include <utility>

namespace parallel_aspects {
namespace {

// Where components touch along a whole curve no depth tells them apart; then stop and report them as
// unresolved.
constexpr std::size_t most_refinements = 200000;

// Between two components that are apart all proofs fail, and one that fails is dear.
constexpr int most_failures = 8;

/// Refinement of the contested leaves of one sign, and of those where an aspect may hide.
class Refinement {
 public:
  Refinement(PoseTree& tree, const BoxClassifier& classifier, LeafGraph& graph, std::uint32_t deepest_level,
             const MapControl& control)
      : tree_(tree),
        classifier_(classifier),
        graph_(graph),
        deepest_level_(deepest_level),
        control_(control) {}

  /// One round for one sign; whether there was anything left to do.
  bool run(int sign) {
    const LeafGraph::Meeting meeting = graph_.meeting(tree_, sign);
    std::vector<std::uint32_t> vertices = meeting.hidden;
    failures_.clear();
    for (const LeafGraph::Contact& contact : meeting.contacts)
      if (!is_cancelled(control_) && !joined(contact, sign))
        vertices.insert(vertices.end(), {contact.vertex, contact.other_vertex});
    add_stranded(meeting, sign, vertices);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return refine(vertices);
  }

 private:
  // By now, or by a straight way between the two inside leaves that is proved free of singularities.
  bool joined(const LeafGraph::Contact& contact, int sign) {
    const std::uint32_t component = graph_.component(contact.leaf),
                        other = graph_.component(contact.other_leaf);
    if (component == other) return true;
    int& failures = failures_[{std::min(component, other), std::max(component, other)}];
    if (failures == most_failures) return false;
    const MapPosition from{tree_.place(contact.leaf).root,
                           tree_.box(contact.leaf).nearest(tree_.box(contact.other_leaf).middle())};
    if (!is_free(from, contact.other_leaf, sign)) {
      ++failures;
      return false;
    }
    graph_.unite(contact.leaf, contact.other_leaf);
    return true;
  }

  bool is_free(const MapPosition& from, NodeIndex leaf, int sign) const {
    if (tree_.place(leaf).root != from.root) return false;
    const RoundingUpward rounding;
    return segment_is_free(classifier_, tree_.dimension(), graph_.mode(), sign, from,
                           tree_.box(leaf).nearest(from.point));
  }

  // Leaves whose center is free of singularities, but with no straight way to the component that is nearest:
  // aspects of about the size of a leaf hide among the undecided leaves around another one.
  void add_stranded(const LeafGraph::Meeting& meeting, int sign, std::vector<std::uint32_t>& vertices) {
    std::vector<bool>& seen = sign > 0 ? seen_positive_ : seen_negative_;
    seen.resize(graph_.vertices().size(), false);
    for (std::uint32_t v = 0; v < seen.size() && !is_cancelled(control_); ++v) {
      if (seen[v] || meeting.nearest[v] == no_node) continue;
      seen[v] = true;
      if (!touches_inside_leaf(v, sign) && is_stranded(v, meeting.nearest[v], sign)) vertices.push_back(v);
    }
  }

  bool touches_inside_leaf(std::uint32_t vertex, int sign) const {
    const auto& neighbours = graph_.vertices()[vertex].neighbours;
    return std::any_of(neighbours.begin(), neighbours.end(), [&](NodeIndex neighbour) {
      return tree_.state(neighbour, graph_.mode()).is_inside(sign);
    });
  }

  bool is_stranded(std::uint32_t vertex, NodeIndex nearest, int sign) {
    const RoundingUpward rounding;
    if (graph_.center_sign(tree_, classifier_, vertex) != sign) return false;
    const NodeIndex node = graph_.vertices()[vertex].node;
    return !is_free({tree_.place(node).root, tree_.box(node).middle()}, nearest, sign);
  }

  bool refine(const std::vector<std::uint32_t>& vertices) {
    bool refined = false;
    for (const std::uint32_t vertex : vertices) {
      if (is_cancelled(control_)) return false;
      if (budget_ == 0 || tree_.place(graph_.vertices()[vertex].node).level >= deepest_level_) continue;
      graph_.refine(tree_, classifier_, vertex);
      refined = true;
      --budget_;
    }
    return refined;
  }

  PoseTree& tree_;
  const BoxClassifier& classifier_;
  LeafGraph& graph_;
  std::uint32_t deepest_level_;
  const MapControl& control_;
  std::size_t budget_ = most_refinements;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int>
      failures_;                                     // of proofs between two components, this round
  std::vector<bool> seen_positive_, seen_negative_;  // vertices that were looked at
};

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
  Summary(const PoseTree& tree, const BoxClassifier& classifier, std::size_t mode, LeafGraph& graph)
      : tree_(tree), classifier_(classifier), mode_(mode), graph_(graph) {}

  ModeComponents collect() {
    collect_inside();
    collect_undecided();
    for (const int sign : {1, -1}) collect_meetings(sign);
    collect_clusters();
    return std::move(result_);
  }

 private:
  void collect_inside() {
    const auto& leaves = graph_.inside_leaves();
    index_.assign(leaves.size(), LeafGraph::none);
    for (std::uint32_t i = 0; i < leaves.size(); ++i) {
      const std::uint32_t root = graph_.component(leaves[i]);
      const Box box = tree_.box(leaves[i]);
      if (index_[root] == LeafGraph::none) start_component(root, leaves[i]);
      Component& component = result_.components[index_[root]];
      component.leaves.push_back(leaves[i]);
      component.measure_inside += tree_.space().measure(box);
      extend(component.bounds[tree_.place(leaves[i]).root], box);
    }
    for (Component& component : result_.components) component.measure_estimated = component.measure_inside;
  }

  void start_component(std::uint32_t root, NodeIndex leaf) {
    index_[root] = static_cast<std::uint32_t>(result_.components.size());
    Component component;
    component.determinant_sign = tree_.state(leaf, mode_).is_inside(1) ? 1 : -1;
    component.bounds.resize(tree_.root_count());
    result_.components.push_back(component);
  }

  void collect_undecided() {
    for (const LeafGraph::Vertex& vertex : graph_.vertices())
      if (vertex.node != no_node) result_.measure_undecided += tree_.space().measure(tree_.box(vertex.node));
  }

  void collect_meetings(int sign) {
    const LeafGraph::Meeting meeting = graph_.meeting(tree_, sign);
    for (const LeafGraph::Contact& contact : meeting.contacts) result_.unresolved.push_back(ordered(contact));
    const RoundingUpward rounding;
    undecided_.resize(result_.components.size(), 0.0);
    for (std::uint32_t v = 0; v < graph_.vertices().size(); ++v) {
      if (meeting.nearest[v] == no_node) continue;
      const std::size_t component = component_index(meeting.nearest[v]);
      const NodeIndex node = graph_.vertices()[v].node;
      const double measure = tree_.space().measure(tree_.box(node));
      undecided_[component] += measure;
      if (graph_.center_sign(tree_, classifier_, v) == sign)
        result_.components[component].measure_estimated += measure;
    }
  }

  std::pair<std::size_t, std::size_t> ordered(const LeafGraph::Contact& contact) {
    const std::size_t a = component_index(contact.leaf), b = component_index(contact.other_leaf);
    return {std::min(a, b), std::max(a, b)};
  }

  std::size_t component_index(NodeIndex leaf) { return index_[graph_.component(leaf)]; }

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
  const BoxClassifier& classifier_;
  std::size_t mode_;
  LeafGraph& graph_;
  ModeComponents result_;
  std::vector<std::uint32_t> index_;  // of a component, by its root
  std::vector<double> undecided_;     // measure of the undecided leaves nearest to a component
};

}  // namespace

void refine_contested(PoseTree& tree, const BoxClassifier& classifier, LeafGraph& graph,
                      std::uint32_t deepest_level, const MapControl& control) {
  Refinement refinement(tree, classifier, graph, deepest_level, control);
  // Leaves divided for one sign may show new components of the other: done when both have nothing to do in
  // turn.
  for (int sign = 1, idle = 0; idle < 2;) {
    if (refinement.run(sign)) {
      idle = 0;
    } else {
      ++idle;
      sign = -sign;
    }
  }
}

ModeComponents find_components(const PoseTree& tree, const BoxClassifier& classifier, std::size_t mode,
                               LeafGraph& graph) {
  return Summary(tree, classifier, mode, graph).collect();
}

}  // namespace parallel_aspects
