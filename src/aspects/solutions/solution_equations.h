// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_EQUATIONS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_EQUATIONS_H

#include "aspects/zeros/krawczyk.h"
#include "parallel_aspects/aspects/map_slice.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// Values of both joints that move in a slice, and of a family of slices that which is held [m or rad].
using ActuatedValues = std::array<double, 3>;

/// Values in another turn are rounded by far less [m or rad].
inline constexpr double turn_slack = 1e-12;

/// All solutions of such values, each in a box of its own; nothing where it is not proved that these are all.
using SolveAt = std::function<std::optional<std::vector<Box>>(const ActuatedValues&)>;

/// The two equations that direct solutions solve. All of it needs a live `RoundingUpward`.
class SolutionEquations {
 public:
  virtual ~SolutionEquations() = default;

  /// Over a box, at these values.
  virtual PairOverBox at(const Box& box, const ActuatedValues& values) const = 0;

  /// Over a box, for all values that are off from these by so much, without a drift.
  virtual PairOverBox about(const Box& box, const ActuatedValues& values, double slack) const = 0;

  /// Over a box, for all values on the line between two: there the parameter of the drift is -1 and 1.
  /// Nothing where a leg may be stretched or folded.
  virtual std::optional<PairOverBox> between(const Box& box, const ActuatedValues& from,
                                             const ActuatedValues& to) const = 0;
};

/// Two functions over a box of a slice.
using PairOver = std::function<PairOverBox(const Box&)>;

/// What is left of a box with one zero after some contractions by Krawczyk's operator.
Box contracted(const PairOver& pair_over, Box box, int times);

/// All zeros of both functions in the slice, proved: each box holds exactly one, and no two the same. Nothing
/// where that is not proved, as where zeros meet. Needs a live `RoundingUpward`.
std::optional<std::vector<Box>> find_all_zeros(const PairOver& pair_over);

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

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_EQUATIONS_H
