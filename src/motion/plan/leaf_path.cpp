// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/leaf_path.h"

#include "aspects/map/map_contents.h"
#include "aspects/tree/near_leaves.h"
#include "aspects/tree/neighbour_leaves.h"
#include "motion/plan/path_shape.h"
#include "motion/shortest_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace parallel_aspects {
namespace {

// What a path counts in a leaf as small as the resolution, and more in an undecided one.
constexpr double cost_of_small_leaves = 3.0, cost_of_undecided_leaves = 6.0;

// Weight of the distance to the goal, above the least cost of a path: far fewer leaves are examined, and the
// path is shortened anyway.
constexpr double greed = 10.0;

/// A* from middle to middle. The goal is `no_node`, which the leaves near it lead to. Where an index is
/// wanted, leaves are taken by falling index, and that of a path is the least of its leaves: so it is the
/// path that the merge tree of the leaves has between the two, the widest there is.
class LeafSearch {
 public:
  LeafSearch(const AspectMap::Contents& map, FaceComponents& components, LeafIndices& indices,
             const Aspect& aspect, const Pose& from, const Pose& to, const LeafChoice& choice)
      : map_(map),
        components_(components),
        indices_(indices),
        aspect_(aspect),
        mode_(*mode_index(map, aspect.mode)),
        from_(from),
        to_(to),
        choice_(choice) {}

  std::vector<LeafStep> run() {
    last_.insert(choice_.last.begin(), choice_.last.end());
    for (const NodeIndex leaf : choice_.first)
      if (!is_barred(no_node, leaf) && may_lead_on(leaf))
        enter(leaf, no_graph_node, distance(from_, middle(leaf)), index_steps);
    while (!is_cancelled(choice_.control)) {
      const std::size_t at = paths_.take();
      if (at == no_graph_node) break;
      if (reached_[at].leaf == no_node) return path_to(at);
      expand(at);
    }
    return {};
  }

 private:
  /// A leaf that was reached, or the goal.
  struct Reached {
    NodeIndex leaf = no_node;
    double own_width = 0.0;  // in steps of the index; see `width_of`
    Pose middle;
    std::optional<LeafPassage> passage{};  // from the leaf before, where they share no face
  };

  double distance(const Pose& a, const Pose& b) const { return distance_between(*map_.manipulator, a, b); }
  bool is_barred(NodeIndex from, NodeIndex to) const {
    return !choice_.barred.empty() && choice_.barred.count({from, to}) > 0;
  }
  /// Saves a search of a whole connected set that does not hold the goal.
  bool may_lead_on(NodeIndex leaf) {
    return choice_.undecided || choice_.passages != nullptr ||
           std::any_of(last_.begin(), last_.end(),
                       [&](NodeIndex last) { return components_.are_connected(leaf, last); });
  }

  bool is_inside(NodeIndex leaf) const { return map_.leaf_aspect(leaf, mode_) == aspect_.id; }

  bool may_pass(NodeIndex leaf) const {
    if (is_inside(leaf)) return true;
    const LeafState state = map_.tree.state(leaf, mode_);
    return choice_.undecided && state.is_undecided() && state.center_sign() == aspect_.determinant_sign;
  }

  double price(NodeIndex leaf) const {
    if (!is_inside(leaf)) return cost_of_undecided_leaves;
    const double edge = map_.tree.space().longest_edge(map_.tree.box(leaf));
    return 1.0 + cost_of_small_leaves * std::min(1.0, map_.resolution / edge);
  }

  /// The same of all where none is wanted.
  double width_of(NodeIndex leaf, const Pose& middle) {
    if (!(choice_.wanted_index > 0.0)) return index_steps;
    const auto [item, is_new] = indices_.try_emplace(leaf);
    if (is_new) item->second = index_at(*map_.manipulator, middle, aspect_.mode);
    return std::floor(index_steps * std::min(1.0, item->second / choice_.wanted_index));
  }

  std::size_t number_of(NodeIndex leaf) {
    const auto [item, is_new] = numbers_.try_emplace(leaf, reached_.size());
    if (is_new) {
      const Pose at = leaf == no_node ? to_ : middle(leaf);
      reached_.push_back({leaf, leaf == no_node ? index_steps : width_of(leaf, at), at});
    }
    return item->second;
  }

  /// From the leaf with the number `before`.
  void enter(NodeIndex leaf, std::size_t before, double length, double width,
             const std::optional<LeafPassage>& passage = std::nullopt) {
    const std::size_t number = number_of(leaf);
    Reached& there = reached_[number];
    const WidthAndLength cost{std::min(width, there.own_width), length};
    if (paths_.enter(number, before, cost, {cost.width, length + greed * distance(there.middle, to_)}))
      there.passage = passage;
  }

  void expand(std::size_t at) {
    const NodeIndex leaf = reached_[at].leaf;
    const Pose here = reached_[at].middle;
    const auto [width, length] = paths_.cost(at);
    if (last_.count(leaf) > 0 && !is_barred(leaf, no_node))
      enter(no_node, at, length + distance(here, to_), width);
    for (const NodeIndex next : neighbour_leaves(map_.tree, mode_, leaf)) {
      if (!may_pass(next) || is_barred(leaf, next)) continue;
      const auto known = numbers_.find(next);
      if (known != numbers_.end() && paths_.is_taken(known->second)) continue;
      const Pose there = known != numbers_.end() ? reached_[known->second].middle : middle(next);
      enter(next, at, length + price(next) * distance(here, there), width);
    }
    if (choice_.passages != nullptr) expand_by_passages(at);
  }

  void expand_by_passages(std::size_t at) {
    const NodeIndex leaf = reached_[at].leaf;
    const auto climbs = choice_.passages->find(leaf);
    if (climbs != choice_.passages->end())
      for (const LeafPassage& passage : climbs->second) enter_by(passage, at);
    for (const LeafPassage& passage : passages_beside(map_, aspect_, leaf))
      if (numbers_.count(passage.to) == 0 && is_proved(passage, leaf)) enter_by(passage, at);
  }

  bool is_proved(const LeafPassage& passage, NodeIndex leaf) const {
    const auto [item, is_new] = choice_.proofs->try_emplace({leaf, passage.beside, passage.to}, false);
    if (is_new && !is_cancelled(choice_.control))
      item->second = choice_.is_free(passage.poses.front(), passage.poses.back());
    return item->second;
  }

  void enter_by(const LeafPassage& passage, std::size_t at) {
    if (numbers_.count(passage.to) > 0 || is_barred(reached_[at].leaf, passage.to)) return;
    double length = distance(reached_[at].middle, passage.poses.front());
    for (std::size_t i = 0; i + 1 < passage.poses.size(); ++i)
      length += distance(passage.poses[i], passage.poses[i + 1]);
    const auto [width, before] = paths_.cost(at);
    enter(passage.to, at, before + cost_of_undecided_leaves * length, width, passage);
  }

  Pose middle(NodeIndex leaf) const {
    return map_.tree.space().pose({map_.tree.place(leaf).root, map_.tree.box(leaf).middle()});
  }

  /// Of a face, halfway from its middle to what is nearest to a pose: paths are straighter so, and keep off
  /// the edges.
  MapPoint nearest(const Box& face, const Pose& pose) const {
    const MapPoint near = face.nearest(map_.tree.space().position(pose).point);
    MapPoint point = face.middle();
    for (std::size_t i = 0; i < face.dimension; ++i) point[i] = 0.5 * (point[i] + near[i]);
    return point;
  }

  /// Through a pose of each face, or the middle of an undecided leaf.
  Pose entrance(const Pose& from, NodeIndex leaf, NodeIndex next) const {
    if (!is_inside(next)) return middle(next);
    Pose nearest_pose = middle(next);
    double least = std::numeric_limits<double>::infinity();
    for (const SharedFace& face : shared_faces(map_.tree, leaf, next)) {
      const Pose pose = map_.tree.space().pose({face.root, nearest(face.box, from)});
      const double length = distance(from, pose);
      if (length < least) least = length, nearest_pose = pose;
    }
    return nearest_pose;
  }

  std::vector<LeafStep> path_to(std::size_t goal) const {
    std::vector<std::size_t> path = paths_.path_to(goal);
    path.pop_back();
    const NodeIndex first = reached_[path.front()].leaf, last = reached_[path.back()].leaf;
    std::vector<LeafStep> steps{{from_, no_node}, {nearest_in(map_, first, from_), first}};
    for (std::size_t i = 1; i < path.size(); ++i) {
      const NodeIndex before = reached_[path[i - 1]].leaf, leaf = reached_[path[i]].leaf;
      if (const auto& passage = reached_[path[i]].passage) {
        steps.push_back({passage->poses.front(), before});
        for (std::size_t k = 1; k < passage->poses.size(); ++k) steps.push_back({passage->poses[k], leaf});
        continue;
      }
      steps.push_back({entrance(steps.back().pose, before, leaf), leaf});
      if (choice_.wanted_index > 0.0) steps.push_back({middle(leaf), leaf});
    }
    steps.push_back({nearest_in(map_, last, to_), last});
    steps.push_back({to_, no_node});
    return steps;
  }

  const AspectMap::Contents& map_;
  FaceComponents& components_;
  LeafIndices& indices_;
  const Aspect& aspect_;
  std::size_t mode_;
  const Pose &from_, &to_;
  const LeafChoice& choice_;
  std::unordered_set<NodeIndex> last_;
  std::unordered_map<NodeIndex, std::size_t> numbers_;  // of what was reached
  std::vector<Reached> reached_;
  ShortestPaths<WidthAndLength> paths_;
};

}  // namespace

double distance_between(const Manipulator& manipulator, const Pose& from, const Pose& to) {
  const double angle = from.orientation.angularDistance(to.orientation);
  return std::hypot((to.position - from.position).norm(), manipulator.characteristic_length() * angle);
}

FaceComponents::FaceComponents(const AspectMap::Contents& map, std::size_t mode)
    : sets_(map.tree.node_count()) {
  visit_faces(map.tree, mode, [&](NodeIndex a, NodeIndex b) {
    if (map.tree.state(a, mode).is_inside() && map.tree.state(b, mode).is_inside()) sets_.unite(a, b);
  });
}

std::vector<NodeIndex> leaves_near(const AspectMap::Contents& map, const Aspect& aspect, const Pose& pose) {
  const MapPosition position = map.tree.space().position(pose);
  const std::size_t mode = *mode_index(map, aspect.mode);
  const NearLeaves near = near_inside_leaves(map.tree, mode, aspect.determinant_sign, position);
  std::vector<NodeIndex> result;
  for (std::size_t i = 0; i < near.count; ++i) {
    if (map.leaf_aspect(near.items[i].leaf, mode) == aspect.id) result.push_back(near.items[i].leaf);
    if (near.items[i].squared_distance == 0.0 && !result.empty()) break;
  }
  return result;
}

Pose nearest_in(const AspectMap::Contents& map, NodeIndex leaf, const Pose& pose) {
  const MapPosition position = map.tree.space().position(pose);
  const Box box = map.tree.box(leaf);
  return box.contains(position.point) ? pose
                                      : map.tree.space().pose({position.root, box.nearest(position.point)});
}

std::vector<LeafStep> find_leaf_path(const AspectMap::Contents& map, FaceComponents& components,
                                     LeafIndices& indices, int aspect, const Pose& from, const Pose& to,
                                     const LeafChoice& choice) {
  return LeafSearch(map, components, indices, map.aspects[static_cast<std::size_t>(aspect - 1)], from, to,
                    choice)
      .run();
}

}  // namespace parallel_aspects
