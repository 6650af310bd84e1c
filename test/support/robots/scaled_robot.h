// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_SCALED_ROBOT_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_SCALED_ROBOT_H

#include "parallel_aspects/model/manipulator.h"

#include <memory>
#include <variant>

namespace parallel_aspects::test {

inline JointLimits scaled(JointLimits limits, double factor) {
  limits.lower *= factor;
  limits.upper *= factor;
  limits.velocity *= factor;
  return limits;
}

inline Leg scaled(Leg leg, double factor) {
  leg.anchor *= factor;
  leg.rod_length *= factor;
  if (auto* revolute = std::get_if<RevoluteActuation>(&leg.actuation)) {
    revolute->center *= factor;
    revolute->radius *= factor;
  } else if (auto* rail = std::get_if<PrismaticActuation>(&leg.actuation)) {
    rail->origin *= factor;
    leg.limits = scaled(leg.limits, factor);
  } else if (auto* strut = std::get_if<StrutActuation>(&leg.actuation)) {
    strut->base *= factor;
    strut->length_at_zero *= factor;
    leg.limits = scaled(leg.limits, factor);
  } else if (auto* elbow = std::get_if<ElbowActuation>(&leg.actuation)) {
    elbow->base *= factor;
    elbow->inner_length *= factor;
    elbow->outer_length *= factor;
  }
  return leg;
}

inline Constraints scaled(Constraints constraints, double factor) {
  constraints.thickness.crank *= factor;
  constraints.thickness.rod *= factor;
  if (constraints.thickness.platform) *constraints.thickness.platform *= factor;
  for (Obstacle& obstacle : constraints.obstacles)
    if (auto* ball = std::get_if<BallObstacle>(&obstacle.shape)) {
      ball->center *= factor;
      ball->radius *= factor;
    } else if (auto* box = std::get_if<BoxObstacle>(&obstacle.shape)) {
      box->center *= factor;
      box->half_size *= factor;
    }
  if (constraints.workspace) {
    constraints.workspace->lower *= factor;
    constraints.workspace->upper *= factor;
  }
  return constraints;
}

/// The same robot in another unit of length: every length is `factor` times as long.
inline std::shared_ptr<const Manipulator> scaled(const Manipulator& robot, double factor) {
  ManipulatorDescription description = robot.description();
  for (Leg& leg : description.legs) leg = scaled(leg, factor);
  description.constraints = scaled(description.constraints, factor);
  return std::make_shared<const Manipulator>(description);
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_SCALED_ROBOT_H
