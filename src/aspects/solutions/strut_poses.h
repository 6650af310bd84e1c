// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_POSES_H
#define PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_POSES_H

#include "aspects/cusps/strut_slice.h"
#include "parallel_aspects/aspects/box.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_ASPECTS_SOLUTIONS_STRUT_POSES_H
