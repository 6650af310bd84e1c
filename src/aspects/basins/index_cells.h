// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BASINS_INDEX_CELLS_H
#define PARALLEL_ASPECTS_ASPECTS_BASINS_INDEX_CELLS_H

#include "aspects/map/map_contents.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/basins.h"
#include "parallel_aspects/singularity/indices.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The leaves of one working mode of a map that may hold poses of one sign of det A, as *cells* that can be
/// halved further, with bounds of an index at these poses. The map must outlive this.
class IndexCells {
 public:
  IndexCells(const AspectMap::Contents& map, std::size_t mode, int sign, ParallelIndex index);

  const PoseTree& tree() const noexcept { return tree_; }

  bool is_cell(NodeIndex node) const noexcept { return tree_.state(node, 0).may_be(sign_); }
  /// Whether all its poses are proved to belong to S(mode, sign).
  bool is_inside(NodeIndex node) const noexcept { return tree_.state(node, 0).is_inside(sign_); }
  /// Whether all that it holds of S(mode, sign) is proved to lie in one aspect.
  bool is_whole(NodeIndex node) const noexcept { return tree_.state(node, 0).is_whole(sign_); }
  std::vector<NodeIndex> all() const;

  /// No index in it is higher. Bounds are computed when they are first asked for, so that only one thread may
  /// ask.
  double upper(NodeIndex cell) const { return bounds(cell, usual_effort(cell)).upper; }
  /// None is lower; 0 where not all poses are proved to belong to S(mode, sign).
  double lower(NodeIndex cell) const { return bounds(cell, usual_effort(cell)).lower; }

  /// Likewise of any node, divided or not.
  enum class Effort : std::uint8_t { none, little, more };
  double upper(NodeIndex node, Effort effort) const { return bounds(node, effort).upper; }
  /// What was spent on it so far.
  Effort effort(NodeIndex node) const noexcept { return bounds_[node].effort; }
  /// Computes all that is not known yet, in parallel.
  void bound_all() const;

  /// Id of the aspect that all poses of S(mode, sign) in it are proved to lie in; 0 where that is not known.
  int aspect(NodeIndex cell) const noexcept { return aspects_[cell]; }
  /// For what was proved since.
  void set_aspect(NodeIndex cell, int id) noexcept { aspects_[cell] = id; }

  bool can_be_halved(NodeIndex cell) const noexcept {
    return tree_.place(cell).level < PoseTree::deepest_level;
  }

  /// The index at one pose. 0 to the largest where it is not known.
  IndexRange at(const MapPosition& position) const;

  /// Halves these cells along every coordinate, those alone that can be. Returns their children that are
  /// cells.
  std::vector<NodeIndex> divide(const std::vector<NodeIndex>& cells);

 private:
  void copy(NodeIndex from, NodeIndex to);
  NodeIndex add_children(NodeIndex cell);
  void classify(NodeIndex node);
  struct Bounds {
    double lower = 0.0, upper = std::numeric_limits<double>::infinity();
    Effort effort = Effort::none;
  };

  /// That of the inside pays, of undecided ones the upper bound alone counts.
  Effort usual_effort(NodeIndex cell) const noexcept {
    return is_inside(cell) ? Effort::more : Effort::little;
  }
  const Bounds& bounds(NodeIndex node, Effort effort) const;

  const AspectMap::Contents& map_;
  std::size_t mode_;
  int sign_;
  ParallelIndex index_;
  PoseTree tree_;  // of this mode alone
  std::vector<int> aspects_;
  mutable std::vector<Bounds> bounds_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BASINS_INDEX_CELLS_H
