// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_FOLLOWER_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_FOLLOWER_H

#include "urdf/closing/chain.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace parallel_aspects {

/// The axis along or about which the platform side moves as the joint value grows.
Eigen::Vector3d directed_axis(const Pivot& pivot);

/// The displacement that turns about a point.
Eigen::Isometry3d about(const Eigen::Vector3d& center, const Eigen::Matrix3d& turned);

/// The displacement by a step of a joint, from the assembled configuration [rad or m].
Eigen::Isometry3d motion_of(const Pivot& pivot, double step);

/// A joint, and how far it moves away from the assembled configuration [rad or m].
struct FollowerStep {
  Pivot joint;
  double step = 0.0;
};

/// How the joints of a chain that lets the platform move in all six ways follow a displacement of the
/// platform: along the straight way there, so that they depend on the pose alone. `size`: of the robot [m].
std::vector<FollowerStep> steps_of_follower(const Chain& follower, const Eigen::Isometry3d& motion,
                                            double size);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_FOLLOWER_H
