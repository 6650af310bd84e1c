// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BASINS_DEEPEST_INDEX_H
#define PARALLEL_ASPECTS_ASPECTS_BASINS_DEEPEST_INDEX_H

#include "aspects/basins/index_cells.h"
#include "parallel_aspects/aspects/basins.h"
#include "parallel_aspects/aspects/map_control.h"

#include <cstddef>
#include <map>
#include <queue>
#include <set>
#include <vector>

namespace parallel_aspects {

/// Looks for the largest index in each aspect of one working mode and sign of det A, best first: of the cells
/// that may hold it the one with the highest upper bound is halved.
///
/// An aspect lies in its own cells and in *groups* of cells of no known aspect, undecided ones, that are
/// connected with it. What is inside such a group and shares a face with the aspect is found to belong to it.
class DeepestIndex {
 public:
  DeepestIndex(IndexCells& cells, ParallelIndex index, const MapControl& control);

  void search();

  /// The largest index in each aspect, by id.
  std::map<int, IndexRange> ranges() const;

 private:
  struct ByUpper {
    const IndexCells* cells;
    bool operator()(NodeIndex a, NodeIndex b) const { return cells->upper(a) < cells->upper(b); }
  };
  using Queue = std::priority_queue<NodeIndex, std::vector<NodeIndex>, ByUpper>;

  struct InAspect {
    Queue cells;
    double lower = 0.0;
  };
  struct Group {
    Queue cells;
    std::set<int> aspects;
  };

  void put(NodeIndex cell);
  void halve_aspects();
  bool halve_groups();
  void find_groups();
  void halve(Group& group);
  void put(NodeIndex child, Group& group);
  void spread_aspect(NodeIndex inside);
  double enough(const Group& group) const;
  double upper(const Queue& queue) const { return queue.empty() ? 0.0 : cells_.upper(queue.top()); }

  IndexCells& cells_;
  double absolute_;
  const MapControl& control_;
  std::map<int, InAspect> aspects_;
  std::vector<Group> groups_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BASINS_DEEPEST_INDEX_H
