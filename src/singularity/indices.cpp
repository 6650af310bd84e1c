// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/singularity/indices.h"

#include "parallel_aspects/kinematics/jacobians.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace parallel_aspects {
SingularityIndices singularity_indices(const Manipulator& manipulator, const Pose& pose,
                                       const JointVector& q) {
  const TaskMatrix direct = direct_matrix(manipulator, pose, q);
  const TaskVector singular_values =
      Eigen::JacobiSVD<TaskMatrix>(homogenised_matrix(manipulator, pose, q)).singularValues();
  const double largest = singular_values[0];
  const double smallest = singular_values[singular_values.size() - 1];
  return {direct.determinant(), inverse_diagonal(manipulator, pose, q), smallest,
          largest > 0.0 ? smallest / largest : 0.0};
}

}  // namespace parallel_aspects
