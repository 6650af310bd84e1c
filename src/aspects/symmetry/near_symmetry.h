// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_SYMMETRY_H
#define PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_SYMMETRY_H

#include "aspects/symmetry/rigid_symmetry.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// How far a number of a leg was moved.
struct MovedNumber {
  std::string what;     ///< "anchor of leg_1"
  double amount = 0.0;  ///< [m or rad]
};

/// A motion, and where it takes the legs.
struct SymmetricMotion {
  RigidSymmetry motion;
  std::vector<std::size_t> leg_image;
};

/// Legs that were nearly symmetric, and now are so to the last digit.
struct SymmetricLegs {
  std::vector<Leg> legs;
  std::vector<SymmetricMotion> motions;              ///< that take them onto themselves, without the identity
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< which all of them leave where it is [m]
  MovedNumber length, angle;                         ///< what was moved farthest
};

// Numbers become whole multiples of powers of two, so that sums of their images are exact.

/// For lengths of a robot of this size [m].
double step_of_lengths(double size);

/// For entries of directions, and angles [rad].
inline constexpr double step_of_angles = 0x1p-44;

double snapped(double value, double step);
Eigen::Vector3d snapped(const Eigen::Vector3d& vector, double step);

/// The symmetric legs that are nearest to `legs`: their average over the group of all motions, of those that
/// `find_robot_symmetries` searches for, that take each number of the legs to one that is no farther away
/// than `tolerance`, in sizes of the robot [m] and rad. With no motions, and the legs as they are, where
/// there is none but the identity, or where those that there are make no group.
SymmetricLegs nearest_symmetric_legs(TaskSpace space, const std::vector<Leg>& legs, double size,
                                     double tolerance);

/// `legs` with base points that decimal numbers make symmetric about a point other than the origin, so that
/// they are so in doubles: moved by some units in the last place. With no motions, and the legs as they are,
/// where that is not so.
SymmetricLegs symmetric_in_decimals(TaskSpace space, const std::vector<Leg>& legs, double size);

/// What sums of decimal numbers are rounded by at the most, in sizes of the robot [m] and rad.
inline constexpr double rounding_of_decimals = 1e-13;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SYMMETRY_NEAR_SYMMETRY_H
