// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_MAP_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_MAP_SYMMETRY_H

#include "aspects/boxes/box_classifier.h"
#include "aspects/symmetry/rigid_symmetry.h"
#include "aspects/tree/leaf_state.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A `RobotSymmetry` as a map with certain working modes sees it: S(s, sigma) of mode m goes onto
/// S(s, determinant_sign sigma) of mode `mode_image[m]`.
struct MapSymmetry {
  PoseSymmetry poses;
  std::vector<std::size_t> mode_image;  ///< by index of the mode in the map
  int determinant_sign = 1;
  std::string text;  ///< for people: what becomes of a point of the base, as "(x, -y)"

  /// What is proved of the image of a box in the image of a mode, and just so the other path.
  LeafState image(LeafState state) const noexcept {
    return determinant_sign > 0 ? state : state.with_signs_exchanged();
  }
};

/// The symmetries of a manipulator that take the region of a map and its working modes onto themselves: with
/// the identity, which is left out, they are a group. Empty in SE3, and where there is none.
std::vector<MapSymmetry> find_map_symmetries(const Manipulator& manipulator, const Box& region,
                                             const std::vector<WorkingMode>& modes);

/// Where the states of a working mode are taken from.
struct ModeSource {
  std::size_t representative = 0;         ///< the mode itself, or one that is computed in its place
  const MapSymmetry* symmetry = nullptr;  ///< that takes the representative to it; null for itself
};

/// Of each mode; representatives come before the modes that they stand for. The symmetries must outlive this.
std::vector<ModeSource> find_mode_sources(const std::vector<MapSymmetry>& symmetries, std::size_t modes);

/// The nodes of one level of a tree under the symmetries of its map. Of all pairs of a node and a working
/// mode that are images of each other, the first is the one that the others are derived from. The tree must
/// be such that nodes have children exactly where their images have.
class LevelSymmetry {
 public:
  /// The roots. The symmetries must outlive this.
  LevelSymmetry(const PoseTree& tree, const std::vector<MapSymmetry>& symmetries);

  /// The pending modes of a node that are not derived from another pair.
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

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_MAP_SYMMETRY_H
