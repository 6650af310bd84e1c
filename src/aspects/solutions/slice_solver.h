// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SLICE_SOLVER_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SLICE_SOLVER_H

#include "aspects/cusps/held_slice.h"
#include "parallel_aspects/aspects/box.h"

#include <array>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// A point of the slice that has given values of both joints that move.
struct SliceSolution {
  Box enclosure;           ///< holds it, and no other [half turns]
  SlicePosture posture{};  ///< its signs of B_jj; 0 where that is not known
};

/// All there are, proved. Nothing where that is not proved, as where solutions meet. Needs a live
/// `RoundingUpward`; not of actuated elbows.
std::optional<std::vector<SliceSolution>> find_slice_solutions(const HeldSlice& slice,
                                                               const std::array<double, 2>& values);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SLICE_SOLVER_H
