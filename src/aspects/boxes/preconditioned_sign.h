// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_BOXES_PRECONDITIONED_SIGN_H
#define PARALLEL_ASPECTS_ASPECTS_BOXES_PRECONDITIONED_SIGN_H

#include "interval/affine.h"
#include "interval/near_identity.h"
#include "interval/nonsingular.h"
#include "legs/leg_rows.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// The sign of the determinant of a matrix of affine forms over a box; 0 where it is not proved. With C an
/// approximate inverse of the matrix A_0 of centers, A C is near the identity, so that every matrix between
/// is nonsingular and has the sign of A_0 (see `NearIdentity`). Where rows are close to dependent this is
/// much tighter than an affine form of the determinant. Needs a live `RoundingUpward`.
template <std::size_t Size, std::size_t Coordinates>
class PreconditionedSign {
 public:
  using Form = Affine<Coordinates>;
  using Rows = std::array<const Row<Form, Size>*, Size>;

  static int of(const Rows& rows) {
    NearIdentity<order> product(of_entries(rows, [](const Form& entry) { return entry.center(); }));
    product.add_error(of_entries(rows, [](const Form& entry) { return entry.error(); }));
    for (std::size_t i = 0; i < Coordinates; ++i)
      product.add_slope(of_entries(rows, [i](const Form& entry) { return entry.slope(i); }));
    double ratio = 0.0;
    if (!product.is_nonsingular(max_iterations, ratio)) return 0;
    SquareArray<Interval> centers;
    for (std::size_t i = 0; i < Size; ++i)
      for (std::size_t k = 0; k < Size; ++k) centers[i][k] = Interval((*rows[i])[k].center());
    return proved_determinant_sign(Size, centers);
  }

 private:
  static constexpr int order = static_cast<int>(Size);
  static constexpr int max_iterations = 4;
  using Matrix = Eigen::Matrix<double, order, order>;

  template <class Function>
  static Matrix of_entries(const Rows& rows, const Function& function) {
    Matrix result;
    for (std::size_t i = 0; i < Size; ++i)
      for (std::size_t k = 0; k < Size; ++k)
        result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = function((*rows[i])[k]);
    return result;
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_BOXES_PRECONDITIONED_SIGN_H
