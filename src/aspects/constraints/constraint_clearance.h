// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CONSTRAINT_CLEARANCE_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CONSTRAINT_CLEARANCE_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

namespace parallel_aspects {

/// How far a configuration is from breaking a constraint of this kind, negative where it does: m for
/// distances, rad for joints, no unit for margins; infinite without such constraints, and for limits of
/// actuated joints, which the actuated joint values determine. For drawing, in double precision; proves
/// nothing. In a box it is less than the depth.
double constraint_clearance(const Manipulator& manipulator, ConstraintKind kind, const Pose& pose,
                            const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_CONSTRAINT_CLEARANCE_H
