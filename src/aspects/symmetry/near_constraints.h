// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_CONSTRAINTS_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_CONSTRAINTS_H

#include "aspects/symmetry/near_symmetry.h"
#include "parallel_aspects/model/manipulator.h"

namespace parallel_aspects {

/// Constraints that were nearly symmetric, and now are so to the last digit.
struct SymmetricConstraints {
  Constraints constraints;
  MovedNumber length, angle;  ///< what was moved farthest
};

/// The workspace, the obstacles, cones and the limits of passive joints that are nearest to those of `robot`
/// and symmetric under the motions of `legs`, which its own legs have: each kind is averaged over those of
/// them under which all its numbers have images no farther away than `tolerance`, in sizes of the robot [m]
/// and rad. The turns of boxes and self-collision stay as they are.
SymmetricConstraints nearest_symmetric_constraints(const ManipulatorDescription& robot,
                                                   const SymmetricLegs& legs, double size, double tolerance);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_CONSTRAINTS_H
