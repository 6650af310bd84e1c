// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/motion/motion_guard.h"

#include <cmath>

namespace parallel_aspects {

JointVector joint_velocities(const Manipulator& manipulator, const Pose& pose, const JointVector& q,
                             const TaskVector& twist) noexcept {
  const JointVector rates = direct_matrix(manipulator, pose, q) * twist;
  return rates.cwiseQuotient(inverse_diagonal(manipulator, pose, q));
}

std::optional<EscapeDirection> escape_direction(const Manipulator& manipulator, const Pose& pose,
                                                const JointVector& q,
                                                const BoundaryDistance& distance) noexcept {
  const TaskVector& towards = distance.direction;
  if (!std::isfinite(distance.upper) || towards.size() == 0 || !towards.allFinite() ||
      towards.squaredNorm() == 0.0)
    return std::nullopt;
  EscapeDirection escape{-towards, joint_velocities(manipulator, pose, q, -towards)};
  if (!escape.joint_rate.allFinite()) escape.joint_rate.resize(0);
  return escape;
}

}  // namespace parallel_aspects
