// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_SO3_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_SO3_H

#include "parallel_aspects/kinematics/direct.h"

namespace parallel_aspects {

/// Candidates for the direct solutions in SO3, where three axes of the platform are at given angles from
/// three fixed directions: at most eight, by way of `circle_family_solutions` in the turn of one leg about
/// its proximal point. Every real solution is near one of the candidates, but not every candidate is one.
/// Only poses are filled; `direct` does the rest and is what callers should use.
DirectResult direct_so3(const Manipulator& manipulator, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_SO3_H
