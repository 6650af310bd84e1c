// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_ALL_ZEROS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_ALL_ZEROS_H

#include "aspects/zeros/krawczyk.h"
#include "parallel_aspects/aspects/box.h"

#include <functional>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Two functions over a box of a slice.
using PairOver = std::function<PairOverBox(const Box&)>;

/// What is left of a box with one zero after some contractions by Krawczyk's operator.
Box contracted(const PairOver& pair_over, Box box, int times);

/// All zeros of both functions in the slice, proved: each box holds exactly one, and no two the same. Nothing
/// where that is not proved, as where zeros meet. Needs a live `RoundingUpward`.
std::optional<std::vector<Box>> find_all_zeros(const PairOver& pair_over);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_ALL_ZEROS_H
