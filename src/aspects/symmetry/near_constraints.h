// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_CONSTRAINTS_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_CONSTRAINTS_H

#include "aspects/symmetry/near_symmetry.h"
#include "parallel_aspects/model/constraints.h"

namespace parallel_aspects {

/// Constraints that were nearly symmetric, and now are so to the last digit.
struct SymmetricConstraints {
  Constraints constraints;
  MovedNumber length, angle;  ///< what was moved farthest
};

/// The workspace, the obstacles and the limits of passive joints that are nearest to those of `constraints`
/// and symmetric under the motions of `legs`: each kind is averaged over them where all its numbers have
/// images no farther away than `tolerance`, in sizes of the robot [m] and rad, and else stays as it is. So do
/// the turns of boxes, cones and self-collision.
SymmetricConstraints nearest_symmetric_constraints(const Constraints& constraints, TaskSpace space,
                                                   const SymmetricLegs& legs, double size, double tolerance);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_CONSTRAINTS_H
