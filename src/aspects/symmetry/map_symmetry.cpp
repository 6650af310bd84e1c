// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/map_symmetry.h"

#include "aspects/symmetry/robot_symmetry.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {
namespace {

bool does_the_same(const MapSymmetry& one, const MapSymmetry& other) {
  return one.mode_image == other.mode_image && one.determinant_sign == other.determinant_sign &&
         one.poses == other.poses;
}

bool changes_nothing(const MapSymmetry& symmetry) {
  for (std::size_t mode = 0; mode < symmetry.mode_image.size(); ++mode)
    if (symmetry.mode_image[mode] != mode) return false;
  return symmetry.poses.is_identity();
}

/// First `first`, then `second`.
MapSymmetry composed(const MapSymmetry& first, const MapSymmetry& second) {
  MapSymmetry result{second.poses.after(first.poses), first.mode_image,
                     first.determinant_sign * second.determinant_sign, ""};
  for (std::size_t& mode : result.mode_image) mode = second.mode_image[mode];
  return result;
}

bool is_group(const std::vector<MapSymmetry>& symmetries) {
  for (const MapSymmetry& first : symmetries)
    for (const MapSymmetry& second : symmetries) {
      const MapSymmetry both = composed(first, second);
      if (!changes_nothing(both) &&
          std::none_of(symmetries.begin(), symmetries.end(),
                       [&both](const MapSymmetry& each) { return does_the_same(each, both); }))
        return false;
    }
  return true;
}

/// Where legs are so alike that it is open which one goes where, those that were found may be no group.
std::vector<MapSymmetry> group_of(const std::vector<MapSymmetry>& symmetries) {
  if (is_group(symmetries)) return symmetries;
  for (const MapSymmetry& each : symmetries)
    if (changes_nothing(composed(each, each))) return {each};
  return {};
}

/// Empty unless the mode of every image is among the modes.
std::vector<std::size_t> mode_images(const RobotSymmetry& symmetry, const std::vector<WorkingMode>& modes) {
  std::vector<std::size_t> result;
  for (const WorkingMode& mode : modes) {
    const auto image = std::find(modes.begin(), modes.end(), symmetry.image(mode));
    if (image == modes.end()) return {};
    result.push_back(static_cast<std::size_t>(image - modes.begin()));
  }
  return result;
}

}  // namespace

std::vector<MapSymmetry> find_map_symmetries(const Manipulator& manipulator, const Box& region,
                                             const std::vector<WorkingMode>& modes) {
  std::vector<MapSymmetry> found;
  const TaskSpace space = manipulator.task_space();
  for (const RobotSymmetry& each : find_robot_symmetries(manipulator, region)) {
    std::vector<std::size_t> images = mode_images(each, modes);
    if (images.empty()) continue;
    MapSymmetry symmetry{PoseSymmetry(space, region, each.motion), std::move(images), each.determinant_sign,
                         to_string(each.motion, space)};
    const bool is_known = std::any_of(found.begin(), found.end(), [&symmetry](const MapSymmetry& other) {
      return does_the_same(symmetry, other);
    });
    if (!is_known && !changes_nothing(symmetry)) found.push_back(std::move(symmetry));
  }
  return group_of(found);
}

std::vector<ModeSource> find_mode_sources(const std::vector<MapSymmetry>& symmetries, std::size_t modes) {
  std::vector<ModeSource> sources(modes);
  for (std::size_t mode = 0; mode < modes; ++mode) {
    sources[mode].representative = mode;
    for (const MapSymmetry& symmetry : symmetries)
      for (std::size_t earlier = 0; earlier < mode && sources[mode].symmetry == nullptr; ++earlier)
        if (sources[earlier].symmetry == nullptr && symmetry.mode_image[earlier] == mode)
          sources[mode] = {earlier, &symmetry};
  }
  return sources;
}

LevelSymmetry::LevelSymmetry(const PoseTree& tree, const std::vector<MapSymmetry>& symmetries)
    : symmetries_(symmetries), end_(static_cast<NodeIndex>(tree.root_count())), images_(symmetries.size()) {
  for (std::size_t g = 0; g < symmetries_.size(); ++g)
    for (NodeIndex root = 0; root < end_; ++root) images_[g].push_back(symmetries_[g].poses.image(root));
}

NodeIndex LevelSymmetry::first_image(NodeIndex node) const noexcept {
  NodeIndex first = node;
  for (std::size_t g = 0; g < symmetries_.size(); ++g) first = std::min(first, image(g, node));
  return first;
}

ModeSet LevelSymmetry::own_modes(const PoseTree& tree, NodeIndex node) const {
  ModeSet modes = 0;
  if (first_image(node) != node) return modes;
  for (std::size_t mode = 0; mode < tree.mode_count(); ++mode) {
    bool is_first = tree.state(node, mode).is_pending();
    for (std::size_t g = 0; g < symmetries_.size(); ++g)
      is_first = is_first && (image(g, node) != node || symmetries_[g].mode_image[mode] >= mode);
    if (is_first) modes |= ModeSet{1} << mode;
  }
  return modes;
}

void LevelSymmetry::tell(PoseTree& tree) const {
  if (symmetries_.empty()) return;
  for (NodeIndex node = begin_; node < end_; ++node) tell(tree, node);
}

// What the pair is taken to is proved; so it is for the pair itself, which the inverse comes back to.
void LevelSymmetry::tell(PoseTree& tree, NodeIndex node) const {
  const NodeIndex first = first_image(node);
  for (std::size_t g = 0; g < symmetries_.size(); ++g) {
    if (image(g, node) != first) continue;
    const MapSymmetry& symmetry = symmetries_[g];
    for (std::size_t mode = 0; mode < tree.mode_count(); ++mode) {
      const LeafState known = tree.state(first, symmetry.mode_image[mode]);
      if (tree.state(node, mode).is_pending() && known.is_leaf())
        tree.state(node, mode) = symmetry.image(known);
    }
  }
}

void LevelSymmetry::descend(const PoseTree& tree) {
  const auto end = static_cast<NodeIndex>(tree.node_count());
  for (std::size_t g = 0; g < symmetries_.size(); ++g) {
    std::vector<NodeIndex> next(end - end_);
    for (NodeIndex node = begin_; node < end_; ++node) {
      const NodeIndex first = tree.first_child(node), first_image = tree.first_child(image(g, node));
      if (first == no_node) continue;
      for (NodeIndex rank = 0; rank < tree.children_per_node(); ++rank)
        next[first + rank - end_] =
            first_image + symmetries_[g].poses.image_rank(tree.place(node).root, rank);
    }
    images_[g] = std::move(next);
  }
  begin_ = std::exchange(end_, end);
}

}  // namespace parallel_aspects
