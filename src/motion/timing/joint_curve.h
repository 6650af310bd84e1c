// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_TIMING_JOINT_CURVE_H
#define PARALLEL_ASPECTS_MOTION_TIMING_JOINT_CURVE_H

#include "parallel_aspects/model/vectors.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// How fast actuated joints may move; one entry a leg, positive.
struct MotionLimits {
  JointVector velocity;      ///< [rad/s or m/s]
  JointVector acceleration;  ///< [rad/s^2 or m/s^2]
};

/// A curve of the actuated joints, at its knots: twice continuously differentiable in its parameter.
struct JointCurve {
  std::vector<double> parameter;    ///< rising; about the time that it takes at the velocity limits [s]
  std::vector<JointVector> value;   ///< [rad or m]
  std::vector<JointVector> slope;   ///< by the parameter
  std::vector<JointVector> second;  ///< derivative, likewise

  std::size_t size() const noexcept { return parameter.size(); }  ///< of knots
};

/// The time from one to the other at velocity limits, as the root of the sum of squares over the joints [s].
double chord(const JointVector& from, const JointVector& to, const JointVector& velocity_limits);

/// The cubic spline through values, at least one. Its parameter is the sum of chords. So it is regular
/// wherever the joints move, at a serial singularity too, where the pose is not. Values that are too near to
/// the one before to tell a direction are left out, not the first and last.
JointCurve spline_through(const std::vector<JointVector>& values, const JointVector& velocity_limits);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_TIMING_JOINT_CURVE_H
