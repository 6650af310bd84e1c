// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_LINEAR_ALGEBRA_H
#define PARALLEL_ASPECTS_MODEL_LINEAR_ALGEBRA_H

#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <type_traits>

namespace parallel_aspects {

/// From `first` to before `last`.
template <class Scalar>
struct CoefficientRange {
  Scalar* first;
  Scalar* last;

  Scalar* begin() const noexcept { return first; }
  Scalar* end() const noexcept { return last; }
};

/// The coefficients of a vector, for range-for and algorithms; valid as long as the vector keeps its size.
/// Eigen 3.3, of Ubuntu 20.04, has no begin() and end() of its own.
template <class Vector>
auto coefficients_of(Vector& vector) noexcept {
  using Plain = std::remove_const_t<Vector>;
  static_assert(Plain::IsVectorAtCompileTime && std::is_base_of_v<Eigen::PlainObjectBase<Plain>, Plain>,
                "only a vector of its own has its coefficients one after the other");
  using Scalar = std::remove_pointer_t<decltype(vector.data())>;
  return CoefficientRange<Scalar>{vector.data(), vector.data() + vector.size()};
}

// Eigen's decompositions behind plain functions: each is compiled once. In a source of their own they take up
// to forty seconds.

/// M = U diag(values) V^T of a matrix of m rows and n columns.
struct SingularValueDecomposition {
  Eigen::MatrixXd u;       ///< m x m, orthogonal
  Eigen::VectorXd values;  ///< min(m, n) of them, decreasing
  Eigen::MatrixXd v;       ///< n x n, orthogonal

  /// How many singular values exceed `tolerance`.
  Eigen::Index rank_above(double tolerance) const { return (values.array() > tolerance).count(); }

  /// An orthonormal basis of the vectors that M takes to zero, where `rank` singular values count.
  Eigen::MatrixXd null_space(Eigen::Index rank) const { return v.rightCols(v.cols() - rank); }
};

/// Of a matrix with at least one row and one column; entries must be finite.
SingularValueDecomposition singular_value_decomposition(const Eigen::MatrixXd& matrix);

/// Decreasing; as above.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// The x of smallest norm among those for which |M x - right| is least. Columns that are dependent to
/// `tolerance`, relative to the largest pivot, count as dependent.
Eigen::VectorXd least_squares_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                       double tolerance);

/// The x with M x = right, of a symmetric positive definite matrix.
Eigen::VectorXd positive_definite_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// A B.
Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& a,
                        const Eigen::Ref<const Eigen::MatrixXd>& b);

/// Of a symmetric matrix, increasing.
Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& matrix);

/// The shortest rotation that takes the direction `from` to the direction `to`; neither is zero.
Eigen::Quaterniond shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

// Square matrices of a manipulator. None of these allocates.

/// Of at most `max_legs` + 1 rows and columns.
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_legs + 1, max_legs + 1>;

/// Of a small matrix, as are the next two.
double determinant(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// Not finite where the matrix is singular.
SmallMatrix inverse(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// The x with M x = right; not finite where the matrix is singular.
TaskVector solution(const Eigen::Ref<const Eigen::MatrixXd>& matrix, const TaskVector& right);

/// Decreasing.
TaskVector singular_values(const TaskMatrix& matrix);

/// Of n + 1 rows and n columns, at most `max_legs`.
using TallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_legs + 1, max_legs>;
using TallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_legs + 1, 1>;

/// What solves n equations in n + 1 unknowns: `nearest`, and what differs from it by a multiple of `along`.
struct LineOfSolutions {
  TallVector nearest;  ///< of the smallest norm
  TallVector along;    ///< a unit vector
  double least_pivot;  ///< of the equations in magnitude; they are independent where it is not zero
};

/// Of the equations M^T x = right. Their gradients are the columns of M.
LineOfSolutions line_of_solutions(TallMatrix matrix, const TaskVector& right) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_LINEAR_ALGEBRA_H
