// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/deepest_point.h"

#include <algorithm>
#include <array>
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
/// best. Boxes are halved on the way down, which is exact, so that only states of nodes are read.
class NearestForeignLeaf {
 public:
  /// `likely`: a leaf that is not of the aspect and may be near, or `no_node`. It only saves time.
  NearestForeignLeaf(const AspectMap::Contents& map, int aspect, std::size_t mode,
                     const MapPosition& position, double of_interest, NodeIndex likely)
      : map_(map),
        aspect_(aspect),
        mode_(mode),
        weights_(map.tree.space().weights()),
        position_(position),
        enough_(of_interest > 0.0 ? of_interest * of_interest : 0.0),
        nearest_(likely) {}

  double distance() {
    const Box& region = map_.tree.region();
    if (nearest_ != no_node && map_.tree.place(nearest_).root == position_.root) {
      const Box likely = map_.tree.box(nearest_);
      look_around(0, [&] { best_ = std::min(best_, likely.squared_distance(position_.point, weights_)); });
    }
    look_around(0, [&] { look_from_root(region); });
    for (std::size_t i = 0; i < region.dimension; ++i)
      if (!map_.tree.space().is_periodic(i)) keep_distance_to_face(i, region);
    return std::sqrt(best_);
  }

  /// The leaf that was found, or another one as near.
  NodeIndex nearest() const { return nearest_; }

 private:
  void keep_distance_to_face(std::size_t i, const Box& region) {
    const double nearest =
        std::min(position_.point[i] - region.lower[i], region.upper[i] - position_.point[i]);
    const double distance = weights_[i] * std::max(0.0, nearest);
    best_ = std::min(best_, distance * distance);
  }

  // From the position and, for what lies behind glued faces, from its images a period away: along coordinate
  // `first` and those after it.
  template <class Look>
  void look_around(std::size_t first, const Look& look) {
    if (first >= std::min(map_.tree.dimension(), max_map_dimension)) return look();
    look_around(first + 1, look);
    if (!map_.tree.space().is_periodic(first)) return;
    const double here = position_.point[first], period = map_.tree.region().width(first);
    for (const double shift : {-period, period}) {
      position_.point[first] = here + shift;
      look_around(first + 1, look);
    }
    position_.point[first] = here;
  }

  void look_from_root(const Box& region) {
    const double distance = region.squared_distance(position_.point, weights_);
    if (best_ <= enough_ || distance >= best_) return;
    if (!map_.tree.state(position_.root, mode_).is_divided()) return keep_leaf(position_.root, distance);
    switch (region.dimension) {
      case 1:
        return descend<1>(position_.root, region.lower, region.upper);
      case 2:
        return descend<2>(position_.root, region.lower, region.upper);
      default:
        return descend<3>(position_.root, region.lower, region.upper);
    }
  }

  /// Into the children of a divided node, the nearest first.
  template <std::size_t Dimension>
  void descend(NodeIndex node, const MapPoint& lower, const MapPoint& upper) {
    std::array<std::array<double, 3>, Dimension> ends;
    std::array<std::array<double, 2>, Dimension> squares;  // of the distance from each half
    NodeIndex nearest = 0;
    for (std::size_t i = 0; i < Dimension; ++i) {
      const double at = position_.point[i], center = 0.5 * (lower[i] + upper[i]);
      ends[i] = {lower[i], center, upper[i]};
      if (at >= center) nearest |= NodeIndex{1} << i;
      for (std::size_t half = 0; half < 2; ++half) {
        const double difference = weights_[i] * (at - std::clamp(at, ends[i][half], ends[i][half + 1]));
        squares[i][half] = difference * difference;
      }
    }
    const NodeIndex first = map_.tree.first_child(node);
    for (NodeIndex turn = 0; turn < NodeIndex{1} << Dimension && best_ > enough_; ++turn) {
      const NodeIndex rank = turn ^ nearest;
      double distance = 0.0;
      for (std::size_t i = 0; i < Dimension; ++i) distance += squares[i][rank >> i & 1U];
      if (distance >= best_) continue;
      if (!map_.tree.state(first + rank, mode_).is_divided()) {
        keep_leaf(first + rank, distance);
        continue;
      }
      MapPoint from{}, to{};
      for (std::size_t i = 0; i < Dimension; ++i) {
        from[i] = ends[i][rank >> i & 1U];
        to[i] = ends[i][(rank >> i & 1U) + 1];
      }
      descend<Dimension>(first + rank, from, to);
    }
  }

  void keep_leaf(NodeIndex leaf, double distance) {
    if (map_.tree.state(leaf, mode_).is_inside() && map_.leaf_aspect(leaf, mode_) == aspect_) return;
    best_ = distance;
    nearest_ = leaf;
  }

  const AspectMap::Contents& map_;
  int aspect_;
  std::size_t mode_;
  MapPoint weights_;
  MapPosition position_;
  double enough_;  // squared distance below which nothing more is asked
  double best_ = std::numeric_limits<double>::infinity();
  NodeIndex nearest_;
};

/// A box whose points are all at most `bound` clear.
struct Cell {
  Box box;
  ClearPoint center;
  NodeIndex foreign;  // a leaf that is not of the aspect, near the center
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
      if (bounds[root].dimension != 0) push(root, bounds[root], no_node);
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

  void push(RootIndex root, const Box& box, NodeIndex foreign) {
    ++boxes_;
    double squared_diagonal = 0.0;
    for (std::size_t i = 0; i < box.dimension; ++i) squared_diagonal += edge(box, i) * edge(box, i);
    const MapPosition middle{root, box.middle()};
    const double half_diagonal = 0.5 * std::sqrt(squared_diagonal);
    const double worth_from = std::min(best_.clearance, least_bound() - half_diagonal);
    NearestForeignLeaf search(map_, aspect_.id, mode_, middle, worth_from, foreign);
    const double clear = search.distance();
    const Cell cell{box, {middle, clear}, search.nearest(), clear + half_diagonal};
    if (clear > best_.clearance) best_ = cell.center;
    if (worth(cell) && farthest_from(search.nearest(), root, box) > best_.clearance) queue_.push(cell);
  }

  /// No point of the box is farther from this leaf that is not of the aspect.
  double farthest_from(NodeIndex leaf, RootIndex root, const Box& box) const {
    if (leaf == no_node || map_.tree.place(leaf).root != root) return std::numeric_limits<double>::infinity();
    const Box foreign = map_.tree.box(leaf);
    double square = 0.0;
    for (std::size_t i = 0; i < box.dimension; ++i) {
      const double beyond = std::max({0.0, foreign.lower[i] - box.lower[i], box.upper[i] - foreign.upper[i]});
      square += weights_[i] * beyond * weights_[i] * beyond;
    }
    return std::sqrt(square);
  }

  void divide(const Cell& cell) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < cell.box.dimension; ++i)
      if (edge(cell.box, i) > edge(cell.box, longest)) longest = i;
    Box lower = cell.box, upper = cell.box;
    lower.upper[longest] = upper.lower[longest] = cell.box.center(longest);
    push(cell.center.position.root, lower, cell.foreign);
    push(cell.center.position.root, upper, cell.foreign);
  }

  const AspectMap::Contents& map_;
  const Aspect& aspect_;
  std::size_t mode_;
  const MapControl& control_;
  MapPoint weights_;
  ClearPoint best_;
  std::size_t boxes_ = 0;  // that were examined
  std::priority_queue<Cell> queue_;
};

}  // namespace

double clearance(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode,
                 const MapPosition& position, double of_interest) {
  return NearestForeignLeaf(map, aspect.id, mode, position, of_interest, no_node).distance();
}

ClearPoint deepest_point(const AspectMap::Contents& map, const Aspect& aspect, std::size_t mode,
                         const MapControl& control) {
  return Search(map, aspect, mode, control).run();
}

}  // namespace parallel_aspects
