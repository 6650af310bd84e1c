// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_RIGID_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_RIGID_SYMMETRY_H

#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/model/task_space.h"

#include <Eigen/Core>

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_RIGID_SYMMETRY_H
