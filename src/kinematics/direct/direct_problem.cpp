// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_problem.h"

#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

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
  return displaced(manipulator.motions(), pose, step);
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

namespace {

// A below this is singular, dimensionless.
constexpr double singular = 1e-6;

// A pose that assembles, relative to the scale.
constexpr double assembled_residual = 1e-12;

// Singular values below this, relative to the largest, belong to motions that A nearly does not feel.
constexpr double null_motion = 1e-3;

// Gauss-Newton that stays where it started along the null motions of A.
Pose pulled_back(const Manipulator& manipulator, Pose pose, const JointVector& q, int steps) {
  for (int i = 0; i < steps; ++i) {
    const auto svd = singular_value_decomposition(direct_matrix(manipulator, pose, q));
    const Eigen::Index rank = svd.rank_above(null_motion * svd.values[0]);
    const Eigen::VectorXd parts = svd.u.leftCols(rank).transpose() * (-0.5 * residuals(manipulator, pose, q));
    const TaskVector step = svd.v.leftCols(rank) * parts.cwiseQuotient(svd.values.head(rank));
    pose = displaced(manipulator.motions(), pose, step);
  }
  return pose;
}

double distance(const Manipulator& manipulator, const Pose& a, const Pose& b) {
  const double turn = a.orientation.angularDistance(b.orientation) * manipulator.characteristic_length();
  return std::hypot((a.position - b.position).norm(), has_rotation(manipulator.task_space()) ? turn : 0.0);
}

bool is_singular_solution(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  return relative_residual(manipulator, pose, q, assembly_scale(manipulator, q)) < assembled_residual &&
         smallest_singular_value_bound(manipulator, pose, q) < singular;
}

// Whether a step of `length` [m] along `twist` (homogenised, unit) can be pulled back to another singular
// solution.
bool leads_on(const Manipulator& manipulator, const Pose& pose, const JointVector& q, TaskVector twist,
              double length) {
  twist.head(static_cast<Eigen::Index>(rotational_degrees_of_freedom(manipulator.task_space()))) /=
      manipulator.characteristic_length();
  const Pose away = displaced(manipulator.motions(), pose, length * twist);
  const Pose landed = pulled_back(manipulator, away, q, 12);
  const double moved = distance(manipulator, pose, landed), expected = std::abs(length);
  return moved > 0.5 * expected && moved < 2.0 * expected && is_singular_solution(manipulator, landed, q);
}

Pose random_pose(const Manipulator& manipulator, std::mt19937& engine) {
  std::normal_distribution<double> normal;
  TaskVector twist(static_cast<Eigen::Index>(manipulator.leg_count()));
  for (double& each : coefficients_of(twist)) each = normal(engine);
  const auto rotations = static_cast<Eigen::Index>(rotational_degrees_of_freedom(manipulator.task_space()));
  twist.tail(twist.size() - rotations) *= manipulator.size();
  return displaced(manipulator.motions(), Pose{}, twist);
}

}  // namespace

bool on_continuum(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const auto svd = singular_value_decomposition(homogenised_matrix(manipulator, pose, q));
  const double size = manipulator.size();
  for (Eigen::Index k = svd.values.size() - 1; k >= 0 && svd.values[k] < singular; --k) {
    const TaskVector twist = svd.v.col(k);
    // From an isolated solution a step is pulled back to where it began, or to another one by accident. That
    // it lands about a step away at each of three lengths, and singular again, is taken for a continuum.
    const auto leads = [&](double share) { return leads_on(manipulator, pose, q, twist, share * size); };
    if ((leads(0.005) && leads(0.01) && leads(0.02)) || (leads(-0.005) && leads(-0.01) && leads(-0.02)))
      return true;
  }
  return false;
}

bool continuum_found(const Manipulator& manipulator, const JointVector& q) {
  constexpr int starts = 30, steps = 40;
  std::mt19937 engine(1);
  for (int i = 0; i < starts; ++i) {
    const Pose pose = pulled_back(manipulator, random_pose(manipulator, engine), q, steps);
    if (is_singular_solution(manipulator, pose, q) && on_continuum(manipulator, pose, q)) return true;
  }
  return false;
}

}  // namespace parallel_aspects
