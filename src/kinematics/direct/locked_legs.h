// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_LOCKED_LEGS_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_LOCKED_LEGS_H

#include "parallel_aspects/model/leg.h"

#include <Eigen/Core>

namespace parallel_aspects {

/// A leg with its actuated joint locked: all that the direct problem sees of it, whatever its kind.
///
///     |position + R anchor - base|^2 = squared_length
struct LockedLeg {
  Eigen::Vector3d anchor;  ///< in the platform frame [m]
  Eigen::Vector3d base;    ///< c(q), in the task frame [m]
  double squared_length;   ///< rho(q)^2 [m^2]
};

/// The leg at the joint value `q` [rad or m], which must be finite.
inline LockedLeg locked(const Leg& leg, double q) noexcept {
  return {leg.anchor, leg.proximal_point(q), leg.squared_distance(q)};
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_LOCKED_LEGS_H
