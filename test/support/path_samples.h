// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_PATH_SAMPLES_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_PATH_SAMPLES_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/motion/check_trajectory.h"
#include "parallel_aspects/motion/plan_path.h"

#include "support/configuration_at.h"
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace parallel_aspects::test {

using Waypoints = std::vector<PoseWaypoint>;

/// To be pasted into a file that `aspects choose --path` reads.
inline std::string path_text(const Manipulator& robot, const Waypoints& path) {
  std::string result = robot.name();
  for (const PoseWaypoint& waypoint : path) {
    result += "\n" + std::to_string(waypoint.time);
    for (const double coordinate : pose_coordinates(robot.task_space(), waypoint.pose)) {
      char digits[40];
      std::snprintf(digits, sizeof digits, ", %.17g", coordinate);
      result += digits;
    }
  }
  return result;
}

/// The pose at a share of the way, by formulas of the tests.
inline Pose mixed_pose(const Pose& from, const Pose& to, double share) {
  Pose pose;
  pose.position = (1.0 - share) * from.position + share * to.position;
  const Eigen::Vector4d first = from.orientation.coeffs(), last = to.orientation.coeffs();
  pose.orientation.coeffs() =
      ((1.0 - share) * first + share * (first.dot(last) < 0.0 ? -last : last)).normalized();
  return pose;
}

/// +1 or -1 by det A where every leg reaches; 0 where one does not.
inline int side(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  const ConfigurationAt<long double> at(robot, pose, mode);
  return !at.reaches() ? 0 : at.parallel() > 0 ? 1 : -1;
}

inline const Aspect& random_aspect(const AspectMap& map, std::mt19937_64& random) {
  return map.aspects()[random() % map.aspects().size()];
}

/// The middle of a random inside leaf.
inline PathEnd random_path_end(const AspectMap& map, const Aspect& aspect, std::mt19937_64& random) {
  PathEnd end;
  end.mode = aspect.mode;
  std::size_t wanted = random() % aspect.inside_leaves;
  map.visit_inside_poses(aspect.id, [&](const Pose& pose, double) {
    if (wanted-- == 0) end.pose = pose;
  });
  return end;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_PATH_SAMPLES_H
