// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_ROTATION_SUBPROBLEMS_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_ROTATION_SUBPROBLEMS_H

#include <Eigen/Core>

#include <array>
#include <optional>

namespace parallel_aspects {

/// exp(axis angle) as a matrix; `axis` a unit vector, `angle` in rad.
Eigen::Matrix3d rotation(const Eigen::Vector3d& axis, double angle);

/// Angle in (-pi, pi] that turns `from` towards `to` about the unit vector `axis`, seen along it [rad].
/// Subproblem 1 of Paden and Kahan (Murray, Li, Sastry, A Mathematical Introduction to Robotic Manipulation,
/// 1994, 3.2).
double angle_about(const Eigen::Vector3d& axis, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Angles with exp(first a) exp(second b) from = to, for unit vectors `first`, `second` that are not parallel
/// and vectors of equal length. Subproblem 2 of Paden and Kahan; of its two solutions, the one where the
/// vector between the two turns lies on the side `branch` (1 or -1) of the plane of the axes. Where it does
/// not reach, the closest. Nothing for parallel axes.
std::optional<std::array<double, 2>> angles_about(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                                                  const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                  int branch);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_ROTATION_SUBPROBLEMS_H
