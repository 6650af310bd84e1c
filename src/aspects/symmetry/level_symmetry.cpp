// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/symmetry/level_symmetry.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects {

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
