// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_MOTION_CHOOSE_CUSP_PATHS_H
#define PARALLEL_ASPECTS_TEST_MOTION_CHOOSE_CUSP_PATHS_H

#include "motion/choose/plan_around_cusp.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace parallel_aspects::test {

/// Actuated values along a path, which stop at each of its points without a jerk: a step that differs from
/// the last one counts as a bend.
inline std::vector<JointVector> values_along(const Manipulator& robot, const CuspPlanner& planner,
                                             const PlannedPath& path, int steps) {
  std::vector<JointVector> values;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int k = 0; k <= steps; ++k) {
      const double share = 0.5 - 0.5 * std::cos(EIGEN_PI * k / steps);
      const Pose pose = planner.between(path.points[i].pose, path.points[i + 1].pose, share);
      values.push_back(inverse(robot, pose, path.points[i].mode).q);
    }
  return values;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_MOTION_CHOOSE_CUSP_PATHS_H
