// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_CONSTRAINED_ROBOTS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_CONSTRAINED_ROBOTS_H

#include "parallel_aspects/model/manipulator.h"

#include <memory>

namespace parallel_aspects::test {

using Robot = std::shared_ptr<const Manipulator>;

/// The robot with these constraints in place of its own.
inline Robot with(const Robot& robot, const Constraints& constraints) {
  ManipulatorDescription description = robot->description();
  description.constraints = constraints;
  return std::make_shared<const Manipulator>(description);
}

/// Every kind at once: on bodies as thick as a share of the robot, and around a reachable pose.
inline Constraints all_kinds(const Robot& robot, double thickness) {
  const double size = robot->size();
  Constraints result;
  result.thickness = {thickness * size, 0.7 * thickness * size, 0.5 * thickness * size};
  result.self_collision.emplace();
  const Eigen::Vector3d aside = is_planar(robot->task_space()) ? Eigen::Vector3d(0.1, 0.2, 0.0) * size
                                                               : Eigen::Vector3d(0.1, 0.05, -0.3) * size;
  result.obstacles.push_back({"ball", BallObstacle{aside, 0.03 * size}});
  const Eigen::Vector3d axis =
      is_planar(robot->task_space()) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(1.0, 2.0, 3.0).normalized();
  result.obstacles.push_back({"box", BoxObstacle{-aside, Eigen::Quaterniond(Eigen::AngleAxisd(0.4, axis)),
                                                 Eigen::Vector3d(0.05, 0.02, 0.04) * size}});
  result.workspace =
      WorkspaceBox{Eigen::Vector3d::Constant(-0.6 * size), Eigen::Vector3d::Constant(0.55 * size)};
  result.margins = {0.1, 0.15, 0.0};
  const bool planar = is_planar(robot->task_space());
  const bool crank = robot->leg(1).kind().has_crank;
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ(), across = Eigen::Vector3d::UnitY();
  result.cones.push_back(
      {0, LegEnd::platform, planar ? Eigen::Vector3d(-0.6, -0.8, 0.0) : down, planar ? 2.7 : 0.8});
  result.cones.push_back({1, LegEnd::base, crank ? Eigen::Vector3d::UnitX() : planar ? across : down, 2.6});
  if (!planar) return result;
  result.passive_limits.push_back({"first", 0, crank ? PassiveAngle::crank_to_rod : PassiveAngle::base_to_rod,
                                   0.3, -1.0, JointLimits{-2.9, 2.4}});
  result.passive_limits.push_back(
      {"last", 1, PassiveAngle::rod_to_platform, -0.2, 1.0, JointLimits{0.5, 3.0}});
  return result;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_CONSTRAINED_ROBOTS_H
