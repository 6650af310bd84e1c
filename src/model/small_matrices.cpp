// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace parallel_aspects {

double determinant(const TaskMatrix& matrix) { return matrix.determinant(); }

TaskMatrix inverse(const TaskMatrix& matrix) { return matrix.inverse(); }

TaskVector solution(const TaskMatrix& matrix, const TaskVector& right) {
  return matrix.partialPivLu().solve(right);
}

TaskVector singular_values(const TaskMatrix& matrix) {
  return Eigen::JacobiSVD<TaskMatrix, Eigen::NoQRPreconditioner>(matrix).singularValues();
}

}  // namespace parallel_aspects
