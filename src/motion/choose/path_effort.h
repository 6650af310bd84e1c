// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_EFFORT_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_EFFORT_H

#include "parallel_aspects/motion/check_trajectory.h"

#include <vector>

namespace parallel_aspects {

/// What the actuated joints do along a path, from samples.
struct PathEffort {
  std::vector<double> travel;  ///< of each [rad or m]
  double least_time = 0.0;     ///< at the velocity limits [s]
};

/// For ordering: safe ones come first, then unknown ones.
int rank(TrajectoryAnswer answer) noexcept;

/// The path must be safe in this mode.
PathEffort effort_of(const Manipulator& manipulator, const std::vector<PoseWaypoint>& waypoints,
                     const WorkingMode& mode);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_EFFORT_H
