// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SLICE_EQUATIONS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SLICE_EQUATIONS_H

#include "aspects/cusps/held_slice.h"
#include "aspects/solutions/solution_equations.h"
#include "interval/interval.h"

#include <array>

namespace parallel_aspects {

/// Both legs whose joints move, at joint values or over ranges of them.
using LegsAt = std::array<HeldSlice::LegAt, 2>;

/// Both g_i over a place of the slice. Needs a live `RoundingUpward`.
PairOverBox pair_over(const LegsAt& legs, const SlicePlace& place);

/// Of legs of any kind, but elbows, with one joint held: both g_i.
class SliceEquations : public SolutionEquations {
 public:
  /// The slice must outlive it.
  explicit SliceEquations(const HeldSlice& slice) noexcept : slice_(slice) {}

  PairOverBox at(const Box& box, const ActuatedValues& values) const override;
  PairOverBox about(const Box& box, const ActuatedValues& values, double slack) const override;
  std::optional<PairOverBox> between(const Box& box, const ActuatedValues& from,
                                     const ActuatedValues& to) const override;

 private:
  const HeldSlice& slice_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SLICE_EQUATIONS_H
