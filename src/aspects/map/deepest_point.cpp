// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/deepest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace parallel_aspects {
namespace {

// Of the radius that is found. Where an aspect is long and everywhere as wide, nearly every part of it may
// hold the largest ball; after so many boxes the second one will do.
constexpr double relative_precision = 0.01, precision_of_long_searches = 0.1;
constexpr std::size_t boxes_of_long_searches = 20000;

/// Nearest leaf that is not of the aspect, by descending the tree and leaving out what is farther than the
/// best.
class NearestForeignLeaf {
 public:
  NearestForeignLeaf(const AspectMap::Contents& map, int aspect, std::size_t mode,
                     const MapPosition& position, double of_interest)
      : map_(map),
        aspect_(aspect),
        mode_(mode),
        weights_(map.tree.space().weights()),
        position_(position),
        enough_(of_interest > 0.0 ? of_interest * of_interest : 0.0) {}

  double distance() {
    const Box& region = map_.tree.region();
    look_around(0);
    for (std::size_t i = 0; i < region.dimension; ++i)
      if (!map_.tree.space().is_periodic(i)) keep_distance_to_face(i, region);
    return std::sqrt(best_);
  }

 private:
  void keep_distance_to_face(std::size_t i, const Box& region) {
    const double nearest =
        std::min(position_.point[i] - region.lower[i], region.upper[i] - position_.point[i]);
    const double distance = weights_[i] * std::max(0.0, nearest);
    best_ = std::min(best_, distance * distance);
  }

  // From the position and, for what lies behind glued faces, from its images a period away: along coordinate
  // `first` and those after it.
  void look_around(std::size_t first) {
    if (first == map_.tree.dimension()) return descend(position_.root);
    look_around(first + 1);
    if (!map_.tree.space().is_periodic(first)) return;
    const double here = position_.point[first], period = map_.tree.region().width(first);
    for (const double shift : {-period, period}) {
      position_.point[first] = here + shift;
      look_around(first + 1);
    }
    position_.point[first] = here;
  }

  void descend(NodeIndex node) {
    if (best_ <= enough_) return;
    const Box box = map_.tree.box(node);
    const double distance = box.squared_distance(position_.point, weights_);
    if (distance >= best_) return;
    if (!map_.tree.state(node, mode_).is_divided()) {
      if (map_.leaf_aspect(node, mode_) != aspect_) best_ = distance;
      return;
    }
    const NodeIndex nearest = box.rank_of(position_.point);
    for (NodeIndex rank = 0; rank < map_.tree.children_per_node(); ++rank)
      descend(map_.tree.first_child(node) + (rank ^ nearest));
  }

  const AspectMap::Contents& map_;
  int aspect_;
  std::size_t mode_;
  MapPoint weights_;
  MapPosition position_;
  double enough_;  // squared distance below which nothing more is asked
  double best_ = std::numeric_limits<double>::infinity();
};

/// A box whose points are all at most `bound` clear.
struct Cell {
  Box box;
  ClearPoint center;
  double bound = 0.0;

  bool operator<(const Cell& other) const { return bound < other.bound; }
};

/// Best-first search over boxes.
class Search {
 public:
  Search(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode, const MapControl& control)
      : map_(map), aspect_(aspect), mode_(mode), control_(control), weights_(map.tree.space().weights()) {}

  ClearPoint run() {
    const auto& bounds = map_.aspect_bounds[static_cast<std::size_t>(aspect_.id - 1)];
    for (RootIndex root = 0; root < bounds.size(); ++root)
      if (bounds[root].dimension != 0) push(root, bounds[root]);
    while (!queue_.empty() && worth(queue_.top()) && !is_cancelled(control_)) {
      const Cell top = queue_.top();
      queue_.pop();
      divide(top);
    }
    return best_;
  }

 private:
  double least_bound() const {
    return best_.clearance *
           (1.0 + (boxes_ < boxes_of_long_searches ? relative_precision : precision_of_long_searches));
  }
  bool worth(const Cell& cell) const { return cell.bound > least_bound(); }

  double edge(const Box& box, std::size_t i) const { return weights_[i] * box.width(i); }

  void push(RootIndex root, const Box& box) {
    ++boxes_;
    double squared_diagonal = 0.0;
    for (std::size_t i = 0; i < box.dimension; ++i) squared_diagonal += edge(box, i) * edge(box, i);
    const MapPosition middle{root, box.middle()};
    const double half_diagonal = 0.5 * std::sqrt(squared_diagonal);
    const double worth_from = std::min(best_.clearance, least_bound() - half_diagonal);
    const double clear = clearance(map_, aspect_, mode_, middle, worth_from);
    const Cell cell{box, {middle, clear}, clear + half_diagonal};
    if (clear > best_.clearance) best_ = cell.center;
    if (worth(cell)) queue_.push(cell);
  }

  void divide(const Cell& cell) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < cell.box.dimension; ++i)
      if (edge(cell.box, i) > edge(cell.box, longest)) longest = i;
    Box lower = cell.box, upper = cell.box;
    lower.upper[longest] = upper.lower[longest] = cell.box.center(longest);
    push(cell.center.position.root, lower);
    push(cell.center.position.root, upper);
  }

  const AspectMap::Contents& map_;
  const Aspect& aspect_;
  std::size_t mode_;
  const MapControl& control_;
  MapPoint weights_;
  ClearPoint best_;
  std::size_t boxes_ = 0;  // that were looked at
  std::priority_queue<Cell> queue_;
};

}  // namespace

double clearance(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode,
                 const MapPosition& position, double of_interest) {
  return NearestForeignLeaf(map, aspect.id, mode, position, of_interest).distance();
}

ClearPoint deepest_point(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode,
                         const MapControl& control) {
  return Search(map, aspect, mode, control).run();
}

}  // namespace parallel_aspects
