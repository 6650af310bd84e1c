// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_T1_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_T1_H

#include "parallel_aspects/kinematics/direct.h"

namespace parallel_aspects {

/// Direct solutions in T1: the operational point is where its line meets a sphere, so there are two, one or
/// none. Pose and `near_singular` are filled, the rest is left to `direct`, which callers should prefer.
DirectResult direct_t1(const Manipulator& manipulator, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_T1_H
