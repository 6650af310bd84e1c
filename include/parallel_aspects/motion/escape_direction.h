// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_ESCAPE_DIRECTION_H
#define PARALLEL_ASPECTS_MOTION_ESCAPE_DIRECTION_H

#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <optional>

namespace parallel_aspects {

/// The motion that leads away fastest, for each metre of distance.
struct EscapeDirection {
  TaskVector twist;        ///< (w, v) of the operational point, task frame [rad/m and m/m]
  JointVector joint_rate;  ///< of the actuated joints, by A t = B q̇ [rad/m or m/m]; empty where B_jj = 0
};

/// What the actuated joints do for a twist, q̇ = B^-1 A t [rad/s or m/s for a twist in rad/s and m/s]; not
/// finite where some B_jj = 0. Neither allocates nor throws.
JointVector joint_velocities(const Manipulator& manipulator, const Pose& pose, const JointVector& q,
                             const TaskVector& twist) noexcept;

/// Straight away from the witness of a distance: among all motions of the same speed, in the metric of
/// `BoundaryDistance`, none is faster away from that pose. Nothing where there is no witness, or it is where
/// the robot is. Floating point, not proved. Neither allocates nor throws.
std::optional<EscapeDirection> escape_direction(const Manipulator& manipulator, const Pose& pose,
                                                const JointVector& q,
                                                const BoundaryDistance& distance) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_ESCAPE_DIRECTION_H
