// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_WORKSPACE_SHAPE_SEARCH_H
#define PARALLEL_ASPECTS_ASPECTS_WORKSPACE_SHAPE_SEARCH_H

#include "aspects/workspace/shape_room.h"
#include "parallel_aspects/aspects/regular_workspace.h"

#include <cstddef>
#include <optional>
#include <queue>
#include <vector>

namespace parallel_aspects {

/// Branch and bound over boxes of centers, the box that may hold the best one first. The room about a center
/// changes by no more than the center moves, in the norm of `ShapeGauge`: that of a box is at most what is
/// about its middle and half its extent. Needs a live `RoundingUpward`.
class ShapeSearch {
 public:
  /// `like`: ids of the aspects that may be the same one as `aspect`, itself among them. Shapes of
  /// `of_interest` or less are not distinguished.
  ShapeSearch(UsableLeaves& leaves, const ShapeGauge& gauge, int aspect, std::vector<int> like,
              double of_interest, const WorkspaceOptions& options);

  /// Among these centers; `first` is tried before all others. To be called once.
  RegularWorkspace run(const Box& centers, const MapPoint& first);

 private:
  /// A box of centers, and a bound of the room about all of them.
  struct Cell {
    Box centers;
    double bound;
    std::optional<MapPoint> obstacle;  ///< that limits the room about its middle
    bool operator<(const Cell& other) const { return bound < other.bound; }
  };

  double enough() const;
  double finest_extent(double size) const;
  ShapeRoom room_about(const MapPoint& center, double half);
  void push(const Box& centers, double bound, const std::optional<MapPoint>& obstacle);
  void add(const Cell& cell, double half_extent);
  void give_up(double bound);
  void take(const MapPoint& center, double size);
  void halve(const Cell& cell);
  void settle(const Box& centers);

  UsableLeaves& leaves_;
  const ShapeGauge& gauge_;
  std::vector<int> like_;
  double of_interest_;
  const WorkspaceOptions& options_;
  RegularWorkspace best_;
  double whole_ = 0.0;  // extent of all positions
  std::priority_queue<Cell> queue_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_WORKSPACE_SHAPE_SEARCH_H
