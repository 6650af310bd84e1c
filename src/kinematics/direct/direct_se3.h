// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_SE3_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_SE3_H

#include "parallel_aspects/kinematics/kinematics.h"

namespace parallel_aspects {

/// Candidates for the direct solutions in SE3: at most 40, by following the 40 complex solutions of a generic
/// platform to those of this one (see platform_paths.h). Every real solution is near one of the candidates,
/// but not every candidate is one. Unsolved where paths were lost and further attempts did not make up for
/// them. Only poses are filled; `direct` does the rest and is what callers should use.
DirectResult direct_se3(const Manipulator& manipulator, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_SE3_H
