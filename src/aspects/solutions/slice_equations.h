// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SLICE_EQUATIONS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SLICE_EQUATIONS_H

#include "aspects/cusps/held_slice.h"
#include "aspects/cusps/planar_held_slice.h"
#include "aspects/solutions/solution_equations.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

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

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_SLICE_EQUATIONS_H
