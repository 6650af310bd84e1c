// SPDX-License-Identifier: BSD-3-Clause
#include "distance/boundary_distance_parts.h"

#include <cmath>

namespace parallel_aspects {
namespace {

double displacement(const Leg& leg, double from, double to) {
  const bool wraps = leg.actuated_by_angle() && !leg.limits.limited();
  return wraps ? std::remainder(to - from, 2.0 * EIGEN_PI) : to - from;
}

}  // namespace

InverseSolution begin_distances(const Manipulator& robot, const Pose& pose, const WorkingMode& mode,
                                BoundaryDistances& result) noexcept {
  InverseSolution solution = inverse(robot, pose, mode);
  result.q = solution.q;
  result.status = solution.status == InverseStatus::out_of_reach ? ConfigurationStatus::out_of_reach
                  : solution.status == InverseStatus::solved     ? ConfigurationStatus::measured
                                                                 : ConfigurationStatus::outside_limits;
  return solution;
}

BoundaryDistance touching(std::size_t leg) noexcept {
  BoundaryDistance result;
  result.status = DistanceStatus::touching;
  result.leg = leg;
  return result;
}

void add_joints_of_witness(const Manipulator& robot, const WorkingMode& mode, const JointVector& q,
                           BoundaryDistance& found) noexcept {
  found.witness_q.resize(q.size());
  found.joint_displacement.resize(q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    const Leg& leg = robot.leg(index);
    found.witness_q[j] = joint_value(leg, found.witness.transform(leg.anchor), mode.sign(index));
    found.joint_displacement[j] = displacement(leg, q[j], found.witness_q[j]);
  }
}

}  // namespace parallel_aspects
