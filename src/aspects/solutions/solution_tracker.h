// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_TRACKER_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_TRACKER_H

#include "aspects/solutions/solution_equations.h"
#include "parallel_aspects/aspects/box.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Follows solutions along straight lines in the plane of both values, or in the space of all three. Needs a
/// live `RoundingUpward`.
class SolutionTracker {
 public:
  /// The equations must outlive it.
  explicit SolutionTracker(const SolutionEquations& equations) noexcept : equations_(equations) {}

  /// Where the solution in `box`, the only one in it for the values `from`, leads to: a box with exactly one
  /// solution for the values `to`. Every step is proved by Krawczyk's test for all values of it, so that
  /// the solution moves continuously, is regular and keeps its working mode all along. Nothing where that
  /// fails.
  std::optional<Box> follow(const Box& box, const ActuatedValues& from, const ActuatedValues& to) const;

  /// A box about the solution in `box` that has exactly one solution for these values, and for any that are
  /// off by so much, such as the same in another turn, by rounding. Nothing where that is not proved.
  std::optional<Box> widened(const Box& box, const ActuatedValues& values, double slack) const;

  /// Which of `boxes`, which hold one solution each and together all there are for some values, has the one
  /// in `box`.
  static std::optional<std::size_t> find(const Box& box, const std::vector<Box>& boxes);

 private:
  std::optional<Box> step(const Box& box, const ActuatedValues& from, const ActuatedValues& to) const;
  Box contracted_at(const ActuatedValues& values, const Box& box, int times) const;
  std::array<double, 2> approximated(const Box& box, const ActuatedValues& values) const;

  const SolutionEquations& equations_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_TRACKER_H
