// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/basins/merge_tree.h"

#include "aspects/components/disjoint_sets.h"
#include "aspects/tree/face_traversal.h"

#include <algorithm>

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

}  // namespace parallel_aspects
