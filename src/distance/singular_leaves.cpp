// SPDX-License-Identifier: BSD-3-Clause
#include "distance/singular_leaves.h"

#include "aspects/map/map_contents.h"
#include "distance/leaf_examiner.h"
#include "model/task_space_traits.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

// A part of the map: of some modes, that are divided or a leaf there; with no node, of modes whose leaf it is
// in.
struct Part {
  RootIndex root = 0;
  NodeIndex node = no_node;
  Box box;
  std::uint32_t level = 0;
  ModeSet modes = 0;
};

// Leaves of the map are divided until singularities in them lie this near to a plane, as a share of the
// radius of a leaf of its resolution, or so many times.
constexpr float thin = 0.1F;
constexpr std::uint32_t extra_levels = 1;

constexpr std::size_t enough_parts = 512;  // to share among threads

Box half_of(const Box& box, NodeIndex rank) {
  Box half = box;
  const MapPoint middle = box.middle();
  for (std::size_t i = 0; i < box.dimension; ++i)
    ((rank >> i & 1U) != 0 ? half.lower : half.upper)[i] = middle[i];
  return half;
}

/// Finds the leaves of a map, by mode and in the order of the tree.
template <TaskSpace space>
class LeafCollector {
 public:
  using Leaves = std::vector<std::vector<SingularLeaf>>;  // by mode

  LeafCollector(const AspectMap::Contents& map, const MapControl& control)
      : map_(map), control_(control), examiners_([&map] {
          const RoundingUpward rounding;
          return LeafExaminer<space>(*map.manipulator);
        }) {}

  /// By part, in order.
  std::vector<Leaves> collect() {
    const std::vector<Part> parts = divided_roots();
    std::vector<Leaves> found(parts.size(), Leaves(map_.tree.mode_count()));
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.size(), 1), [&](const auto& range) {
      const RoundingUpward rounding;
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        look_into(parts[i], examiners_.local(), found[i]);
    });
    return found;
  }

 private:
  std::vector<Part> divided_roots() const {
    std::vector<Part> parts;
    const std::size_t modes = map_.tree.mode_count();
    const ModeSet all = modes == 64 ? ~ModeSet{0} : (ModeSet{1} << modes) - 1;
    for (std::size_t root = 0; root < map_.tree.root_count(); ++root)
      parts.push_back(
          {static_cast<RootIndex>(root), static_cast<NodeIndex>(root), map_.tree.region(), 0, all});
    for (std::uint32_t level = 0; level < map_.depth && parts.size() < enough_parts; ++level) {
      std::vector<Part> smaller;
      for (const Part& part : parts) {
        const ModeSet divided = part.node == no_node ? 0 : divided_modes(part);
        if (divided != 0) append_children(part, divided, map_.tree.first_child(part.node), smaller);
        if (divided != part.modes)
          append_children(part, part.modes & ~divided & ~inside_modes(part), no_node, smaller);
      }
      parts = std::move(smaller);
    }
    return parts;
  }

  ModeSet divided_modes(const Part& part) const {
    ModeSet result = 0;
    for (std::size_t mode = 0; mode < map_.tree.mode_count(); ++mode)
      if (has(part.modes, mode) && map_.tree.state(part.node, mode).is_divided())
        result |= ModeSet{1} << mode;
    return result;
  }
  ModeSet inside_modes(const Part& part) const {
    ModeSet result = 0;
    for (std::size_t mode = 0; mode < map_.tree.mode_count(); ++mode)
      if (part.node != no_node && has(part.modes, mode) && map_.tree.state(part.node, mode).is_inside())
        result |= ModeSet{1} << mode;
    return result;
  }
  static bool has(ModeSet modes, std::size_t mode) { return (modes >> mode & 1U) != 0; }

  void append_children(const Part& part, ModeSet modes, NodeIndex first, std::vector<Part>& parts) const {
    if (modes == 0) return;
    for (NodeIndex rank = 0; rank < map_.tree.children_per_node(); ++rank)
      parts.push_back({part.root, first == no_node ? no_node : first + rank, half_of(part.box, rank),
                       part.level + 1, modes});
  }

  void look_into(const Part& part, LeafExaminer<space>& examiner, Leaves& found) const {
    if (part.modes == 0 || is_cancelled(control_)) return;
    const ModeSet divided = part.node == no_node ? 0 : divided_modes(part);
    const ModeSet open = still_open(part, part.modes & ~divided & ~inside_modes(part), examiner, found);
    for (NodeIndex rank = 0; rank < map_.tree.children_per_node(); ++rank) {
      const Box half = half_of(part.box, rank);
      if (divided != 0)
        look_into({part.root, map_.tree.first_child(part.node) + rank, half, part.level + 1, divided},
                  examiner, found);
      if (open != 0) look_into({part.root, no_node, half, part.level + 1, open}, examiner, found);
    }
  }

  // Those of the modes that need smaller boxes; leaves of the others are appended.
  ModeSet still_open(const Part& part, ModeSet modes, LeafExaminer<space>& examiner, Leaves& found) const {
    if (modes == 0) return 0;
    examiner.look_at(part.root, part.box);
    if (examiner.holds_no_pose()) return 0;
    ModeSet open = 0;
    for (std::size_t mode = 0; mode < map_.tree.mode_count(); ++mode) {
      if (!has(modes, mode)) continue;
      const std::optional<SingularLeaf> leaf = examiner.leaf(map_.modes[mode]);
      if (!leaf) continue;
      if (is_fine(*leaf, part.level))
        found[mode].push_back(*leaf);
      else
        open |= ModeSet{1} << mode;
    }
    return open;
  }

  bool is_fine(const SingularLeaf& leaf, std::uint32_t level) const {
    if (level < map_.depth) return false;
    if (level >= map_.depth + extra_levels) return true;
    const float thickness = leaf.has_plane() ? leaf.thickness : leaf.radius;
    return thickness <= std::ldexp(thin * leaf.radius, static_cast<int>(level - map_.depth));
  }

  const AspectMap::Contents& map_;
  const MapControl& control_;
  tbb::enumerable_thread_specific<LeafExaminer<space>> examiners_;
};

/// A ball about leaves or balls that follow each other.
template <TaskSpace space, class Item>
LeafBall ball_about(const Item* first, const Item* last, LeafView<space>& view, const AnchorMetric& metric,
                    double extent) {
  constexpr std::size_t moves = traits(space).translations, turns = traits(space).rotations;
  std::array<double, 4> sum{};
  for (const Item* item = first; item != last; ++item) {
    double along = 0.0;  // quaternions have two signs
    for (std::size_t i = moves; i < 4; ++i)
      along += static_cast<double>(item->center[i]) * static_cast<double>(first->center[i]);
    for (std::size_t i = 0; i < 4; ++i)
      sum[i] += (i >= moves && along < 0.0 ? -1.0 : 1.0) * static_cast<double>(item->center[i]);
  }
  double squares = 0.0;
  for (std::size_t i = moves; i < 4; ++i) squares += sum[i] * sum[i];
  LeafBall ball;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i < moves) ball.center[i] = static_cast<float>(sum[i] / static_cast<double>(last - first));
    if (i >= moves && turns > 0) ball.center[i] = static_cast<float>(sum[i] / std::sqrt(squares));
  }
  view.look_from(pose_of<space>(ball.center, metric), extent);
  double radius = 0.0;
  for (const Item* item = first; item != last; ++item)
    radius = std::max(radius, view.distance(item->center) + view.slack() + static_cast<double>(item->radius));
  ball.radius = static_cast<float>(radius * (1.0 + 0x1p-40));
  return ball;
}

template <TaskSpace space, class Item>
std::vector<LeafBall> balls_about(const std::vector<Item>& items, LeafView<space>& view,
                                  const AnchorMetric& metric, double extent) {
  std::vector<LeafBall> balls;
  balls.reserve(items.size() / LeafTree::children + 1);
  for (std::size_t i = 0; i < items.size(); i += LeafTree::children)
    balls.push_back(ball_about<space>(items.data() + i,
                                      items.data() + std::min(items.size(), i + LeafTree::children), view,
                                      metric, extent));
  return balls;
}

template <TaskSpace space>
void grow(LeafTree& tree, const AnchorMetric& metric, double extent) {
  if (tree.leaves.empty()) return;
  const RoundingUpward rounding;
  LeafView<space> view(metric);
  tree.levels.push_back(balls_about(tree.leaves, view, metric, extent));
  while (tree.levels.back().size() > 1) {
    std::vector<LeafBall> above = balls_about(tree.levels.back(), view, metric, extent);
    tree.levels.push_back(std::move(above));
  }
}

double extent_of(const std::vector<LeafTree>& trees) {
  float extent = 0.0F;
  for (const LeafTree& tree : trees)
    for (const SingularLeaf& leaf : tree.leaves)
      for (const float each : leaf.center) extent = std::max(extent, std::abs(each));
  return static_cast<double>(extent);
}

template <TaskSpace space>
std::vector<LeafTree> leaf_trees(const AspectMap::Contents& map, const MapControl& control, double& extent) {
  auto parts = LeafCollector<space>(map, control).collect();
  std::vector<LeafTree> trees(map.tree.mode_count());
  for (auto& part : parts)
    for (std::size_t mode = 0; mode < trees.size(); ++mode) {
      trees[mode].leaves.insert(trees[mode].leaves.end(), part[mode].begin(), part[mode].end());
      part[mode] = {};
    }
  extent = extent_of(trees);
  const AnchorMetric metric(*map.manipulator);
  tbb::parallel_for(std::size_t{0}, trees.size(),
                    [&](std::size_t mode) { grow<space>(trees[mode], metric, extent); });
  return trees;
}

// Where a leg whose reach its links alone bound can hold the operational point.
SingularLeaves::Ends ends_of(const AspectMap::Contents& map) {
  const RoundingUpward rounding;
  SingularLeaves::Ends ends;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ends.lower.fill(-infinity);
  ends.upper.fill(infinity);
  const TaskSpaceTraits space = traits(map.manipulator->task_space());
  for (std::size_t i = 0; i < space.translations; ++i) {
    ends.lower[i] = map.tree.region().lower[i];
    ends.upper[i] = map.tree.region().upper[i];
    for (const Leg& leg : map.manipulator->legs()) {
      if (!leg.kind().bounded_by_links) continue;
      const auto k = static_cast<Eigen::Index>(i);
      const double about =
          square_root(square(Interval(leg.anchor.x())) + square(Interval(leg.anchor.y()))).upper();
      const Interval arm = space.rotations > 0 ? Interval(-about, about) : Interval(leg.anchor[k]);
      const Interval reach =
          Interval(leg.base_point()[k]) - arm + Interval(-leg.longest_reach(), leg.longest_reach());
      if (reach.lower() >= map.tree.region().lower[i]) ends.lower[i] = -infinity;
      if (reach.upper() <= map.tree.region().upper[i]) ends.upper[i] = infinity;
    }
  }
  return ends;
}

}  // namespace

SingularLeaves::SingularLeaves(const AspectMap::Contents& map, const MapControl& control)
    : ends_(ends_of(map)) {
  with_task_space(map.manipulator->task_space(), [&](auto constant) {
    constexpr TaskSpace space = decltype(constant)::value;
    if constexpr (space != TaskSpace::SE3 && !is_of_hinges(space))
      trees_ = leaf_trees<space>(map, control, extent_);
  });
  complete_ = !is_cancelled(control);
}

std::size_t SingularLeaves::bytes() const noexcept {
  std::size_t sum = 0;
  for (const LeafTree& tree : trees_) {
    sum += tree.leaves.size() * sizeof(SingularLeaf);
    for (const auto& level : tree.levels) sum += level.size() * sizeof(LeafBall);
  }
  return sum;
}

}  // namespace parallel_aspects
