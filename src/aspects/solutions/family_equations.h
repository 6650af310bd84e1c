// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_FAMILY_EQUATIONS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_FAMILY_EQUATIONS_H

#include "aspects/cusps/planar_held_slice.h"
#include "aspects/solutions/solution_equations.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/model/manipulator.h"

#include <cstddef>

namespace parallel_aspects {

/// Of three legs of any kind but actuated elbows: the equations of two of them, in the slice that holds the
/// joint of the third at its value. Values are those of all joints, in order.
class FamilyEquations : public SolutionEquations {
 public:
  /// Which joint is held; its value there is not read. Needs a live `RoundingUpward`.
  FamilyEquations(const Manipulator& manipulator, const HeldJoint& held);

  PairOverBox at(const Box& box, const ActuatedValues& values) const override;
  PairOverBox about(const Box& box, const ActuatedValues& values, double slack) const override;
  std::optional<PairOverBox> between(const Box& box, const ActuatedValues& from,
                                     const ActuatedValues& to) const override;

  /// The slice that holds the joint at these values.
  PlanarHeldSlice slice_at(const Interval& held) const noexcept;

 private:
  PlanarHeldSlice slices_;
  std::size_t held_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_FAMILY_EQUATIONS_H
