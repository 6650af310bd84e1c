// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/deepest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace parallel_aspects {
namespace {

constexpr double relative_precision = 0.01;

/// Nearest leaf that is not of the aspect, by descending the tree and leaving out what is farther than the
/// best.
class NearestForeignLeaf {
 public:
  NearestForeignLeaf(const AspectMap::Contents& map, int aspect, std::size_t mode, const MapPoint& point)
      : map_(map), aspect_(aspect), mode_(mode), point_(point) {}

  double distance() {
    const Box& region = map_.tree.region();
    for (std::size_t i = 0; i < region.dimension; ++i)
      keep(std::max(0.0, std::min(point_[i] - region.lower[i], region.upper[i] - point_[i])));
    descend(0);
    return std::sqrt(best_);
  }

 private:
  void keep(double distance) { best_ = std::min(best_, distance * distance); }

  void descend(NodeIndex node) {
    const Box box = map_.tree.box(node);
    const double distance = box.squared_distance(point_);
    if (distance >= best_) return;
    if (!map_.tree.state(node, mode_).is_divided()) {
      if (map_.leaf_aspect(node, mode_) != aspect_) best_ = distance;
      return;
    }
    const NodeIndex nearest = box.rank_of(point_);
    for (NodeIndex rank = 0; rank < map_.tree.children_per_node(); ++rank)
      descend(map_.tree.first_child(node) + (rank ^ nearest));
  }

  const AspectMap::Contents& map_;
  int aspect_;
  std::size_t mode_;
  MapPoint point_;
  double best_ = std::numeric_limits<double>::infinity();
};

/// A box whose points are all at most `bound` clear.
struct Cell {
  Box box;
  ClearPoint center;
  double bound = 0.0;

  bool operator<(const Cell& other) const { return bound < other.bound; }
};

MapPoint center_of(const Box& box) {
  MapPoint point{};
  for (std::size_t i = 0; i < box.dimension; ++i) point[i] = box.center(i);
  return point;
}

Cell cell(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode, const Box& box) {
  double squared_diagonal = 0.0;
  for (std::size_t i = 0; i < box.dimension; ++i) squared_diagonal += box.width(i) * box.width(i);
  const MapPoint point = center_of(box);
  const double clear = clearance(map, aspect, mode, point);
  return {box, {point, clear}, clear + 0.5 * std::sqrt(squared_diagonal)};
}

Box half(const Box& box, std::size_t i, bool upper) {
  Box result = box;
  (upper ? result.lower[i] : result.upper[i]) = box.center(i);
  return result;
}

}  // namespace

double clearance(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode,
                 const MapPoint& point) {
  return NearestForeignLeaf(map, aspect.id, mode, point).distance();
}

ClearPoint deepest_point(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode) {
  std::priority_queue<Cell> queue;
  queue.push(cell(map, aspect, mode, aspect.bounds));
  ClearPoint best = queue.top().center;
  while (!queue.empty() && queue.top().bound > best.clearance * (1.0 + relative_precision)) {
    const Box box = queue.top().box;
    queue.pop();
    std::size_t longest = 0;
    for (std::size_t i = 1; i < box.dimension; ++i)
      if (box.width(i) > box.width(longest)) longest = i;
    for (const bool upper : {false, true}) {
      const Cell next = cell(map, aspect, mode, half(box, longest, upper));
      if (next.center.clearance > best.clearance) best = next.center;
      if (next.bound > best.clearance * (1.0 + relative_precision)) queue.push(next);
    }
  }
  return best;
}

}  // namespace parallel_aspects
