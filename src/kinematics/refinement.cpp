// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/refinement.h"

#include "parallel_aspects/kinematics/jacobians.h"
#include "parallel_aspects/kinematics/locked_legs.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr int most_steps = 40;

// Close to a singularity the residual may first rise with a step along the near null motion of A, for that
// bends, and then fall again.
constexpr int most_idle_steps = 6;

// Where the residual does not fall from here, it is rounding.
constexpr double converged = 1e-14;

// A below this is singular for the search of a continuum, dimensionless.
constexpr double singular = 1e-6;

// A pose that assembles, relative to the scale.
constexpr double assembled = 1e-12;

Eigen::Index rotational_columns(TaskSpace space) {
  if (!has_rotation(space)) return 0;
  return space == TaskSpace::SE2 ? 1 : 3;
}

// A with rows over their rod length and rotational columns over the characteristic length.
TaskMatrix homogenised(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  TaskMatrix matrix = direct_matrix(manipulator, pose, q);
  matrix.leftCols(rotational_columns(manipulator.task_space())) /= manipulator.characteristic_length();
  for (Eigen::Index j = 0; j < matrix.rows(); ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const double rod = (pose.transform(leg.anchor) - leg.proximal_point(q[j])).norm();
    if (rod > 0.0) matrix.row(j) /= rod;
  }
  return matrix;
}

double largest_residual(const Manipulator& manipulator, const Pose& pose, const JointVector& q,
                        double scale) {
  return residuals(manipulator, pose, q).cwiseAbs().maxCoeff() / (scale * scale);
}

Pose after_newton_step(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const TaskVector f = residuals(manipulator, pose, q);
  const TaskVector step = -0.5 * direct_matrix(manipulator, pose, q).partialPivLu().solve(f);
  return displaced(manipulator.task_space(), pose, step);
}

// Without the part along motions that A (nearly) does not feel.
TaskVector step_without_null_motion(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  constexpr double null_motion = 1e-3;
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(direct_matrix(manipulator, pose, q),
                                        Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(null_motion);
  return svd.solve(Eigen::VectorXd(-0.5 * residuals(manipulator, pose, q)));
}

// Gauss-Newton that stays where it started along the null motions of A.
Pose pulled_back(const Manipulator& manipulator, Pose pose, const JointVector& q) {
  for (int i = 0; i < 12; ++i)
    pose = displaced(manipulator.task_space(), pose, step_without_null_motion(manipulator, pose, q));
  return pose;
}

double distance(const Manipulator& manipulator, const Pose& a, const Pose& b) {
  const double turn = a.orientation.angularDistance(b.orientation) * manipulator.characteristic_length();
  return std::hypot((a.position - b.position).norm(), has_rotation(manipulator.task_space()) ? turn : 0.0);
}

// Whether a step of `length` [m] along `twist` (homogenised, unit) can be pulled back to another singular
// solution.
bool leads_on(const Manipulator& manipulator, const Pose& pose, const JointVector& q, TaskVector twist,
              double length) {
  twist.head(rotational_columns(manipulator.task_space())) /= manipulator.characteristic_length();
  const Pose away = displaced(manipulator.task_space(), pose, length * twist);
  const Pose landed = pulled_back(manipulator, away, q);
  const double moved = distance(manipulator, pose, landed), scale = assembly_scale(manipulator, q);
  return moved > 0.5 * length && moved < 2.0 * length &&
         largest_residual(manipulator, landed, q, scale) < assembled &&
         smallest_singular_value_bound(manipulator, landed, q) < singular;
}

}  // namespace

Refinement refined(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const double scale = assembly_scale(manipulator, q);
  Refinement best{pose, largest_residual(manipulator, pose, q, scale), 0.0};
  Pose now = pose;
  for (int step = 0, idle = 0; step < most_steps && idle < most_idle_steps; ++step) {
    now = after_newton_step(manipulator, now, q);
    const double residual = largest_residual(manipulator, now, q, scale);
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

double assembly_scale(const Manipulator& manipulator, const JointVector& q) {
  double scale = manipulator.size();
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const LockedLeg leg = locked(manipulator.leg(j), q[static_cast<Eigen::Index>(j)]);
    scale = std::max({scale, std::sqrt(leg.squared_length), leg.anchor.norm()});
  }
  return scale;
}

double smallest_singular_value_bound(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const double inverse_norm = homogenised(manipulator, pose, q).inverse().norm();
  return std::isfinite(inverse_norm) ? 1.0 / inverse_norm : 0.0;
}

bool on_continuum(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(homogenised(manipulator, pose, q), Eigen::ComputeFullV);
  const double scale = manipulator.size();
  for (Eigen::Index k = svd.singularValues().size() - 1; k >= 0 && svd.singularValues()[k] < singular; --k) {
    const TaskVector twist = svd.matrixV().col(k);
    const auto leads = [&](double length) { return leads_on(manipulator, pose, q, twist, length * scale); };
    if ((leads(0.005) && leads(0.01) && leads(0.02)) || (leads(-0.005) && leads(-0.01) && leads(-0.02)))
      return true;
  }
  return false;
}

}  // namespace parallel_aspects
