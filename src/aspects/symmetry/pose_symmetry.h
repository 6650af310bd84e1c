// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_POSE_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_POSE_SYMMETRY_H

#include "aspects/symmetry/rigid_symmetry.h"
#include "aspects/tree/pose_space.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/model/task_space.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// A `RigidSymmetry` in the coordinates of a `PoseSpace`: it takes each root box onto one, permutes
/// coordinates and reverses some of them. So it takes boxes of a `PoseTree` onto boxes of it, exactly.
class PoseSymmetry {
 public:
  /// `symmetry` must be one of `find_rigid_symmetries` of that space and region.
  PoseSymmetry(TaskSpace space, const Box& region, const RigidSymmetry& symmetry);

  RootIndex image(RootIndex root) const noexcept { return roots_[root].root; }
  MapPosition image(const MapPosition& position) const noexcept;

  /// Of a box in `root`; it lies in `image(root)`.
  Box image(RootIndex root, const Box& box) const noexcept;

  /// Rank of the image of a child of a node of `root` among the children of that node's image.
  NodeIndex image_rank(RootIndex root, NodeIndex rank) const noexcept { return roots_[root].ranks[rank]; }

  bool is_identity() const;

  /// First `first`, then this.
  PoseSymmetry after(const PoseSymmetry& first) const;

  friend bool operator==(const PoseSymmetry& a, const PoseSymmetry& b) noexcept;

 private:
  /// What becomes of one root box: coordinate i of the image is coordinate `from[i]`, run through backwards
  /// where `reversed[i]`.
  struct OfRoot {
    RootIndex root = 0;
    std::array<std::uint8_t, max_map_dimension> from{0, 1, 2};
    std::array<bool, max_map_dimension> reversed{};
    std::array<std::uint8_t, 1U << max_map_dimension> ranks{};
  };

  static OfRoot of_cube(RootIndex root, const RigidSymmetry& symmetry);
  void add(const OfRoot& of_root);

  std::size_t dimension_;
  Box region_;
  std::vector<OfRoot> roots_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_POSE_SYMMETRY_H
