// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_SEARCH_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_SEARCH_H

#include "aspects/cusps/strut_slice.h"
#include "aspects/zeros/krawczyk.h"
#include "parallel_aspects/aspects/box.h"

#include <array>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// g_0 and g_1 of these lengths.
std::array<Interval, 2> values_at(const Lengths& lengths) noexcept;

/// Both g_i less their values, over a box of the slice.
PairOverBox pair_over(const StrutSlice& slice, const Box& box, const std::array<Interval, 2>& values);

/// What is left of a box with one solution of these values after some contractions by Krawczyk's operator.
Box contracted(const StrutSlice& slice, Box box, const std::array<Interval, 2>& values, int times);

/// All points of the slice of these lengths where both g_i have their values, proved: each box holds exactly
/// one, and no two the same. Nothing where that is not proved, as where solutions meet. Needs a live
/// `RoundingUpward`.
std::optional<std::vector<Box>> find_all_solutions(const StrutSlice& slice, const Lengths& lengths);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_SEARCH_H
