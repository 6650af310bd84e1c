// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_T3_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_T3_H

#include "parallel_aspects/kinematics/direct.h"

namespace parallel_aspects {

/// Direct solutions in T3: the operational point is where three spheres meet, so there are two, one or none.
/// Only poses are filled; the rest is left to `direct`, which callers should prefer.
DirectResult direct_t3(const Manipulator& manipulator, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_T3_H
