// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_JACOBIANS_H
#define PARALLEL_ASPECTS_KINEMATICS_JACOBIANS_H

#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <optional>

namespace parallel_aspects {

/// A of the velocity model A t = B q̇ (the sign convention of the paper's five-bar): one row a leg, one column
/// a degree of freedom. With u = p - c and b = p - operational point, row j is u (T1, T2, T3; of it what the
/// space moves), (b x u, u) (SE2, SE3) or p x u (SO3); columns follow the twist t = (w, v). Translational
/// columns in m, rotational ones in m^2.
TaskMatrix direct_matrix(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// A with its rows over their rod length and its rotational columns over the characteristic length.
/// Dimensionless.
TaskMatrix homogenised_matrix(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// The diagonal of B: B_jj = u_j . c_j'(q_j) + rho_j rho_j' [m^2/rad for an angle, m for a length].
TaskVector inverse_diagonal(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// f_j(X, q_j) of every leg [m^2].
TaskVector residuals(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// det A [m for T1, m^2 for T2, m^4 for SE2, m^3 for T3, m^6 for SO3, m^9 for SE3].
double direct_determinant(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// The signs of B; nothing where an entry is exactly zero or not a number.
std::optional<WorkingMode> working_mode(const Manipulator& manipulator, const Pose& pose,
                                        const JointVector& q);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_JACOBIANS_H
