// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/singularity/indices.h"

#include "model/linear_algebra.h"
#include "parallel_aspects/kinematics/jacobians.h"

namespace parallel_aspects {
SingularityIndices singularity_indices(const Manipulator& manipulator, const Pose& pose,
                                       const JointVector& q) {
  const TaskMatrix direct = direct_matrix(manipulator, pose, q);
  const TaskVector values = singular_values(homogenised_matrix(manipulator, pose, q));
  const double largest = values[0];
  const double smallest = values[values.size() - 1];
  return {determinant(direct), inverse_diagonal(manipulator, pose, q), smallest,
          largest > 0.0 ? smallest / largest : 0.0};
}

}  // namespace parallel_aspects
