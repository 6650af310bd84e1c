// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ELIMINATION_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ELIMINATION_H

#include <Eigen/Core>

namespace parallel_aspects::test {

/// By elimination with the largest pivot of each column. Eigen's own takes seconds to compile for each
/// kind of number.
template <class Matrix>
typename Matrix::Scalar determinant_by_elimination(Matrix m) {
  typename Matrix::Scalar result = 1;
  for (Eigen::Index k = 0; k < m.cols(); ++k) {
    Eigen::Index largest = 0;
    m.col(k).tail(m.rows() - k).cwiseAbs().maxCoeff(&largest);
    if (largest != 0) {
      m.row(k).swap(m.row(k + largest));
      result = -result;
    }
    const auto pivot = m(k, k);
    result *= pivot;
    if (pivot == 0) return 0;
    for (Eigen::Index i = k + 1; i < m.rows(); ++i) m.row(i) -= m(i, k) / pivot * m.row(k);
  }
  return result;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ELIMINATION_H
