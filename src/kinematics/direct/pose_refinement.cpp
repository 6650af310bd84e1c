// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/pose_refinement.h"

#include "kinematics/direct/locked_legs.h"
#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/jacobians.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr int max_steps = 40;

// Close to a singularity the residual may first rise with a step along the near null motion of A, for that
// bends, and then fall again.
constexpr int max_idle_steps = 6;

// Where the residual does not fall from here, it is rounding.
constexpr double converged = 1e-14;

Pose after_newton_step(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const TaskVector f = residuals(manipulator, pose, q);
  const TaskVector step = -0.5 * solution(direct_matrix(manipulator, pose, q), f);
  return displaced(manipulator.task_space(), pose, step);
}

}  // namespace

Refinement refined(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const double scale = assembly_scale(manipulator, q);
  Refinement best{pose, relative_residual(manipulator, pose, q, scale), 0.0};
  Pose now = pose;
  for (int step = 0, idle = 0; step < max_steps && idle < max_idle_steps; ++step) {
    now = after_newton_step(manipulator, now, q);
    const double residual = relative_residual(manipulator, now, q, scale);
    if (!std::isfinite(residual)) break;
    ++idle;
    if (residual < best.residual) {
      best.pose = now;
      best.residual = residual;
      idle = 0;
    } else if (best.residual < converged) {
      break;
    }
  }
  best.singular_value = smallest_singular_value_bound(manipulator, best.pose, q);
  return best;
}

double relative_residual(const Manipulator& manipulator, const Pose& pose, const JointVector& q,
                         double scale) {
  return residuals(manipulator, pose, q).cwiseAbs().maxCoeff() / (scale * scale);
}

double assembly_scale(const Manipulator& manipulator, const JointVector& q) {
  double scale = manipulator.size();
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const LockedLeg leg = locked(manipulator.leg(j), q[static_cast<Eigen::Index>(j)]);
    const double driven = (leg.base - manipulator.leg(j).base_point()).norm();
    scale = std::max({scale, driven, std::sqrt(leg.squared_length), leg.anchor.norm()});
  }
  return scale;
}

double smallest_singular_value_bound(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const double inverse_norm = inverse(homogenised_matrix(manipulator, pose, q)).norm();
  return std::isfinite(inverse_norm) ? 1.0 / inverse_norm : 0.0;
}

}  // namespace parallel_aspects
