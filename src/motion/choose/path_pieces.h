// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_PIECES_H
#define PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_PIECES_H

#include "parallel_aspects/motion/check_trajectory.h"

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// The waypoint of a path at a share of the way from waypoint `segment` to the next.
PoseWaypoint waypoint_between(const std::vector<PoseWaypoint>& waypoints, std::size_t segment, double share);

/// The waypoints of a path with so many between them that there are `pieces` pieces or more, as even in each
/// segment.
std::vector<PoseWaypoint> divided_path(const std::vector<PoseWaypoint>& waypoints, std::size_t pieces);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MOTION_CHOOSE_PATH_PIECES_H
