// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_SYMMETRY_H

#include "aspects/symmetry/rigid_symmetry.h"
#include "parallel_aspects/model/leg.h"
#include "parallel_aspects/model/task_space.h"

#include <string>
#include <vector>

namespace parallel_aspects {

/// How far a number of a leg was moved.
struct MovedNumber {
  std::string what;     ///< "anchor of leg_1"
  double amount = 0.0;  ///< [m or rad]
};

/// Legs that were nearly symmetric, and now are so to the last digit.
struct SymmetricLegs {
  std::vector<Leg> legs;
  std::vector<RigidSymmetry> motions;  ///< that take them onto themselves, without the identity
  MovedNumber length, angle;           ///< what was moved farthest
};

/// The symmetric legs that are nearest to `legs`: their average over the group of all motions, of those that
/// `find_robot_symmetries` looks for, that take each number of the legs to one that is no farther away than
/// `tolerance`, in sizes of the robot [m] and rad. With no motions, and the legs as they are, where there is
/// none but the identity, or where those that there are make no group.
SymmetricLegs nearest_symmetric_legs(TaskSpace space, const std::vector<Leg>& legs, double size,
                                     double tolerance);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_SYMMETRY_H
