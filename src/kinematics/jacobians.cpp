// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/jacobians.h"

#include "model/linear_algebra.h"
#include "model/matrix_row.h"

#include <Eigen/Geometry>

namespace parallel_aspects {
TaskMatrix direct_matrix(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const auto n = static_cast<Eigen::Index>(manipulator.leg_count());
  TaskMatrix matrix(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const Eigen::Vector3d b = pose.orientation * leg.anchor;
    const Eigen::Vector3d u = pose.position + b - leg.proximal_point(q[j]);
    auto row = matrix.row(j);
    write_row(manipulator.task_space(), b, u, row);
  }
  return matrix;
}

TaskMatrix homogenised_matrix(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  TaskMatrix matrix = direct_matrix(manipulator, pose, q);
  matrix.leftCols(static_cast<Eigen::Index>(rotational_degrees_of_freedom(manipulator.task_space()))) /=
      manipulator.characteristic_length();
  for (Eigen::Index j = 0; j < matrix.rows(); ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const double rod = (pose.transform(leg.anchor) - leg.proximal_point(q[j])).norm();
    if (rod > 0.0) matrix.row(j) /= rod;
  }
  return matrix;
}

TaskVector inverse_diagonal(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const auto n = static_cast<Eigen::Index>(manipulator.leg_count());
  TaskVector diagonal(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const Eigen::Vector3d u = pose.transform(leg.anchor) - leg.proximal_point(q[j]);
    diagonal[j] = u.dot(leg.proximal_point_derivative(q[j])) + 0.5 * leg.squared_distance_derivative(q[j]);
  }
  return diagonal;
}

TaskVector residuals(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const auto n = static_cast<Eigen::Index>(manipulator.leg_count());
  TaskVector result(n);
  for (Eigen::Index j = 0; j < n; ++j)
    result[j] = manipulator.leg(static_cast<std::size_t>(j)).residual(pose, q[j]);
  return result;
}

double direct_determinant(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  return determinant(direct_matrix(manipulator, pose, q));
}

std::optional<WorkingMode> working_mode(const Manipulator& manipulator, const Pose& pose,
                                        const JointVector& q) {
  const TaskVector diagonal = inverse_diagonal(manipulator, pose, q);
  WorkingMode mode(manipulator.leg_count());
  for (Eigen::Index j = 0; j < diagonal.size(); ++j) {
    if (!(diagonal[j] < 0.0 || diagonal[j] > 0.0)) return std::nullopt;
    mode.set_sign(static_cast<std::size_t>(j), diagonal[j] > 0.0 ? 1 : -1);
  }
  return mode;
}

}  // namespace parallel_aspects
