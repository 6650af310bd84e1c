// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_MERGE_TREE_H
#define PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_MERGE_TREE_H

#include "aspects/components/disjoint_sets.h"
#include "aspects/persistence/index_cells.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Two cells that share part of a face, and a number that a path from one into the other can keep.
struct CellEdge {
  NodeIndex first, second;
  double level;
};

/// Which bound of the index counts along a path.
enum class PathBound { lower, upper };

/// All edges between cells, by falling level; those of level 0 are left out.
std::vector<CellEdge> edges_of(const IndexCells& cells, PathBound bound);

/// A set of cells around its peak that joins, where the level has fallen to `level`, another one with a
/// higher peak.
struct PeakMerge {
  NodeIndex peak, higher;
  double level;
  double largest;  ///< of the upper bounds in the set: no index in it is higher
};

/// What happens as edges are added by falling level: the merges whose peaks are both above it. `edges` by
/// upper bounds; a peak is the cell with the highest lower bound.
std::vector<PeakMerge> merge(const IndexCells& cells, const std::vector<CellEdge>& edges);

/// The level at which each pair of nodes is joined; 0 where they never are. `edges` by falling level.
std::vector<double> levels_of_joining(std::size_t node_count, const std::vector<CellEdge>& edges,
                                      const std::vector<std::pair<NodeIndex, NodeIndex>>& pairs);

/// The largest index that a path between two aspects could keep, from above.
///
/// Of all paths through cells of no known aspect, by the least upper bound of the index along each: these
/// link the aspects to a graph, in which every path from one to another has an image that is no worse. The
/// best path of that graph is one in its maximum spanning tree. The tree grows from the smaller aspects, each
/// by the best link that leaves it (Boruvka), so that the cells of the largest are hardly examined.
class AspectLinks {
 public:
  /// Pairs of ids. The cells must know which aspects they belong to, and outlive this.
  AspectLinks(const IndexCells& cells, std::vector<std::pair<int, int>> pairs, const MapControl& control);

  /// By pair; 0 where nothing links the two.
  std::vector<double> levels();

 private:
  /// Of inside cells alone: paths between components begin and end in these.
  int known_aspect(NodeIndex cell) const { return cells_.is_inside(cell) ? cells_.aspect(cell) : 0; }
  std::vector<int> smallest_open_cluster();
  void link_once(const std::vector<int>& cluster);

  const IndexCells& cells_;
  std::vector<std::pair<int, int>> pairs_;
  const MapControl& control_;
  std::map<int, std::set<NodeIndex>> rims_;  // by id: cells that share a face with others
  DisjointSets clusters_;                    // of ids
  std::set<NodeIndex> sealed_;               // clusters that nothing leads out of
  std::vector<CellEdge> links_;              // between ids in place of cells
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_MERGE_TREE_H
