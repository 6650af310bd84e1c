// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/persistence/merge_tree.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/tree/neighbour_leaves.h"

#include <algorithm>
#include <queue>

namespace parallel_aspects {
namespace {

/// Cells that are joined, as edges are added.
class Clusters {
 public:
  explicit Clusters(const IndexCells& cells)
      : cells_(cells), sets_(cells.tree().node_count()), peaks_(cells.tree().node_count()) {
    largest_.assign(peaks_.size(), 0.0);
    for (NodeIndex node = 0; node < peaks_.size(); ++node) {
      peaks_[node] = node;
      if (cells.is_cell(node)) largest_[node] = cells.upper(node);
    }
  }

  void add(const CellEdge& edge) {
    const NodeIndex a = sets_.find(edge.first), b = sets_.find(edge.second);
    if (a == b) return;
    const bool a_is_lower = cells_.lower(peaks_[a]) <= cells_.lower(peaks_[b]);
    const NodeIndex lower = peaks_[a_is_lower ? a : b], higher = peaks_[a_is_lower ? b : a];
    if (cells_.lower(lower) > edge.level)
      merges_.push_back({lower, higher, edge.level, largest_[a_is_lower ? a : b]});
    const double largest = std::max(largest_[a], largest_[b]);
    sets_.unite(a, b);
    const NodeIndex joined = sets_.find(a);
    peaks_[joined] = higher;
    largest_[joined] = largest;
  }

  std::vector<PeakMerge> take() { return std::move(merges_); }

 private:
  const IndexCells& cells_;
  DisjointSets sets_;
  std::vector<NodeIndex> peaks_;  // by the cell that stands for its set
  std::vector<double> largest_;   // likewise; upper bound
  std::vector<PeakMerge> merges_;
};

}  // namespace

std::vector<CellEdge> edges_of(const IndexCells& cells, PathBound bound) {
  const auto value = [&](NodeIndex cell) {
    return bound == PathBound::lower ? cells.lower(cell) : cells.upper(cell);
  };
  std::vector<CellEdge> edges;
  visit_faces(cells.tree(), 0, [&](NodeIndex a, NodeIndex b) {
    const double level = std::min(value(a), value(b));
    if (level > 0.0) edges.push_back({a, b, level});
  });
  std::sort(edges.begin(), edges.end(),
            [](const CellEdge& a, const CellEdge& b) { return a.level > b.level; });
  return edges;
}

std::vector<PeakMerge> merge(const IndexCells& cells, const std::vector<CellEdge>& edges) {
  Clusters clusters(cells);
  for (const CellEdge& edge : edges) clusters.add(edge);
  return clusters.take();
}

std::vector<double> levels_of_joining(std::size_t node_count, const std::vector<CellEdge>& edges,
                                      const std::vector<std::pair<NodeIndex, NodeIndex>>& pairs) {
  std::vector<double> levels(pairs.size(), 0.0);
  std::vector<std::vector<std::size_t>> waiting(node_count);  // pairs with one end there, by set
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const NodeIndex end : {pairs[i].first, pairs[i].second}) waiting[end].push_back(i);
  DisjointSets sets(node_count);
  for (const CellEdge& edge : edges) {
    const NodeIndex a = sets.find(edge.first), b = sets.find(edge.second);
    if (a == b) continue;
    for (const std::size_t i : waiting[a])
      if (levels[i] == 0.0 && std::count(waiting[b].begin(), waiting[b].end(), i) > 0) levels[i] = edge.level;
    std::vector<std::size_t> both = std::move(waiting[a]);
    both.insert(both.end(), waiting[b].begin(), waiting[b].end());
    waiting[a].clear();
    waiting[b].clear();
    sets.unite(a, b);
    waiting[sets.find(a)] = std::move(both);
  }
  return levels;
}

namespace {

/// A cell that a search has come to, at which level, and from which aspect.
struct Reached {
  double level;
  NodeIndex cell;
  int from;

  friend bool operator<(const Reached& a, const Reached& b) {
    return std::make_pair(a.level, a.cell) < std::make_pair(b.level, b.cell);
  }
};

NodeIndex as_node(int id) { return static_cast<NodeIndex>(id); }

}  // namespace

AspectLinks::AspectLinks(const IndexCells& cells, std::vector<std::pair<int, int>> pairs,
                         const MapControl& control)
    : cells_(cells), pairs_(std::move(pairs)), control_(control) {
  const auto add = [this](NodeIndex cell) {
    if (known_aspect(cell) != 0) rims_[known_aspect(cell)].insert(cell);
  };
  visit_faces(cells.tree(), 0, [&](NodeIndex a, NodeIndex b) {
    if (known_aspect(a) == known_aspect(b)) return;
    add(a);
    add(b);
  });
  clusters_ = DisjointSets(rims_.empty() ? 0 : as_node(rims_.rbegin()->first) + 1);
}

std::vector<double> AspectLinks::levels() {
  for (std::vector<int> cluster = smallest_open_cluster(); !cluster.empty() && !is_cancelled(control_);
       cluster = smallest_open_cluster())
    link_once(cluster);
  std::sort(links_.begin(), links_.end(),
            [](const CellEdge& a, const CellEdge& b) { return a.level > b.level; });
  std::vector<std::pair<NodeIndex, NodeIndex>> ends;
  for (const auto& [a, b] : pairs_) ends.emplace_back(as_node(a), as_node(b));
  return levels_of_joining(clusters_.size(), links_, ends);
}

/// Of those that a pair leads out of; empty where there is none.
std::vector<int> AspectLinks::smallest_open_cluster() {
  std::map<NodeIndex, std::vector<int>> members;
  std::map<NodeIndex, std::size_t> sizes;
  for (const auto& [id, cells] : rims_) {
    members[clusters_.find(as_node(id))].push_back(id);
    sizes[clusters_.find(as_node(id))] += cells.size();
  }
  NodeIndex smallest = no_node;
  for (const auto& [a, b] : pairs_) {
    const NodeIndex one = clusters_.find(as_node(a)), other = clusters_.find(as_node(b));
    if (one == other || sealed_.count(one) + sealed_.count(other) > 0) continue;
    for (const NodeIndex each : {one, other})
      if (smallest == no_node || sizes[each] < sizes[smallest]) smallest = each;
  }
  return smallest == no_node ? std::vector<int>() : members[smallest];
}

/// To the cluster that the best path from this one leads to. Cells come by falling level, which only falls
/// along a path: where the first of another cluster comes, no path out of this one is better. One that ends
/// without is left by none.
void AspectLinks::link_once(const std::vector<int>& cluster) {
  constexpr auto little = IndexCells::Effort::little, more = IndexCells::Effort::more;
  const NodeIndex start = clusters_.find(as_node(cluster.front()));
  const auto is_at_start = [&](NodeIndex cell) {
    return known_aspect(cell) != 0 && clusters_.find(as_node(known_aspect(cell))) == start;
  };
  OpenQueue<Reached> queue;
  std::vector<bool> is_done(cells_.tree().node_count(), false);
  for (const int id : cluster)
    for (const NodeIndex cell : rims_[id]) queue.push({cells_.upper(cell, little), cell, id});
  while (!queue.empty() && !is_cancelled(control_)) {
    const Reached top = queue.top();
    queue.pop();
    if (is_done[top.cell] || !(top.level > 0.0)) continue;
    cells_.foresee(top.cell, queue.heap(), [](const Reached& entry) { return entry.cell; });
    if (const double closer = cells_.upper(top.cell, more); closer < top.level) {
      queue.push({closer, top.cell, top.from});
      continue;
    }
    is_done[top.cell] = true;
    if (const int aspect = known_aspect(top.cell); aspect != 0 && !is_at_start(top.cell)) {
      links_.push_back({as_node(top.from), as_node(aspect), top.level});
      return clusters_.unite(as_node(top.from), as_node(aspect));
    }
    for (const NodeIndex next : neighbour_leaves(cells_.tree(), 0, top.cell))
      if (!is_done[next] && !is_at_start(next))
        queue.push({std::min(top.level, cells_.upper(next, little)), next, top.from});
  }
  sealed_.insert(start);
}

}  // namespace parallel_aspects
