// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/leaf_path.h"

#include "aspects/map/map_location.h"
#include "aspects/tree/near_leaves.h"
#include "aspects/tree/neighbour_leaves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>
#include <unordered_set>

namespace parallel_aspects {
namespace {

// What a path counts in a leaf as small as the resolution, and more in an undecided one.
constexpr double cost_of_small_leaves = 3.0, cost_of_undecided_leaves = 10.0;

/// A*, by the distance to the goal. The goal is `no_node`, which the leaves near it lead to.
class LeafSearch {
 public:
  LeafSearch(const AspectMap::Contents& map, const Aspect& aspect, const Pose& from, const Pose& to,
             const LeafChoice& choice)
      : map_(map),
        aspect_(aspect),
        mode_(*mode_index(map, aspect.mode)),
        from_(from),
        to_(to),
        choice_(choice) {}

  std::vector<LeafStep> run() {
    for (const NodeIndex leaf : leaves_near(to_)) last_.insert(leaf);
    for (const NodeIndex leaf : leaves_near(from_))
      if (!is_barred(no_node, leaf)) enter(leaf, no_node, nearest_in(leaf, from_), 0.0);
    while (!open_.empty()) {
      const NodeIndex leaf = open_.top().leaf;
      if (leaf == no_node) return path();
      open_.pop();
      if (!closed_.insert(leaf).second) continue;
      if (last_.count(leaf) > 0 && !is_barred(leaf, no_node))
        enter(no_node, leaf, to_, reached_[leaf].cost + distance(reached_[leaf].at, to_));
      for (const NodeIndex next : neighbour_leaves(map_.tree, mode_, leaf)) reach(leaf, next);
    }
    return {};
  }

 private:
  /// How a leaf was reached: through which pose, and from which leaf.
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
  bool is_barred(NodeIndex from, NodeIndex to) const { return choice_.barred.count({from, to}) > 0; }
  bool is_inside(NodeIndex leaf) const { return map_.leaf_aspect(leaf, mode_) == aspect_.id; }

  bool may_pass(NodeIndex leaf) const {
    if (is_inside(leaf)) return true;
    const LeafState state = map_.tree.state(leaf, mode_);
    return choice_.undecided && state.is_undecided() && state.center_sign() == aspect_.determinant_sign;
  }

  std::vector<NodeIndex> leaves_near(const Pose& pose) const {
    const MapPosition position = map_.tree.space().position(pose);
    const NearLeaves near = near_inside_leaves(map_.tree, mode_, aspect_.determinant_sign, position);
    std::vector<NodeIndex> result;
    for (std::size_t i = 0; i < near.count; ++i) {
      if (is_inside(near.items[i].leaf)) result.push_back(near.items[i].leaf);
      if (near.items[i].squared_distance == 0.0 && !result.empty()) break;
    }
    return result;
  }

  double price(NodeIndex leaf) const {
    if (!is_inside(leaf)) return cost_of_undecided_leaves;
    const double edge = map_.tree.space().longest_edge(map_.tree.box(leaf));
    return 1.0 + cost_of_small_leaves * std::min(1.0, map_.resolution / edge);
  }

  void enter(NodeIndex leaf, NodeIndex before, const Pose& at, double cost) {
    Entry& entry = reached_[leaf];
    if (!(cost < entry.cost)) return;
    entry = {cost, before, at};
    open_.push({cost + distance(at, to_), leaf});
  }

  void reach(NodeIndex leaf, NodeIndex next) {
    if (!may_pass(next) || closed_.count(next) > 0 || is_barred(leaf, next)) return;
    const Entry here = reached_[leaf];
    const auto go = [&](const Pose& at) {
      enter(next, leaf, at, here.cost + price(next) * distance(here.at, at));
    };
    if (!is_inside(next)) return go(middle(next));
    for (const SharedFace& face : shared_faces(map_.tree, leaf, next))
      go(map_.tree.space().pose({face.root, nearest(face.box, here.at)}));
  }

  Pose middle(NodeIndex leaf) const {
    return map_.tree.space().pose({map_.tree.place(leaf).root, map_.tree.box(leaf).middle()});
  }

  /// The pose itself where the leaf holds it.
  Pose nearest_in(NodeIndex leaf, const Pose& pose) const {
    const MapPosition position = map_.tree.space().position(pose);
    const Box box = map_.tree.box(leaf);
    return box.contains(position.point)
               ? pose
               : map_.tree.space().pose({position.root, box.nearest(position.point)});
  }

  /// Of a face, halfway from its middle to what is nearest to a pose: paths are straighter so, and keep off
  /// the edges.
  MapPoint nearest(const Box& face, const Pose& pose) const {
    const MapPoint near = face.nearest(map_.tree.space().position(pose).point);
    MapPoint point = face.middle();
    for (std::size_t i = 0; i < face.dimension; ++i) point[i] = 0.5 * (point[i] + near[i]);
    return point;
  }

  std::vector<LeafStep> path() {
    const NodeIndex last = reached_[no_node].before;
    std::vector<LeafStep> steps{{to_, no_node}, {nearest_in(last, to_), last}};
    for (NodeIndex leaf = last; leaf != no_node; leaf = reached_[leaf].before)
      steps.push_back({reached_[leaf].at, leaf});
    steps.push_back({from_, no_node});
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  const AspectMap::Contents& map_;
  const Aspect& aspect_;
  std::size_t mode_;
  const Pose &from_, &to_;
  const LeafChoice& choice_;
  std::unordered_set<NodeIndex> last_, closed_;
  std::unordered_map<NodeIndex, Entry> reached_;
  std::priority_queue<Open> open_;
};

}  // namespace

double distance_between(const Manipulator& manipulator, const Pose& from, const Pose& to) {
  const double angle = from.orientation.angularDistance(to.orientation);
  return std::hypot((to.position - from.position).norm(), manipulator.characteristic_length() * angle);
}

std::vector<LeafStep> find_leaf_path(const AspectMap::Contents& map, int aspect, const Pose& from,
                                     const Pose& to, const LeafChoice& choice) {
  return LeafSearch(map, map.aspects[static_cast<std::size_t>(aspect - 1)], from, to, choice).run();
}

}  // namespace parallel_aspects
