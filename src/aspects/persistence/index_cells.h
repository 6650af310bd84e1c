// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_INDEX_CELLS_H
#define PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_INDEX_CELLS_H

#include "aspects/map/map_contents.h"
#include "aspects/tree/pose_tree.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// An index in one working mode and for one sign of det A.
struct IndexOfMode {
  std::size_t mode;
  int sign;
  ParallelIndex index;
};

/// The share of `BoxClassifier::enclose_index` with which every enclosure is close enough.
inline constexpr double any_index_gap = 1.0;

/// Bounds of the index at one pose; 0 to the largest where it is not known.
IndexRange index_at(const AspectMap::Contents& map, const IndexOfMode& what, const MapPosition& position);

/// No index in the region of the map is larger.
double largest_in_region(const AspectMap::Contents& map, const IndexOfMode& what);

/// A position at which the index is no less than this.
struct IndexPeak {
  double index = 0.0;
  MapPosition at;
};

/// One of each aspect of the mode and sign, by id. Each is as high as steps to neighbours in finer and finer
/// grids lead from the highest of some leaves; others may be higher.
std::map<int, IndexPeak> find_index_peaks(const AspectMap::Contents& map, const IndexOfMode& what,
                                          const MapControl& control);

/// The leaves of one working mode of a map that may hold poses of one sign of det A, as *cells* that can be
/// halved further, with bounds of an index at these poses. The map must outlive this.
class IndexCells {
 public:
  IndexCells(const AspectMap::Contents& map, const IndexOfMode& what);

  const PoseTree& tree() const noexcept { return tree_; }
  ParallelIndex index() const noexcept { return what_.index; }

  bool is_cell(NodeIndex node) const noexcept { return tree_.state(node, 0).may_be(what_.sign); }
  /// Whether all its poses are proved to belong to S(mode, sign).
  bool is_inside(NodeIndex node) const noexcept { return tree_.state(node, 0).is_inside(what_.sign); }
  /// Whether all that it holds of S(mode, sign) is proved to lie in one aspect.
  bool is_whole(NodeIndex node) const noexcept { return tree_.state(node, 0).is_whole(what_.sign); }
  std::vector<NodeIndex> all() const;

  /// No index in it is higher. Bounds are computed when they are first asked for, so that only one thread may
  /// ask.
  double upper(NodeIndex cell) const { return bounds(cell, usual_effort(cell)).upper; }
  /// None is lower; 0 where not all poses are proved to belong to S(mode, sign).
  double lower(NodeIndex cell) const { return bounds(cell, usual_effort(cell)).lower; }

  /// Likewise of any node, divided or not.
  enum class Effort : std::uint8_t { none, little, more };
  double upper(NodeIndex node, Effort effort) const { return bounds(node, effort).upper; }
  /// The work that was spent on it so far.
  Effort effort(NodeIndex node) const noexcept { return bounds_[node].effort; }
  /// Computes those of several nodes at once, as far as they are not known yet.
  struct Question {
    NodeIndex node;
    Effort effort;
  };
  void bound(const std::vector<Question>& questions) const;
  /// Computes all that is not known yet, in parallel.
  void bound_all() const;
  /// Works out the bounds with more effort of a node that will be asked for next, and of some that may be
  /// soon: the first of a heap of others. What is known of these changes when it is asked for.
  template <class Heap, class NodeOf>
  void foresee(NodeIndex node, const Heap& heap, const NodeOf& node_of) const;

  /// Id of the aspect that all poses of S(mode, sign) in it are proved to lie in; 0 where that is not known.
  int aspect(NodeIndex cell) const noexcept { return aspects_[cell]; }
  /// Notes what was proved since.
  void set_aspect(NodeIndex cell, int id) noexcept { aspects_[cell] = id; }

  bool can_be_halved(NodeIndex cell) const noexcept {
    return tree_.place(cell).level < PoseTree::deepest_level;
  }

  /// See `index_at`.
  IndexRange at(const MapPosition& position) const { return index_at(map_, what_, position); }

  /// Halves these cells along every coordinate, those alone that can be. Returns their children that are
  /// cells.
  std::vector<NodeIndex> divide(const std::vector<NodeIndex>& cells);

 private:
  void copy(NodeIndex from, NodeIndex to);
  NodeIndex add_children(NodeIndex cell);
  void classify_pending(const NodeIndex* nodes, std::size_t count);
  struct Bounds {
    double lower = 0.0, upper = std::numeric_limits<double>::infinity();
    Effort effort = Effort::none;
  };

  /// That of the inside pays, of undecided ones the upper bound alone counts.
  Effort usual_effort(NodeIndex cell) const noexcept {
    return is_inside(cell) ? Effort::more : Effort::little;
  }
  const Bounds& bounds(NodeIndex node, Effort effort) const;
  bool is_unforeseen(NodeIndex node) const {
    return bounds_[node].effort < Effort::more && foreseen_.count(node) == 0;
  }
  void foresee(const std::vector<NodeIndex>& nodes) const;
  std::vector<Interval> enclose(const std::vector<Question>& questions) const;
  void take_in(const Question& question, const Interval& range) const;

  // As many as the widest vectors have lanes, out of the first levels of a heap.
  static constexpr std::size_t foreseen_at_once = 8, most_looked_at = 15;

  const AspectMap::Contents& map_;
  IndexOfMode what_;
  PoseTree tree_;  // of this mode alone
  std::vector<int> aspects_;
  mutable std::vector<Bounds> bounds_;
  mutable std::unordered_map<NodeIndex, Interval> foreseen_;
};

template <class Heap, class NodeOf>
void IndexCells::foresee(NodeIndex node, const Heap& heap, const NodeOf& node_of) const {
  if (!is_unforeseen(node)) return;
  std::vector<NodeIndex> nodes{node};
  for (std::size_t i = 0; i < std::min(heap.size(), most_looked_at) && nodes.size() < foreseen_at_once; ++i)
    if (const NodeIndex other = node_of(heap[i]); other != node && is_unforeseen(other))
      nodes.push_back(other);
  if (nodes.size() > 1) foresee(nodes);
}

/// A priority queue whose first entries, which come out soon, can be examined.
template <class Entry>
struct OpenQueue : std::priority_queue<Entry> {
  const std::vector<Entry>& heap() const noexcept { return this->c; }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_INDEX_CELLS_H
