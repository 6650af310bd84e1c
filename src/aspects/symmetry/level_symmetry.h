// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_LEVEL_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_LEVEL_SYMMETRY_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/symmetry/map_symmetry.h"
#include "aspects/tree/pose_tree.h"

#include <vector>

namespace parallel_aspects {

/// The nodes of one level of a tree under the symmetries of its map. Of all pairs of a node and a working
/// mode that are images of each other, the first is the one that the others are told by. The tree must be
/// such that nodes have children exactly where their images have.
class LevelSymmetry {
 public:
  /// The roots. The symmetries must outlive this.
  LevelSymmetry(const PoseTree& tree, const std::vector<MapSymmetry>& symmetries);

  /// The pending modes of a node that are not told by another pair.
  ModeSet own_modes(const PoseTree& tree, NodeIndex node) const;

  /// Once all nodes of the level have the states of their own modes: the others of them.
  void tell(PoseTree& tree) const;

  /// Goes on to the children, which must be all nodes behind this level.
  void descend(const PoseTree& tree);

 private:
  NodeIndex first_image(NodeIndex node) const noexcept;
  NodeIndex image(std::size_t symmetry, NodeIndex node) const noexcept {
    return images_[symmetry][node - begin_];
  }
  void tell(PoseTree& tree, NodeIndex node) const;

  const std::vector<MapSymmetry>& symmetries_;
  NodeIndex begin_ = 0, end_ = 0;               // of the level
  std::vector<std::vector<NodeIndex>> images_;  // by symmetry, of each node
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_LEVEL_SYMMETRY_H
