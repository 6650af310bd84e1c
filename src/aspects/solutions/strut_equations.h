// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_EQUATIONS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_EQUATIONS_H

#include "aspects/cusps/strut_slice.h"
#include "aspects/solutions/solution_equations.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/box.h"

#include <array>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// g_0 and g_1 of these lengths.
std::array<Interval, 2> values_at(const Lengths& lengths) noexcept;

/// Both g_i less their values, over a box of the slice.
PairOverBox pair_over(const StrutSlice& slice, const Box& box, const std::array<Interval, 2>& values);

/// All points of the slice of these lengths where both g_i have their values, proved: each box holds exactly
/// one, and no two the same. Nothing where that is not proved, as where solutions meet. Needs a live
/// `RoundingUpward`.
std::optional<std::vector<Box>> find_all_solutions(const StrutSlice& slice, const Lengths& lengths);

/// Of three struts: both g_i less half the squares of lengths, over one slice or a family of them.
class StrutEquations : public SolutionEquations {
 public:
  /// The slice must outlive it.
  explicit StrutEquations(const StrutSlice& slice) noexcept : slice_(slice) {}

  PairOverBox at(const Box& box, const ActuatedValues& lengths) const override;
  PairOverBox about(const Box& box, const ActuatedValues& lengths, double slack) const override;

  /// A strut is never stretched or folded.
  std::optional<PairOverBox> between(const Box& box, const ActuatedValues& from,
                                     const ActuatedValues& to) const override;

 private:
  const StrutSlice& slice_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_EQUATIONS_H
