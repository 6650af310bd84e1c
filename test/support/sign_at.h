// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_SIGN_AT_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_SIGN_AT_H

#include "parallel_aspects/kinematics/kinematics.h"

#include <cmath>
#include <optional>

namespace parallel_aspects::test {

/// A second way to S(s, sigma), in plain double precision: the sign of det A at one pose; 0 outside; nothing
/// where rounding may tell one from the other.
inline std::optional<int> sign_at(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  const InverseSolution solution = inverse(robot, pose, mode);
  for (const Leg& leg : robot.legs()) {
    const double entry = squared_inverse_entry(leg, pose.transform(leg.anchor));
    const double scale = leg.actuated_by_angle() ? std::pow(robot.size(), 4) : std::pow(robot.size(), 2);
    if (std::abs(entry) < 1e-9 * scale) return std::nullopt;
  }
  if (solution.status == InverseStatus::out_of_reach) return 0;
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const double q = solution.q[static_cast<Eigen::Index>(j)];
    const JointLimits& limits = robot.leg(j).limits;
    if (std::abs(q - limits.lower) < 1e-9 || std::abs(q - limits.upper) < 1e-9) return std::nullopt;
  }
  if (solution.status != InverseStatus::solved) return 0;
  const TaskMatrix direct = direct_matrix(robot, pose, solution.q);
  const double determinant = direct_determinant(robot, pose, solution.q);
  if (std::abs(determinant) < 1e-11 * std::pow(direct.norm(), direct.rows())) return std::nullopt;
  return determinant > 0.0 ? 1 : -1;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_SIGN_AT_H
