// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/path_pieces.h"

namespace parallel_aspects {

PoseWaypoint waypoint_between(const std::vector<PoseWaypoint>& waypoints, std::size_t segment, double share) {
  const PoseWaypoint &from = waypoints[segment], &to = waypoints[segment + 1];
  return {from.time + share * (to.time - from.time), pose_between(from.pose, to.pose, share)};
}

std::vector<PoseWaypoint> divided_path(const std::vector<PoseWaypoint>& waypoints, std::size_t pieces) {
  std::vector<PoseWaypoint> divided;
  const std::size_t segments = waypoints.size() - 1;
  for (std::size_t i = 0; i < segments; ++i) {
    const std::size_t parts = 1 + (pieces - 1) / segments;
    divided.push_back(waypoints[i]);
    for (std::size_t k = 1; k < parts; ++k)
      divided.push_back(waypoint_between(waypoints, i, static_cast<double>(k) / static_cast<double>(parts)));
  }
  divided.push_back(waypoints.back());
  return divided;
}

}  // namespace parallel_aspects
