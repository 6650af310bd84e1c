// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_NUMBERS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_NUMBERS_H

#include "aspects/cusps/held_slice.h"
#include "aspects/solutions/joint_ranges.h"
#include "aspects/solutions/slice_solver.h"
#include "aspects/solutions/value_strips.h"
#include "parallel_aspects/aspects/map_control.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/working_mode.h"

#include <functional>
#include <memory>
#include <optional>

namespace parallel_aspects {

/// A slice of legs of any kind, but elbows, with one joint held, and the values of both others.
struct SliceOfValues {
  HeldJoint held;
  std::unique_ptr<const HeldSlice> slice;
  JointRanges ranges;

  /// Needs a live `RoundingUpward`.
  SliceOfValues(const Manipulator& manipulator, const HeldJoint& joint);

  /// Nothing where it is not known.
  std::optional<WorkingMode> mode_of(const SliceSolution& solution) const;

  /// In the middle of the box of a solution.
  Pose pose_of(const Box& solution) const;
};

/// Sees all strips that the images of singular poses lie in.
using SeeStrip = std::function<void(const ValueStrip&)>;

/// The map, of this slice, tells the aspects of solutions; without one none are known. Needs a live
/// `RoundingUpward`.
SolutionNumbers find_solution_numbers(const Manipulator& manipulator,
                                      std::shared_ptr<const SliceOfValues> values,
                                      std::shared_ptr<const AspectMap> map, const SeeStrip& see,
                                      const MapControl& control);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_NUMBERS_H
