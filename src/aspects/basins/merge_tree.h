// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BASINS_MERGE_TREE_H
#define PARALLEL_ASPECTS_ASPECTS_BASINS_MERGE_TREE_H

#include "aspects/basins/index_cells.h"
#include "aspects/tree/pose_tree.h"

#include <cstddef>
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BASINS_MERGE_TREE_H
