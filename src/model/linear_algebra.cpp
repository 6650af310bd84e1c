// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"

#include "model/angles.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace parallel_aspects {

SingularValueDecomposition singular_value_decomposition(const Eigen::MatrixXd& matrix) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
}

Eigen::VectorXd least_squares_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                       double tolerance) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(tolerance);
  return decomposition.compute(matrix).solve(right);
}

Eigen::VectorXd positive_definite_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.ldlt().solve(right);
}

Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::Quaterniond shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const Eigen::Vector3d middle = a + b;
  // Half a turn about any axis across; so near to it, the direction of the middle would be rounding.
  if (middle.norm() < 1e-7) return Eigen::Quaterniond(Eigen::AngleAxisd(pi, a.unitOrthogonal()));
  const Eigen::Vector3d half = middle.normalized(), axis = a.cross(half);
  return Eigen::Quaterniond(a.dot(half), axis.x(), axis.y(), axis.z()).normalized();
}

double determinant(const TaskMatrix& matrix) { return matrix.determinant(); }

TaskMatrix inverse(const TaskMatrix& matrix) { return matrix.inverse(); }

TaskVector solution(const TaskMatrix& matrix, const TaskVector& right) {
  return matrix.partialPivLu().solve(right);
}

TaskVector singular_values(const TaskMatrix& matrix) {
  return Eigen::JacobiSVD<TaskMatrix, Eigen::NoQRPreconditioner>(matrix).singularValues();
}

}  // namespace parallel_aspects
