// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_PLATFORM_STEP_H
#define PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_PLATFORM_STEP_H

#include "kinematics/homotopy/complex_lanes.h"
#include "kinematics/homotopy/platform_paths.h"

namespace parallel_aspects::platform_paths {

/// `lanes::count` paths of one homotopy, each at its own t and with its own next step.
struct Lanes {
  lanes::Complex solution[8];
  lanes::Real t;
  lanes::Real step;
};

/// Where a step leads: the point at t + step, and how far two corrections by Newton's method moved it,
/// relative to the point. The first is the error of the prediction; the second tells whether the corrections
/// converge.
struct Attempt {
  lanes::Complex solution[8];
  lanes::Real first_correction;
  lanes::Real second_correction;
};

/// Tries one step in every lane: Runge-Kutta of order 4 along the path, then two corrections.
void attempt(const ParameterPath& path, const Lanes& from, Attempt& result);

}  // namespace parallel_aspects::platform_paths

#endif  // PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_PLATFORM_STEP_H
