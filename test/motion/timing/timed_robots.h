// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_MOTION_TIMING_TIMED_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_MOTION_TIMING_TIMED_ROBOTS_H

#include "parallel_aspects/motion/plan_path.h"

#include "support/robots/robots.h"
#include "support/slices.h"
#include <memory>
#include <vector>

namespace parallel_aspects::test {

using JointWaypoints = std::vector<JointWaypoint>;

/// The robot with velocity limits: 2 rad/s, or half its size in a second.
inline Robot with_speeds(const Robot& robot) {
  ManipulatorDescription description = robot->description();
  for (Leg& leg : description.legs) leg.limits.velocity = leg.actuated_by_angle() ? 2.0 : 0.5 * robot->size();
  return std::make_shared<const Manipulator>(description);
}

inline JointVector speeds_of(const Manipulator& robot) {
  JointVector speeds(static_cast<Eigen::Index>(robot.leg_count()));
  for (std::size_t j = 0; j < robot.leg_count(); ++j)
    speeds[static_cast<Eigen::Index>(j)] = robot.leg(j).limits.velocity;
  return speeds;
}

inline JointVector accelerations_of(const Manipulator& robot) { return 5.0 * speeds_of(robot); }

/// What joint_trajectory_controller runs between two points with velocities, by Hermite's basis.
struct Motion {
  JointVector q, velocity, acceleration;
};

inline Motion between(const JointWaypoint& from, const JointWaypoint& to, double s) {
  const double duration = to.time - from.time;
  const JointVector v0 = from.velocity * duration, v1 = to.velocity * duration;
  const double s2 = s * s, s3 = s2 * s;
  Motion motion;
  motion.q = (2.0 * s3 - 3.0 * s2 + 1.0) * from.q + (s3 - 2.0 * s2 + s) * v0 + (3.0 * s2 - 2.0 * s3) * to.q +
             (s3 - s2) * v1;
  motion.velocity =
      ((6.0 * s2 - 6.0 * s) * (from.q - to.q) + (3.0 * s2 - 4.0 * s + 1.0) * v0 + (3.0 * s2 - 2.0 * s) * v1) /
      duration;
  motion.acceleration = ((12.0 * s - 6.0) * (from.q - to.q) + (6.0 * s - 4.0) * v0 + (6.0 * s - 2.0) * v1) /
                        (duration * duration);
  return motion;
}
}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_MOTION_TIMING_TIMED_ROBOTS_H
