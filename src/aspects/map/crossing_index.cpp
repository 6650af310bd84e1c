// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/crossing_index.h"

#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

/// How far the actuated joints are from their limits, over half of their range; 1 without limits.
double room_to_limits(const Manipulator& robot, const JointVector& q) {
  double room = 1.0;
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const JointLimits& limits = robot.leg(j).limits;
    const double value = q[static_cast<Eigen::Index>(j)], half = 0.5 * (limits.upper - limits.lower);
    if (std::isfinite(half))
      room = std::min({room, (value - limits.lower) / half, (limits.upper - value) / half});
  }
  return room;
}

}  // namespace

double crossing_index(const Manipulator& robot, const Pose& pose, const WorkingMode& mode, Crossing crossing,
                      std::size_t leg) {
  const InverseSolution solution = inverse(robot, pose, mode);
  if (solution.status != InverseStatus::solved) return -1.0;
  TaskVector entries = serial_indices(robot, pose, solution.q);
  const double room = room_to_limits(robot, solution.q);
  if (crossing == Crossing::parallel) return std::min(room, entries.minCoeff());
  entries[static_cast<Eigen::Index>(leg)] = 1.0;
  return std::min({room, parallel_index(robot, pose, solution.q), entries.minCoeff()});
}

}  // namespace parallel_aspects
