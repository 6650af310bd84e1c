// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_SOLUTIONS_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_SOLUTIONS_H

#include "aspects/cusps/strut_slice.h"
#include "aspects/solutions/solution_equations.h"
#include "interval/interval.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
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

/// A box of a slice of SE2 about the pose that is small, but wide for roundings.
Box box_about(const AnchorCircle& circle, const Pose& pose);

/// Takes points of slices of three struts to poses, lengths to joint values, and back. Rounds as the thread
/// does: none of it is an enclosure.
class StrutPoses {
 public:
  /// Of one slice or of a family; `held` is the joint value of one slice. The manipulator must outlive it.
  StrutPoses(const Manipulator& manipulator, const StrutSlice& slice, double held)
      : manipulator_(manipulator),
        legs_{slice.leg(0), slice.leg(1), slice.leg(2)},
        is_family_(slice.dimension() == 3),
        held_(held) {}

  /// In the middle of a box, at these lengths.
  Pose pose(const Box& box, const Lengths& lengths) const;

  /// See above.
  Box box_about(const Pose& pose) const;

  /// Of one slice the third is 0. Negative where there is no value, or the strut cannot have it.
  Lengths lengths(const JointVector& actuated) const;

  /// Joint values at a pose, with that which is held; empty where there are none, as where it has a NaN.
  JointVector actuated(const Pose& pose) const;

 private:
  AnchorCircle circle(double squared_length) const;

  const Manipulator& manipulator_;
  std::array<std::size_t, 3> legs_;
  bool is_family_;
  double held_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_SOLUTIONS_H
