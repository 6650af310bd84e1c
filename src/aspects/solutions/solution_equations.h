// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_EQUATIONS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_EQUATIONS_H

#include "aspects/zeros/krawczyk.h"
#include "parallel_aspects/aspects/box.h"

#include <array>
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SOLUTION_EQUATIONS_H
