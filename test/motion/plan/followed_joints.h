// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_MOTION_PLAN_FOLLOWED_JOINTS_H
#define PARALLEL_ASPECTS_TEST_MOTION_PLAN_FOLLOWED_JOINTS_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Dense>

#include <cstddef>

namespace parallel_aspects::test {

/// Follows the platform by Newton's method with a matrix of differences while the joints run straight; the
/// sign of det A at every step, 0 where it changes.
struct Followed {
  Pose end;
  int sign = 0;
};

inline Eigen::VectorXd errors_of_legs(const Manipulator& robot, const Pose& pose, const JointVector& q) {
  Eigen::VectorXd f(static_cast<Eigen::Index>(robot.leg_count()));
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const Leg& leg = robot.leg(j);
    f[static_cast<Eigen::Index>(j)] = leg.residual(pose, q[static_cast<Eigen::Index>(j)]);
  }
  return f;
}

inline Pose moved(const Pose& pose, const Eigen::VectorXd& by) {
  Pose result = pose;
  result.position += by.head<3>();
  const double angle = by.tail<3>().norm();
  if (angle > 0.0)
    result.orientation =
        Eigen::Quaterniond(Eigen::AngleAxisd(angle, by.tail<3>() / angle)) * result.orientation;
  return result;
}

inline Eigen::MatrixXd slopes(const Manipulator& robot, const Pose& pose, const JointVector& q) {
  constexpr double step = 1e-6;
  Eigen::MatrixXd matrix(6, 6);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const Eigen::VectorXd by = step * Eigen::VectorXd::Unit(6, i);
    matrix.col(i) = (errors_of_legs(robot, moved(pose, by), q) - errors_of_legs(robot, moved(pose, -by), q)) /
                    (2.0 * step);
  }
  return matrix;
}

inline Followed follow(const Manipulator& robot, Pose pose, const JointVector& from, const JointVector& to) {
  constexpr int steps = 200;
  Followed result;
  result.sign = slopes(robot, pose, from).determinant() > 0.0 ? 1 : -1;
  const int first = result.sign;
  for (int k = 0; k <= steps; ++k) {
    const JointVector q = from + (static_cast<double>(k) / steps) * (to - from);
    for (int i = 0; i < 6; ++i) {
      const Eigen::MatrixXd matrix = slopes(robot, pose, q);
      if (matrix.determinant() * first <= 0.0) result.sign = 0;
      pose = moved(pose, -matrix.fullPivLu().solve(errors_of_legs(robot, pose, q)));
    }
  }
  result.end = pose;
  return result;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_MOTION_PLAN_FOLLOWED_JOINTS_H
