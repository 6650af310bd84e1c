// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_HINGES_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_HINGES_H

#include "parallel_aspects/kinematics/kinematics.h"

namespace parallel_aspects {

/// Direct solutions in R1, where a circle about the hinge meets a sphere about the proximal point: two, one
/// or none. Pose and `near_singular` are filled, the rest is left to `direct`, which callers should prefer.
DirectResult direct_r1(const Manipulator& manipulator, const JointVector& q);

/// Candidates for the direct solutions in R2: at most eight, by way of `circle_family_solutions` in theta2.
/// Every real solution is near one of the candidates, but not every candidate is one. Only poses are filled;
/// `direct` does the rest and is what callers should use.
DirectResult direct_r2(const Manipulator& manipulator, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_HINGES_H
