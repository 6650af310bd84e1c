// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_PROBLEM_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_PROBLEM_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

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

/// What Newton's method makes of an approximate direct solution.
struct Refinement {
  Pose pose;
  double residual = 0.0;        ///< largest |f_j| over the squared `assembly_scale`, dimensionless
  double singular_value = 0.0;  ///< see `smallest_singular_value_bound`, at `pose`
};

/// Newton's method on f(X, q) = 0 from `pose`, for as long as the residual falls. Where it does not converge
/// the residual says so.
Refinement refined(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// The length that residuals are judged against [m]: the largest of the robot's size, its rods and anchors,
/// and how far the actuated joints have moved the proximal points.
double assembly_scale(const Manipulator& manipulator, const JointVector& q);

/// Largest |f_j| over the squared `scale` [m], dimensionless.
double relative_residual(const Manipulator& manipulator, const Pose& pose, const JointVector& q,
                         double scale);

/// A lower bound of the smallest singular value of the homogenised A, no less than 1/n of it. Dimensionless;
/// 0 at a parallel singularity.
double smallest_singular_value_bound(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// Whether the platform moves with the actuated joints locked: from a singular direct solution `pose` finite
/// steps along the null motion of A lead to further ones. Numerical, not a proof.
bool on_continuum(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// Whether a search from random poses finds a continuum of direct solutions. "No" proves nothing.
bool continuum_found(const Manipulator& manipulator, const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_DIRECT_PROBLEM_H
