// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_JOINT_RANGES_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_JOINT_RANGES_H

#include "aspects/cusps/held_slice.h"
#include "aspects/enclosures/singular_images.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <string>

namespace parallel_aspects {

/// The values of both joints that move while the third is held: within limits, each angle once, and of
/// lengths no more than the slice has.
class JointRanges {
 public:
  /// Needs a live `RoundingUpward`.
  JointRanges(const Manipulator& manipulator, const HeldJoint& held, const HeldSlice& slice);

  /// Coordinates are joints, in order [m or rad].
  const Box& values() const noexcept { return values_; }

  const std::array<bool, 2>& are_angles() const noexcept { return are_angles_; }

  /// Whether all angles are values of the joint, so that the last are the first.
  const std::array<bool, 2>& are_periodic() const noexcept { return are_periodic_; }

  /// Whether values of joint i, angles to whole turns, may be among them.
  bool may_hold(std::size_t i, const Interval& values) const noexcept;

  /// "rad^2", "m^2" or "m rad".
  std::string unit() const;

  /// Both values of all actuated joints, angles moved by whole turns to where they are in the range if they
  /// can be.
  std::array<double, 2> values_of(const JointVector& actuated) const noexcept;

  /// All actuated joints, with that which is held.
  JointVector actuated(const std::array<double, 2>& values) const;

 private:
  HeldJoint held_;
  std::array<std::size_t, 2> legs_{};
  std::array<bool, 2> are_angles_{}, are_periodic_{};
  Box values_{2, {}, {}};
};

/// The values of all joints of a robot of three legs whose slides and struts have limits on both sides.
ValueSpace value_space_of(const Manipulator& manipulator);

/// Actuated values as such a space has them, angles moved by whole turns to where they are in it if they can
/// be.
std::array<double, 3> values_in(const ValueSpace& space, const JointVector& actuated) noexcept;

/// "rad^3", "m^3", "m^2 rad" or "m rad^2".
std::string unit_of(const ValueSpace& space);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_JOINT_RANGES_H
