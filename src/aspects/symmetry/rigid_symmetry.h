// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_RIGID_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_RIGID_SYMMETRY_H

#include "aspects/tree/pose_space.h"
#include "aspects/tree/pose_tree.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A reflection or rotation that takes coordinate axes to coordinate axes: the pose (p, R) of a platform goes
/// to (base p + shift, base R platform^T). Entries of both matrices are 0, 1 or -1, so that images of doubles
/// are doubles. Their determinants are equal.
struct RigidSymmetry {
  Eigen::Matrix3d base = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d platform = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< [m]

  /// 1 of a rotation, -1 of a reflection.
  double handedness() const { return base.determinant(); }
};

/// Those that map the task space onto itself, about the origin; the identity is among them. None in SE3.
std::vector<RigidSymmetry> rigid_symmetries_without_shift(TaskSpace space);

/// Those that map the task space, and a region of its positions, onto itself exactly; the identity is among
/// them. `region` is not used in SO3; in SE2 its third coordinate is not. None in SE3.
std::vector<RigidSymmetry> find_rigid_symmetries(TaskSpace space, const Box& region);

/// Whether `one` + `other` is `sum` with no rounding.
bool is_exact_sum(double one, double other, double sum) noexcept;

/// What becomes of a point of the base, as people write it: "(x, -y)".
std::string to_string(const RigidSymmetry& symmetry, TaskSpace space);

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

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_RIGID_SYMMETRY_H
