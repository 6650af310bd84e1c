// SPDX-License-Identifier: BSD-3-Clause
#include "motion/proved_solution.h"

#include "interval/rounding.h"

#include <cmath>
#include <cstddef>

namespace parallel_aspects {
namespace {

// Far above what rounding leaves between a pose and actuated values, far below distances of solutions [rad,
// or of the size of the robot].
constexpr double allowed = 1e-10;

}  // namespace

SolutionProver::SolutionProver(const SegmentCertifier& segments)
    : segments_(segments), certifier_(*segments.manipulator()) {
  allowance_.resize(static_cast<Eigen::Index>(manipulator().leg_count()));
  for (std::size_t j = 0; j < manipulator().leg_count(); ++j)
    allowance_[static_cast<Eigen::Index>(j)] =
        manipulator().leg(j).actuated_by_angle() ? allowed : allowed * manipulator().size();
}

std::optional<WorkingMode> SolutionProver::mode_of(const CertifiedPoint& point, double radius) const {
  WorkingMode mode(manipulator().leg_count());
  for (std::size_t j = 0; j < manipulator().leg_count(); ++j) {
    const int sign = certifier_.entry_sign(point, j, radius, allowance_[static_cast<Eigen::Index>(j)]);
    if (sign == 0) return std::nullopt;
    mode.set_sign(j, sign);
  }
  return mode;
}

// For all actuated values within the allowance the ball has one solution, which moves with them. The pose is
// that of some of these values: on the straight way from there to q the solution goes to that of q. It stays
// in the ball, where det A and B_jj do not vanish, and all constraints hold.
std::optional<ProvedSolution> SolutionProver::prove(const JointVector& q, const Pose& near) const {
  const RoundingUpward rounding;
  CertifiedPoint point;
  point.pose = near;
  point.q = q;
  if (!certifier_.evaluate(point)) return std::nullopt;
  const TaskVector still = TaskVector::Zero(allowance_.size());
  const CertifiedBall ball = certifier_.ball(point, still, allowance_, 0.0, 0.0);
  if (!ball.certified || !certifier_.assembles_within(point, allowance_)) return std::nullopt;
  const auto mode = mode_of(point, ball.radius);
  const int sign = certifier_.determinant_sign(point);
  if (!mode || sign == 0) return std::nullopt;
  const double turn = ball.radius / manipulator().characteristic_length();
  if (!segments_.prove_around(point.pose, ball.radius, turn, *mode).free) return std::nullopt;
  return ProvedSolution{point.pose, *mode, sign, ball.radius};
}

// By a factor that no rounding makes up for: no radius is below a billionth of the robot's size.
bool SolutionProver::differ(const ProvedSolution& first, const ProvedSolution& second) const {
  const double turned =
      manipulator().characteristic_length() * first.pose.orientation.angularDistance(second.pose.orientation);
  const double moved = (first.pose.position - second.pose.position).norm();
  return std::hypot(turned, moved) > 2.0 * (first.radius + second.radius);
}

}  // namespace parallel_aspects
