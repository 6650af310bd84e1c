// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROUND_TRIP_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROUND_TRIP_H

#include "parallel_aspects/kinematics/kinematics.h"

#include "support/robots/random_robots.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace parallel_aspects::test {

/// What became of poses -> actuated joints -> all direct solutions.
struct RoundTrips {
  int made = 0;
  int missed = 0;    ///< solved, but the pose was not among the solutions
  int unsolved = 0;  ///< said so
  int continuum = 0;
  std::size_t max_solutions = 0;
  double worst_residual = 0.0;
  std::string first_miss;  ///< as C++ literals
};

/// Distance of two poses relative to the robot: the larger of displacement and turn [rad].
inline double pose_distance(const Manipulator& robot, const Pose& a, const Pose& b) {
  return std::max((a.position - b.position).norm() / robot.size(),
                  a.orientation.angularDistance(b.orientation));
}

inline const AssemblyMode* closest(const Manipulator& robot, const DirectResult& result, const Pose& pose) {
  const AssemblyMode* best = nullptr;
  double distance = std::numeric_limits<double>::infinity();
  for (const AssemblyMode& mode : result.solutions) {
    if (pose_distance(robot, mode.pose, pose) >= distance) continue;
    distance = pose_distance(robot, mode.pose, pose);
    best = &mode;
  }
  return best;
}

inline std::string describe(const Manipulator& robot, const Pose& pose, const JointVector& q) {
  std::ostringstream text;
  text.precision(17);
  text << robot.name() << " at " << to_string(robot.task_space(), pose) << ", q << " << q.transpose() << ";";
  return text.str();
}

inline void count_round_trip(const Manipulator& robot, const Pose& pose, const JointVector& q,
                             RoundTrips& trips) {
  const DirectResult result = direct(robot, q);
  ++trips.made;
  trips.max_solutions = std::max(trips.max_solutions, result.solutions.size());
  for (const AssemblyMode& mode : result.solutions)
    trips.worst_residual = std::max(trips.worst_residual, mode.residual);
  const AssemblyMode* found = closest(robot, result, pose);
  if (result.status == DirectStatus::unsolved) ++trips.unsolved;
  if (result.status == DirectStatus::continuum) ++trips.continuum;
  const bool hit =
      found != nullptr && pose_distance(robot, found->pose, pose) < (found->near_singular ? 1e-5 : 1e-8);
  if (hit || result.status == DirectStatus::continuum) return;
  if (result.status == DirectStatus::solved) ++trips.missed;
  if (trips.first_miss.empty()) trips.first_miss = describe(robot, pose, q);
}

/// Random poses around `home` until `count` round trips were made, each in a random working mode that can
/// reach.
inline RoundTrips round_trips(const Manipulator& robot, const Pose& home, double spread, int count,
                              unsigned seed) {
  RandomRobots random(seed);
  RoundTrips trips;
  for (int tries = 0; trips.made < count && tries < 100 * count; ++tries) {
    Pose pose = random.pose(robot.motions(), spread);
    if (has_translation(robot.task_space())) pose.position += home.position;
    const auto modes = working_modes(robot);
    const auto pick = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(modes.size())));
    const InverseSolution solution = inverse(robot, pose, modes[std::min(pick, modes.size() - 1)]);
    if (solution.status != InverseStatus::out_of_reach) count_round_trip(robot, pose, solution.q, trips);
  }
  return trips;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROUND_TRIP_H
