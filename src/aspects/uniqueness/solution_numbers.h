// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_NUMBERS_H
#define PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_NUMBERS_H

#include "aspects/cusps/held_slice.h"
#include "aspects/regions/found_regions.h"
#include "aspects/solutions/joint_ranges.h"
#include "aspects/solutions/slice_equations.h"
#include "aspects/solutions/value_strips.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <functional>
#include <memory>
#include <optional>

namespace parallel_aspects {

// Sums of many measures are off by less.
inline constexpr double rounded_up = 1.0 + 1e-9, rounded_down = 1.0 - 1e-9;

/// The aspect that holds a pose; 0 where the map cannot decide, or not from others.
int aspect_at(const AspectMap& map, const Pose& pose, const WorkingMode& mode);

/// Adds a component to the list, and to the region of its number of solutions.
void add_component(BasicComponent component, SolutionNumbers& result);

/// Once all are added: on so much no number is proved [m^2 or other].
void set_unknown(double unknown, SolutionNumbers& result);

/// Domains of the basic regions that are there.
void add_domains(FoundDomains domains, Uniqueness& result);

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

/// The map, of this slice, has the aspects of solutions; without one none are known. Needs a live
/// `RoundingUpward`.
SolutionNumbers find_solution_numbers(const Manipulator& manipulator,
                                      std::shared_ptr<const SliceOfValues> values,
                                      std::shared_ptr<const AspectMap> map, const SeeStrip& see,
                                      const MapControl& control);

/// Numbers of solutions, basic regions and uniqueness domains of a slice of legs of any kind, but elbows,
/// with one joint held, whose map is there.
void find_regions_of_slice(const MapControl& control, Uniqueness& result);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_UNIQUENESS_SOLUTION_NUMBERS_H
