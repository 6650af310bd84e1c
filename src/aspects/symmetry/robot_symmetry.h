// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_ROBOT_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_ROBOT_SYMMETRY_H

#include "aspects/symmetry/rigid_symmetry.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
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

/// A reflection or rotation g that takes a manipulator onto itself, as far as aspects are concerned: where
/// leg j can be at a pose with a sign s of B_jj, leg `leg_image[j]` can be at the image of the pose with the
/// sign `entry_sign[j]` s, and det A there is that at the pose times a number of the sign `determinant_sign`.
/// So g takes S(s, sigma) onto S(g s, determinant_sign sigma), aspects onto aspects (docs/theory/maps.md has
/// the proof). This is exact: a theorem about the numbers of the manipulator.
struct RobotSymmetry {
  RigidSymmetry motion;
  std::vector<std::size_t> leg_image;
  std::vector<int> entry_sign;  ///< each 1 or -1
  int determinant_sign = 1;

  WorkingMode image(const WorkingMode& mode) const;
};

/// Those that are found among `find_rigid_symmetries` of the task space and region, the identity too where it
/// changes working modes, as with actuated elbows. Numbers must match without any tolerance: of the legs with
/// their limits, and of all constraints.
std::vector<RobotSymmetry> find_robot_symmetries(const Manipulator& manipulator, const Box& region);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_ROBOT_SYMMETRY_H
