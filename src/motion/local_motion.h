// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_LOCAL_MOTION_H
#define PARALLEL_ASPECTS_MOTION_LOCAL_MOTION_H

#include "parallel_aspects/kinematics/working_mode.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/vectors.h"

#include <functional>
#include <vector>

namespace parallel_aspects {

/// Whether a motion may pass through this configuration, beyond what the manipulator itself demands.
using ConfigurationFilter = std::function<bool(const Pose&, const JointVector&)>;

/// The largest amplitude of a local motion: of positions over the robot's size, half of it in rad.
inline constexpr double widest_local_motion = 0.4;

/// And the smallest.
inline constexpr double narrowest_local_motion = 2e-3;

/// A smooth round of the platform about a pose, through all degrees of freedom at once, that needs no map: a
/// Lissajous figure as large as stays clear of singularities, in one working mode, within joint limits, its
/// amplitude `widest` at most. Every
/// piece is certified by continuation, so det A keeps its sign.
///
/// Corners of the actuated joints, the first again at the end; actuated joints move straight between [rad or
/// m]. Empty where `mode` does not reach the pose or not even a small figure passes.
std::vector<JointVector> plan_local_motion(const Manipulator& manipulator, const Pose& pose,
                                           const WorkingMode& mode, const ConfigurationFilter& allowed,
                                           double widest = widest_local_motion);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_LOCAL_MOTION_H
