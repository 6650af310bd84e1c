// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_EQUATIONS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_EQUATIONS_H

#include "aspects/cusps/strut_slice.h"
#include "aspects/solutions/solution_equations.h"

namespace parallel_aspects {

/// Of three struts: both g_i less half the squares of lengths, over one slice or a family of them.
class StrutEquations : public SolutionEquations {
 public:
  /// The slice must outlive it.
  explicit StrutEquations(const StrutSlice& slice) noexcept : slice_(slice) {}

  PairOverBox at(const Box& box, const ActuatedValues& lengths) const override;

  /// A strut is never stretched or folded.
  std::optional<PairOverBox> between(const Box& box, const ActuatedValues& from,
                                     const ActuatedValues& to) const override;

 private:
  const StrutSlice& slice_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_EQUATIONS_H
