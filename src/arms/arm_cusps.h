// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_ARM_CUSPS_H
#define PARALLEL_ASPECTS_ARMS_ARM_CUSPS_H

#include "parallel_aspects/arms/serial_arm.h"

#include "arms/arm_determinant.h"
#include <vector>

namespace parallel_aspects {

/// A cusp of the image of the singular curves in the half plane of distance from the first axis and height
/// along it: where three inverse solutions meet.
struct ArmCusp {
  double rho = 0.0;                   ///< distance from the first axis [m]
  double z = 0.0;                     ///< along it, from the origin of the base link [m]
  double theta2 = 0.0, theta3 = 0.0;  ///< joint values there [rad]
};

/// All that are proved to be cusps, and whether it is proved that there are no others.
struct ArmCusps {
  std::vector<ArmCusp> all;
  bool is_complete = false;
};

/// Of an arm of three turning joints whose task is a position. Limits are not looked at.
ArmCusps arm_cusps(const SerialArm& arm, const ArmDeterminant& determinant);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_ARM_CUSPS_H
