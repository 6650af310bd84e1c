// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/nearest_singularity.h"

#include "draw/scene/workspace_bodies.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr int pieces = 24;  // of a way: rotations bend it

Pose between(const Pose& from, const Pose& to, double share) {
  Pose pose;
  pose.position = from.position + share * (to.position - from.position);
  pose.orientation = from.orientation.slerp(share, to.orientation);
  return pose;
}

// A piece that would go across the picture, from an angle to the same one a turn on, is left out.
void add_way(const std::function<Vector3d(const Pose&)>& point, const Pose& from, const Pose& to,
             double longest, NearestSingularity& nearest) {
  Vector3d last = point(from);
  for (int i = 1; i <= pieces; ++i) {
    const Vector3d next = point(between(from, to, static_cast<double>(i) / pieces));
    if ((next - last).norm() < longest) nearest.way.insert(nearest.way.end(), {last, next});
    last = next;
  }
  nearest.ends.push_back(last);
}

}  // namespace

std::optional<NearestSingularity> nearest_singularity(const Manipulator& robot, const Pose& present,
                                                      const BoundaryDistances& distances, double radian) {
  const bool is_parallel = distances.parallel.upper <= distances.serial.upper;
  const BoundaryDistance& found = is_parallel ? distances.parallel : distances.serial;
  if (!std::isfinite(found.upper)) return std::nullopt;
  NearestSingularity nearest;
  nearest.kind = is_parallel ? BoundaryKind::parallel : BoundaryKind::serial;
  nearest.distance = found.upper;
  nearest.pose = found.witness;
  const TaskSpace space = robot.task_space();
  if (space == TaskSpace::SE3) {
    for (const Leg& leg : robot.legs())
      add_way([&leg](const Pose& pose) { return pose.transform(leg.anchor); }, present, found.witness,
              robot.size(), nearest);
    return nearest;
  }
  const bool wraps = has_rotation(space);
  const double longest = wraps ? EIGEN_PI * radian : std::numeric_limits<double>::infinity();
  add_way([&robot, radian](const Pose& pose) { return drawn_point(robot, pose, radian); }, present,
          found.witness, longest, nearest);
  return nearest;
}

std::string words_of(const NearestSingularity& nearest, DistanceUnit unit) {
  return std::string("nearest singularity found: ") +
         (nearest.kind == BoundaryKind::parallel ? "parallel, " : "serial, ") +
         unit.text(nearest.distance, 3);
}

}  // namespace parallel_aspects
