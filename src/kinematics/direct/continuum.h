// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_CONTINUUM_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_CONTINUUM_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

namespace parallel_aspects {

/// Whether the platform moves with the actuated joints locked: from a singular direct solution `pose` finite
/// steps along the null motion of A lead to further ones. Numerical, not a proof.
bool on_continuum(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// Whether a search from random poses finds a continuum of direct solutions. "No" proves nothing.
bool continuum_found(const Manipulator& manipulator, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_CONTINUUM_H
