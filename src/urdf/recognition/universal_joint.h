// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_RECOGNITION_UNIVERSAL_JOINT_H
#define PARALLEL_ASPECTS_URDF_RECOGNITION_UNIVERSAL_JOINT_H

#include "parallel_aspects/model/leg.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// One of the two revolute joints of a universal joint, at the assembled configuration.
struct UniversalAxis {
  std::string joint;     ///< its name
  Eigen::Vector3d axis;  ///< unit vector that the rod turns about as the joint value grows
  double value = 0.0;    ///< [rad]
  JointLimits limits;    ///< none where it turns freely [rad]
};

/// A unit vector of which the rod's direction is no farther away than `angle` [rad].
struct LimitedDirection {
  std::string joint;  ///< whose limit that is
  Eigen::Vector3d axis;
  double angle = 0.0;
};

/// The limits of a universal joint as cones about its centre: the directions of a rod for which both joints
/// are within their limits are those in all the cones, exactly. The first joint is fixed in what the rod is
/// seen from, the second in the cross. Nothing where that cannot be told from the direction of the rod: the
/// axes or the second axis and the rod are not perpendicular, the second joint can turn so far that the rod
/// is along the first axis, or the first by more than half a turn.
std::optional<std::vector<LimitedDirection>> limited_directions(const UniversalAxis& first,
                                                                const UniversalAxis& second,
                                                                const Eigen::Vector3d& rod);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_RECOGNITION_UNIVERSAL_JOINT_H
