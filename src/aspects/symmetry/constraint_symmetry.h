// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_CONSTRAINT_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_CONSTRAINT_SYMMETRY_H

#include "aspects/symmetry/rigid_symmetry.h"
#include "parallel_aspects/model/constraints.h"
#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Whether the image of a point of the base is `image`, exactly.
bool takes_point(const RigidSymmetry& symmetry, const Eigen::Vector3d& point,
                 const Eigen::Vector3d& image) noexcept;

/// 1 where the image of a direction of the base is `image`, -1 where it is the opposite, else 0; exactly.
int takes_direction(const RigidSymmetry& symmetry, const Eigen::Vector3d& direction,
                    const Eigen::Vector3d& image) noexcept;

/// The axis of a cone at `leg`, where a symmetry takes the leg to `image`: exact where it is so of the axes
/// of their cranks.
Eigen::Vector3d image_of_axis(const RigidSymmetry& symmetry, const BallJointCone& cone, const Leg& leg,
                              const Leg& image);

/// Whether two ranges are the same, or where `sign` is -1 the same but for the sign of all their values.
bool are_images(const JointLimits& limits, const JointLimits& image, int sign) noexcept;

/// Whether a symmetry of the legs, leg j going to `leg_image[j]`, takes their constraints onto themselves,
/// exactly. The limits of actuated joints are with the legs.
bool takes_constraints(const RigidSymmetry& symmetry, const std::vector<std::size_t>& leg_image,
                       const Manipulator& manipulator);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_CONSTRAINT_SYMMETRY_H
