// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_NONSINGULAR_H
#define PARALLEL_ASPECTS_INTERVAL_NONSINGULAR_H

#include "interval/interval.h"
#include "interval/path_form.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// Up to `max_legs` rows and columns; those beyond the size are not used.
template <class Scalar>
using SquareArray = std::array<std::array<Scalar, max_legs>, max_legs>;

/// The sign of the determinant of every real matrix in an interval matrix of `size` rows, by Gaussian
/// elimination; 0 where that is not proved. Entries must be finite. Needs a live `RoundingUpward`.
int proved_determinant_sign(std::size_t size, SquareArray<Interval> matrix) noexcept;

/// Whether each A(s), s in [-1, 1], is proved nonsingular (see `NearIdentity`). `ratio` becomes an upper
/// bound of the spectral radius there, for step control; infinite where there is none. Needs a live
/// `RoundingUpward`.
bool proved_nonsingular(std::size_t size, const SquareArray<PathForm>& matrix, double& ratio) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_NONSINGULAR_H
