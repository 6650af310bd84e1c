// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <cmath>

namespace parallel_aspects {
namespace {

/// M = Q R by reflections. Eigen's class has blocks for large matrices, and takes ten seconds to compile.
class Reflections {
 public:
  explicit Reflections(TallMatrix& matrix) noexcept : matrix_(matrix), pivots_(matrix.cols()) {
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
      auto normal = matrix_.col(k).tail(matrix.rows() - k);
      pivots_[k] = std::copysign(normal.norm(), -normal[0]);
      normal[0] -= pivots_[k];
      for (Eigen::Index next = k + 1; next < matrix.cols(); ++next) reflect(k, matrix_.col(next));
    }
  }

  double least_pivot() const noexcept { return pivots_.cwiseAbs().minCoeff(); }

  /// Q y, with R^T y = right and a last entry of zero.
  TallVector nearest(const TaskVector& right) const noexcept {
    TallVector y = TallVector::Zero(matrix_.rows());
    for (Eigen::Index k = 0; k < matrix_.cols(); ++k)
      y[k] = (right[k] - matrix_.col(k).head(k).dot(y.head(k))) / pivots_[k];
    return rotated(y);
  }

  /// The last column of Q.
  TallVector along() const noexcept { return rotated(TallVector::Unit(matrix_.rows(), matrix_.cols())); }

 private:
  template <class Vector>
  void reflect(Eigen::Index k, Vector&& vector) const noexcept {
    const auto normal = matrix_.col(k).tail(matrix_.rows() - k);
    auto part = vector.tail(matrix_.rows() - k);
    const double square = normal.squaredNorm();
    if (square > 0.0) part -= (2.0 / square * normal.dot(part)) * normal;
  }

  TallVector rotated(TallVector vector) const noexcept {
    for (Eigen::Index k = matrix_.cols(); k-- > 0;) reflect(k, vector);
    return vector;
  }

  TallMatrix& matrix_;  // above the diagonal R; from it down the normals of the reflections
  TaskVector pivots_;   // the diagonal of R
};

}  // namespace

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

Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& a,
                        const Eigen::Ref<const Eigen::MatrixXd>& b) {
  return a * b;
}

Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

double determinant(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  return SmallMatrix(matrix).determinant();
}

SmallMatrix inverse(const Eigen::Ref<const Eigen::MatrixXd>& matrix) { return SmallMatrix(matrix).inverse(); }

TaskVector solution(const Eigen::Ref<const Eigen::MatrixXd>& matrix, const TaskVector& right) {
  return SmallMatrix(matrix).partialPivLu().solve(right);
}

TaskVector singular_values(const TaskMatrix& matrix) {
  return Eigen::JacobiSVD<TaskMatrix, Eigen::NoQRPreconditioner>(matrix).singularValues();
}

LineOfSolutions line_of_solutions(TallMatrix matrix, const TaskVector& right) noexcept {
  const Reflections reflections(matrix);
  return {reflections.nearest(right), reflections.along(), reflections.least_pivot()};
}

}  // namespace parallel_aspects
