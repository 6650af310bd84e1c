// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_DENSE_DECOMPOSITIONS_H
#define PARALLEL_ASPECTS_MODEL_DENSE_DECOMPOSITIONS_H

#include <Eigen/Dense>

// Eigen's decompositions of matrices of any size are compiled once, in dense_decompositions.cpp: in every
// source that uses them they take ten seconds and more.
extern template class Eigen::JacobiSVD<Eigen::MatrixXd>;
extern template class Eigen::BDCSVD<Eigen::MatrixXd>;
extern template class Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
extern template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
extern template class Eigen::LDLT<Eigen::MatrixXd>;

#endif  // PARALLEL_ASPECTS_MODEL_DENSE_DECOMPOSITIONS_H
