// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_MEASURES_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_MEASURES_H

#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// The waypoint of a path at a share of the way from waypoint `segment` to the next.
PoseWaypoint waypoint_between(const Motions& motions, const std::vector<PoseWaypoint>& waypoints,
                              std::size_t segment, double share);

/// The waypoints of a path with so many between them that there are `pieces` pieces or more, as even in each
/// segment.
std::vector<PoseWaypoint> divided_path(const Motions& motions, const std::vector<PoseWaypoint>& waypoints,
                                       std::size_t pieces);

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

/// Measures a path, where it comes near a singularity more densely, until the bound is within 5 % of the
/// least measured distance or `measures` are used up. The path must be safe in this mode.
///
/// Between two poses that are L apart along the path the distance is at least half of (the sum of theirs less
/// L), as it changes by no more than the robot moves.
PathClearance measure_clearance(BoundaryDistanceMeter& meter, const Manipulator& manipulator,
                                const std::vector<PoseWaypoint>& waypoints, const WorkingMode& mode,
                                int measures, const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_MEASURES_H
