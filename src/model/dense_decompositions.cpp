// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/dense_decompositions.h"

template class Eigen::JacobiSVD<Eigen::MatrixXd>;
template class Eigen::BDCSVD<Eigen::MatrixXd>;
template class Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
template class Eigen::LDLT<Eigen::MatrixXd>;
