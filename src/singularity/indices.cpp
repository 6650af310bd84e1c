// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/singularity/indices.h"

#include "parallel_aspects/kinematics/jacobians.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace parallel_aspects {
namespace {

Eigen::Index rotational_columns(TaskSpace space) {
  if (!has_rotation(space)) return 0;
  return space == TaskSpace::SE2 ? 1 : 3;
}

TaskMatrix homogenised(const Manipulator& manipulator, const Pose& pose, const JointVector& q,
                       const TaskMatrix& direct) {
  TaskMatrix matrix = direct;
  matrix.leftCols(rotational_columns(manipulator.task_space())) /= manipulator.characteristic_length();
  for (Eigen::Index j = 0; j < matrix.rows(); ++j) {
    const Leg& leg = manipulator.leg(static_cast<std::size_t>(j));
    const double rod = (pose.transform(leg.anchor) - leg.proximal_point(q[j])).norm();
    if (rod > 0.0) matrix.row(j) /= rod;
  }
  return matrix;
}

}  // namespace

SingularityIndices singularity_indices(const Manipulator& manipulator, const Pose& pose,
                                       const JointVector& q) {
  const TaskMatrix direct = direct_matrix(manipulator, pose, q);
  const TaskVector singular_values =
      Eigen::JacobiSVD<TaskMatrix>(homogenised(manipulator, pose, q, direct)).singularValues();
  const double largest = singular_values[0];
  const double smallest = singular_values[singular_values.size() - 1];
  return {direct.determinant(), inverse_diagonal(manipulator, pose, q), smallest,
          largest > 0.0 ? smallest / largest : 0.0};
}

}  // namespace parallel_aspects
