// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_CAMPAIGN_FIGURES_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_CAMPAIGN_FIGURES_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/motion/plan_path.h"

#include "support/configuration_at.h"
#include "support/path_samples.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <limits>
#include <vector>

namespace parallel_aspects::test {

/// Of the processor, so that other work on the machine counts nothing.
class Stopwatch {
 public:
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Of a path [m], rotations times the characteristic length.
inline double path_length(const Manipulator& robot, const PlannedPath& path) {
  return path.length + robot.characteristic_length() * path.turned;
}

/// Whether control of the platform is lost on the segment behind this point.
inline bool crosses_parallel(const PlannedPath& path, std::size_t point) {
  return std::any_of(path.crossings.begin(), path.crossings.end(), [point](const PathCrossing& crossing) {
    return crossing.kind == Crossing::parallel && crossing.point <= point && point < crossing.behind;
  });
}

/// How many samples of a path contradict it, by formulas of the tests; segments run as `pose_between` says.
/// Segments through parallel crossings are left out; the sign of det A is the other one behind.
inline int contradictions(const Manipulator& robot, const PlannedPath& path, int samples) {
  constexpr double rounding = 1e-9;
  int count = 0;
  double sign = 0.0;
  const int each = 1 + samples / std::max(1, static_cast<int>(path.points.size()) - 1);
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    if (crosses_parallel(path, i)) {
      if (i == 0 || !crosses_parallel(path, i - 1)) sign = -sign;
      continue;
    }
    for (int k = 0; k <= each; ++k) {
      const Pose pose = mixed_pose(path.points[i].pose, path.points[i + 1].pose, k / double(each));
      const ConfigurationAt<double> at(robot, pose, path.points[i].mode);
      const double index = at.parallel();
      if (sign == 0.0) sign = index > 0.0 ? 1.0 : -1.0;
      count += at.squared_serial() < -rounding || at.within_limits() < -rounding || index * sign < -rounding;
    }
  }
  return count;
}

/// Five times the velocity limits a second; empty where a joint has none.
inline JointVector usual_accelerations(const Manipulator& robot) {
  JointVector accelerations(static_cast<Eigen::Index>(robot.leg_count()));
  for (std::size_t j = 0; j < robot.leg_count(); ++j)
    accelerations[static_cast<Eigen::Index>(j)] = 5.0 * robot.leg(j).limits.velocity;
  return problems_of(robot, accelerations).empty() ? accelerations : JointVector();
}

/// How much of its limits the fastest and the sharpest joint takes, 1 for all of it. Between two points the
/// joints run as cubics: the velocity is a parabola, the acceleration straight, so that the ends and the
/// vertex tell the largest at all times.
inline double limits_taken(const Manipulator& robot, const std::vector<JointWaypoint>& waypoints,
                           const JointVector& accelerations) {
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i)
    for (Eigen::Index j = 0; j < accelerations.size(); ++j) {
      const JointWaypoint &from = waypoints[i], &to = waypoints[i + 1];
      const double h = to.time - from.time, rise = (to.q[j] - from.q[j]) / h, v0 = from.velocity[j],
                   v1 = to.velocity[j];
      const double a0 = (6.0 * rise - 4.0 * v0 - 2.0 * v1) / h, a1 = (2.0 * v0 + 4.0 * v1 - 6.0 * rise) / h;
      double fastest = std::max(std::abs(v0), std::abs(v1));
      const double vertex = a0 / (a0 - a1);
      if (vertex > 0.0 && vertex < 1.0)
        fastest = std::max(fastest, std::abs(v0 + h * (a0 * vertex + 0.5 * (a1 - a0) * vertex * vertex)));
      most = std::max({most, fastest / robot.leg(static_cast<std::size_t>(j)).limits.velocity,
                       std::max(std::abs(a0), std::abs(a1)) / accelerations[j]});
    }
  return most;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_CAMPAIGN_FIGURES_H
