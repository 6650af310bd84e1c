// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_CLEARANCE_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_CLEARANCE_H

#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <vector>

namespace parallel_aspects {

/// Measures a path, where it comes near a singularity more densely, until the bound is within 5 % of the
/// least measured distance or `measures` are used up. The path must be safe in this mode.
///
/// Between two poses of the path that are L apart along it the distance is nowhere below half of the sum of
/// theirs less L, as it changes by no more than the robot moves.
PathClearance measure_clearance(BoundaryDistanceMeter& meter, const Manipulator& manipulator,
                                const std::vector<PoseWaypoint>& waypoints, const WorkingMode& mode,
                                int measures, const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_CLEARANCE_H
