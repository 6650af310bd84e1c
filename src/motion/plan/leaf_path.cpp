// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/leaf_path.h"

#include "aspects/map/map_location.h"
#include "aspects/tree/near_leaves.h"
#include "aspects/tree/neighbour_leaves.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>

namespace parallel_aspects {
namespace {

// A path along the boundary counts as so many times longer, where a leaf is as small as the resolution.
constexpr double cost_of_small_leaves = 3.0;

class LeafSearch {
 public:
  LeafSearch(const AspectMap::Contents& map, const Aspect& aspect, const Pose& from, const Pose& to)
      : map_(map), aspect_(aspect), mode_(*mode_index(map, aspect.mode)), from_(from), to_(to) {}

  std::vector<Pose> run() {
    const std::optional<NodeIndex> first = leaf_near(from_), last = leaf_near(to_);
    if (!first || !last) return {};
    last_ = *last;
    reached_[*first] = {0.0, *first, from_};
    open_.push({distance(from_, to_), *first});
    while (!open_.empty()) {
      const NodeIndex leaf = open_.top().leaf;
      if (leaf == last_) return path(*first);
      open_.pop();
      if (!closed_.emplace(leaf, true).second) continue;
      for (const NodeIndex next : neighbour_leaves(map_.tree, mode_, leaf)) reach(leaf, next);
    }
    return {};
  }

 private:
  /// How a leaf was reached: through which pose of a face, and from which leaf.
  struct Entry {
    double cost = std::numeric_limits<double>::infinity();
    NodeIndex before = no_node;
    Pose at;
  };
  struct Open {
    double bound;
    NodeIndex leaf;
    friend bool operator<(const Open& a, const Open& b) { return a.bound > b.bound; }
  };

  double distance(const Pose& a, const Pose& b) const { return distance_between(*map_.manipulator, a, b); }

  bool is_of_aspect(NodeIndex leaf) const { return map_.leaf_aspect(leaf, mode_) == aspect_.id; }

  std::optional<NodeIndex> leaf_near(const Pose& pose) const {
    const MapPosition position = map_.tree.space().position(pose);
    const NearLeaves near = near_inside_leaves(map_.tree, mode_, aspect_.determinant_sign, position);
    for (std::size_t i = 0; i < near.count; ++i)
      if (is_of_aspect(near.items[i].leaf)) return near.items[i].leaf;
    return std::nullopt;
  }

  double price(NodeIndex leaf) const {
    const double edge = map_.tree.space().longest_edge(map_.tree.box(leaf));
    return 1.0 + cost_of_small_leaves * std::min(1.0, map_.resolution / edge);
  }

  void reach(NodeIndex leaf, NodeIndex next) {
    if (!is_of_aspect(next) || closed_.count(next) > 0) return;
    const Entry& entry = reached_[leaf];
    const Entry here{entry.cost, entry.before, entry.at};
    for (const SharedFace& face : shared_faces(map_.tree, leaf, next)) {
      const Pose at = map_.tree.space().pose({face.root, nearest(face.box, here.at)});
      const double cost = here.cost + price(leaf) * distance(here.at, at);
      Entry& there = reached_[next];
      if (cost >= there.cost) continue;
      there = {cost, leaf, at};
      open_.push({cost + distance(at, to_), next});
    }
  }

  /// Of a face, halfway from its middle to what is nearest to a pose: paths are straighter so, and keep off
  /// the edges.
  MapPoint nearest(const Box& face, const Pose& pose) const {
    const MapPoint middle = face.middle();
    const MapPoint near = face.nearest(map_.tree.space().position(pose).point);
    MapPoint point = middle;
    for (std::size_t i = 0; i < face.dimension; ++i) point[i] = 0.5 * (middle[i] + near[i]);
    return point;
  }

  std::vector<Pose> path(NodeIndex first) {
    std::vector<Pose> poses{to_};
    for (NodeIndex leaf = last_; leaf != first; leaf = reached_[leaf].before)
      poses.push_back(reached_[leaf].at);
    poses.push_back(from_);
    std::reverse(poses.begin(), poses.end());
    return poses;
  }

  const AspectMap::Contents& map_;
  const Aspect& aspect_;
  std::size_t mode_;
  const Pose &from_, &to_;
  NodeIndex last_ = no_node;
  std::unordered_map<NodeIndex, Entry> reached_;
  std::unordered_map<NodeIndex, bool> closed_;
  std::priority_queue<Open> open_;
};

}  // namespace

double distance_between(const Manipulator& manipulator, const Pose& from, const Pose& to) {
  const double angle = from.orientation.angularDistance(to.orientation);
  return std::hypot((to.position - from.position).norm(), manipulator.characteristic_length() * angle);
}

std::vector<Pose> find_leaf_path(const AspectMap::Contents& map, int aspect, const Pose& from,
                                 const Pose& to) {
  return LeafSearch(map, map.aspects[static_cast<std::size_t>(aspect - 1)], from, to).run();
}

}  // namespace parallel_aspects
