// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/components.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/tree/neighbour_leaves.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace parallel_aspects {

LeafGraph::LeafGraph(const PoseTree& tree, std::size_t mode, bool looks_everywhere, const MapControl& control,
                     const ComponentPolicy& policy)
    : mode_(mode),
      looks_everywhere_(looks_everywhere),
      positive_(mode, 1, control, policy),
      negative_(mode, -1, control, policy) {
  SignGraph::LeafCounts positive, negative;
  for (NodeIndex node = 0; node < tree.node_count(); ++node) {
    positive.add(node, tree.state(node, mode), 1);
    negative.add(node, tree.state(node, mode), -1);
  }
  positive_.reserve(tree, positive);
  negative_.reserve(tree, negative);
  for (NodeIndex node = 0; node < tree.node_count() && !is_cancelled(control); ++node) {
    positive_.add_leaf(node, tree.state(node, mode));
    negative_.add_leaf(node, tree.state(node, mode));
  }
  // Most leaves may hold poses of one sign alone, which their states tell sooner than the graph of the other.
  const auto connect = [this, &tree, mode](NodeIndex a, NodeIndex b) {
    const LeafState one = tree.state(a, mode), other = tree.state(b, mode);
    if (one.may_be(1) && other.may_be(1)) positive_.connect(tree, a, b);
    if (one.may_be(-1) && other.may_be(-1)) negative_.connect(tree, a, b);
  };
  if (!is_cancelled(control)) visit_faces(tree, mode, connect, control);
}

void LeafGraph::replace(PoseTree& tree, NodeIndex node) {
  const std::vector<NodeIndex> neighbours = neighbour_leaves(tree, mode_, node);
  std::vector<NodeIndex> children;
  for (NodeIndex rank = 0; rank < tree.children_per_node(); ++rank)
    if (const NodeIndex child = tree.first_child(node) + rank; !tree.state(child, mode_).is_outside())
      children.push_back(child);
  const NodePairs faces = faces_between(tree, children, neighbours);
  positive_.replace(tree, node, neighbours, faces);
  negative_.replace(tree, node, neighbours, faces);
}

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

namespace {

/// A mode and the representative whose image it is.
struct ModePair {
  std::size_t representative, mode;
};

std::vector<ModePair> pairs_of(const MapSymmetry& symmetry, const std::vector<ModeSource>& sources) {
  std::vector<ModePair> pairs;
  for (std::size_t mode = 0; mode < sources.size(); ++mode)
    if (sources[mode].symmetry == &symmetry) pairs.push_back({sources[mode].representative, mode});
  return pairs;
}

/// Writes the states, and returns the image of each node that a representative has states at; `no_node` of
/// others.
std::vector<NodeIndex> mirror_states(PoseTree& tree, const MapSymmetry& symmetry,
                                     const std::vector<ModePair>& pairs) {
  const auto count = static_cast<NodeIndex>(tree.node_count());
  std::vector<NodeIndex> images(count, no_node);
  for (RootIndex root = 0; root < tree.root_count(); ++root) images[root] = symmetry.poses.image(root);
  for (NodeIndex node = 0; node < count; ++node) {
    const NodeIndex image = images[node];
    if (image == no_node) continue;
    bool is_divided = false;
    for (const ModePair& pair : pairs) {
      const LeafState state = tree.state(node, pair.representative);
      tree.state(image, pair.mode) = symmetry.image(state);
      is_divided = is_divided || state.is_divided();
    }
    if (!is_divided) continue;
    const NodeIndex first = tree.first_child(node), first_image = tree.add_children(image);
    for (NodeIndex rank = 0; rank < tree.children_per_node(); ++rank)
      images[first + rank] = first_image + symmetry.poses.image_rank(tree.place(node).root, rank);
  }
  return images;
}

Component mirrored(const Component& component, const MapSymmetry& symmetry,
                   const std::vector<NodeIndex>& images) {
  Component result = component;
  result.determinant_sign *= symmetry.determinant_sign;
  for (RootIndex root = 0; root < component.bounds.size(); ++root)
    result.bounds[symmetry.poses.image(root)] = symmetry.poses.image(root, component.bounds[root]);
  for (NodeIndex& leaf : result.leaves) leaf = images[leaf];
  return result;
}

ModeComponents mirrored(const ModeComponents& found, const MapSymmetry& symmetry,
                        const std::vector<NodeIndex>& images) {
  ModeComponents result = found;
  for (std::size_t i = 0; i < found.components.size(); ++i)
    result.components[i] = mirrored(found.components[i], symmetry, images);
  return result;
}

}  // namespace

void mirror_modes(PoseTree& tree, const std::vector<MapSymmetry>& symmetries,
                  const std::vector<ModeSource>& sources, std::vector<ModeComponents>& components) {
  for (const MapSymmetry& symmetry : symmetries) {
    const std::vector<ModePair> pairs = pairs_of(symmetry, sources);
    if (pairs.empty()) continue;
    const std::vector<NodeIndex> images = mirror_states(tree, symmetry, pairs);
    for (const ModePair& pair : pairs)
      components[pair.mode] = mirrored(components[pair.representative], symmetry, images);
  }
}

}  // namespace parallel_aspects
