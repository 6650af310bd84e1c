// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_TRACKER_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_TRACKER_H

#include "aspects/cusps/strut_slice.h"
#include "parallel_aspects/aspects/box.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Follows solutions along straight lines in the plane of both lengths, or in the space of all three. Needs a
/// live `RoundingUpward`.
class SolutionTracker {
 public:
  explicit SolutionTracker(const StrutSlice& slice) noexcept : slice_(slice) {}

  /// Where the solution in `box`, the only one in it for the lengths `from`, leads to: a box with exactly one
  /// solution for the lengths `to`. Every step is proved by Krawczyk's test for all lengths of it, so that
  /// the solution moves continuously and is regular all along. Nothing where that fails.
  std::optional<Box> follow(const Box& box, const Lengths& from, const Lengths& to) const;

  /// Which of `boxes`, which hold one solution each and together all there are for some lengths, has the one
  /// in `box`.
  static std::optional<std::size_t> find(const Box& box, const std::vector<Box>& boxes);

 private:
  std::optional<Box> step(const Box& box, const Lengths& from, const Lengths& to) const;
  static std::array<double, 2> approximated(const StrutSlice& slice, const Box& box, const Lengths& lengths);

  const StrutSlice& slice_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_TRACKER_H
