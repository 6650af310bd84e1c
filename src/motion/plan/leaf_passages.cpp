// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/components/climb.h"
#include "aspects/map/map_contents.h"
#include "aspects/tree/neighbour_leaves.h"
#include "interval/interval.h"
#include "motion/plan/leaf_path.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

/// Points of two boxes that are as near to each other as any, in the middle of what they have in common.
std::pair<MapPoint, MapPoint> nearest_points(const Box& one, const Box& other) {
  std::pair<MapPoint, MapPoint> points{one.middle(), other.middle()};
  for (std::size_t i = 0; i < one.dimension; ++i) {
    const double lower = std::max(one.lower[i], other.lower[i]),
                 upper = std::min(one.upper[i], other.upper[i]);
    const double middle = 0.5 * (lower + upper);
    points.first[i] = std::clamp(middle, one.lower[i], one.upper[i]);
    points.second[i] = std::clamp(middle, other.lower[i], other.upper[i]);
  }
  return points;
}

double squared_distance(const MapPoint& a, const MapPoint& b, std::size_t dimension) {
  double sum = 0.0;
  for (std::size_t i = 0; i < dimension; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// Between the faces that `undecided` shares with both, where these are nearest to each other.
std::optional<LeafPassage> passage_between(const AspectMap::Contents& map, NodeIndex from,
                                           NodeIndex undecided, NodeIndex to) {
  const PoseSpace& space = map.tree.space();
  std::optional<LeafPassage> best;
  double least = std::numeric_limits<double>::infinity();
  for (const SharedFace& out : shared_faces(map.tree, from, undecided))
    for (const SharedFace& in : shared_faces(map.tree, undecided, to)) {
      if (out.root != in.root) continue;
      const auto [a, b] = nearest_points(out.box, in.box);
      const double length = squared_distance(a, b, out.box.dimension);
      if (!(length < least)) continue;
      least = length;
      best = LeafPassage{to, {space.pose({out.root, a}), space.pose({in.root, b})}, undecided};
    }
  return best;
}

/// The climbs from one part to others.
class PartClimbs {
 public:
  PartClimbs(const AspectMap::Contents& map, const Aspect& aspect, FaceComponents& components,
             const MapControl& control)
      : map_(map),
        aspect_(aspect),
        components_(components),
        control_(control),
        mode_(*mode_index(map, aspect.mode)) {}

  LeafPassages run() {
    const NodeIndex largest = largest_part();
    std::unordered_map<NodeIndex, int> climbs;  // by part
    int all = 0;
    for (NodeIndex leaf = 0; leaf < map_.tree.node_count() && all < most_climbs; ++leaf) {
      if (!is_inside(leaf) || components_.part_of(leaf) == largest) continue;
      if (climbs[components_.part_of(leaf)]++ >= climbs_of_a_part) continue;
      if (is_cancelled(control_)) break;
      ++all;
      add_climb(leaf);
    }
    return std::move(found_);
  }

 private:
  static constexpr int climbs_of_a_part = 8, most_climbs = 4000;

  bool is_inside(NodeIndex leaf) const { return map_.leaf_aspect(leaf, mode_) == aspect_.id; }

  NodeIndex largest_part() {
    std::unordered_map<NodeIndex, std::size_t> leaves;
    NodeIndex largest = no_node;
    for (NodeIndex leaf = 0; leaf < map_.tree.node_count(); ++leaf) {
      if (!is_inside(leaf)) continue;
      const NodeIndex part = components_.part_of(leaf);
      ++leaves[part];
      if (largest == no_node || leaves[part] > leaves[largest]) largest = part;
    }
    return largest;
  }

  void add_climb(NodeIndex leaf) {
    const std::vector<MapPosition> positions = climb_from(leaf);
    if (positions.empty()) return;
    std::vector<Pose> poses;
    for (const MapPosition& each : positions) poses.push_back(map_.tree.space().pose(each));
    const NodeIndex reached = *map_.tree.leaf_at(positions.back(), mode_);
    found_[reached].push_back({leaf, {poses.rbegin(), poses.rend()}});
    found_[leaf].push_back({reached, std::move(poses)});
  }

  /// From its middle up to a leaf of another part; empty where it comes to none.
  std::vector<MapPosition> climb_from(NodeIndex leaf) {
    const RoundingUpward rounding;
    std::vector<MapPosition> positions{{map_.tree.place(leaf).root, map_.tree.box(leaf).middle()}};
    Climb way(*map_.classifier, map_.tree.space(), mode_, aspect_.determinant_sign, positions.front(),
              policy_);
    for (int i = 0; i < policy_.max_steps && way.step(); ++i) {
      positions.push_back(way.position());
      const auto here = map_.tree.leaf_at(way.position(), mode_);
      if (here && is_inside(*here) && !components_.are_connected(*here, leaf)) return positions;
    }
    return {};
  }

  const AspectMap::Contents& map_;
  const Aspect& aspect_;
  FaceComponents& components_;
  const MapControl& control_;
  std::size_t mode_;
  ClimbPolicy policy_;
  LeafPassages found_;
};

}  // namespace

LeafPassages climbs_between_parts(const AspectMap::Contents& map, const Aspect& aspect,
                                  FaceComponents& components, const MapControl& control) {
  return PartClimbs(map, aspect, components, control).run();
}

std::vector<LeafPassage> passages_beside(const AspectMap::Contents& map, const Aspect& aspect,
                                         NodeIndex leaf) {
  const std::size_t mode = *mode_index(map, aspect.mode);
  std::vector<LeafPassage> result;
  for (const NodeIndex between : neighbour_leaves(map.tree, mode, leaf)) {
    const LeafState state = map.tree.state(between, mode);
    if (!state.is_undecided() || !state.may_be(aspect.determinant_sign)) continue;
    for (const NodeIndex to : neighbour_leaves(map.tree, mode, between))
      if (to != leaf && map.leaf_aspect(to, mode) == aspect.id)
        if (const auto passage = passage_between(map, leaf, between, to)) result.push_back(*passage);
  }
  return result;
}

}  // namespace parallel_aspects
