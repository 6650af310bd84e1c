// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_SE2_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_SE2_H

#include "parallel_aspects/kinematics/direct.h"

namespace parallel_aspects {

/// Candidates for the direct solutions in SE2, where three points of the platform lie on three circles: at
/// most six, by way of `circle_family_solutions` in the angle phi of the platform. Every real solution is
/// near one of the candidates, but not every candidate is one. Only poses are filled; `direct` does the rest
/// and is what callers should use.
DirectResult direct_se2(const Manipulator& manipulator, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_SE2_H
