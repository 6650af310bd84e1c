// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/map_location.h"
#include "motion/choose/path_clearance.h"
#include "motion/choose/path_pieces.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr int measures = 400;

/// The poses of a path, a second apart.
std::vector<PoseWaypoint> timed(const std::vector<Pose>& path) {
  std::vector<PoseWaypoint> waypoints;
  waypoints.reserve(path.size());
  for (const Pose& pose : path) waypoints.push_back({static_cast<double>(waypoints.size()), pose});
  return waypoints;
}

Pose pose_at(const std::vector<PoseWaypoint>& waypoints, double time) {
  const auto segment = std::min(static_cast<std::size_t>(time), waypoints.size() - 2);
  return waypoint_between(waypoints, segment, time - static_cast<double>(segment)).pose;
}

}  // namespace

void ask_map(const AspectMap& map, const PoseInMode& first, const PoseInMode& second,
             AspectComparison& comparison) {
  const Location start = map.locate(first.pose, first.mode), end = map.locate(second.pose, second.mode);
  if (!start || !end) return;
  if (start.aspect == end.aspect)
    comparison = {SameAspect::yes, "The map proves it: both are in the same connected set of boxes.", {}, 0};
  else if (!may_be_one(map, start.aspect, end.aspect))
    comparison = {SameAspect::no, "The map proves the two aspects separate.", {}, 0};
}

PathMeasure measure_path(const std::shared_ptr<const Manipulator>& manipulator,
                         const std::vector<Pose>& poses, const WorkingMode& mode) {
  const std::vector<PoseWaypoint> path = timed(poses);
  BoundaryDistanceMeter meter(manipulator);
  PathMeasure result;
  result.clearance = measure_clearance(meter, *manipulator, path, mode, measures);
  result.narrowest = pose_at(path, result.clearance.time);
  return result;
}

}  // namespace parallel_aspects
