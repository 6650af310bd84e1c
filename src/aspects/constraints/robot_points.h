// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_ROBOT_POINTS_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_ROBOT_POINTS_H

#include "aspects/constraints/constraint_tests.h"
#include "interval/scalar_range.h"
#include "legs/limit_verdict.h"
#include "legs/link_points.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// Where a robot is in one working mode, over some kind of enclosures.
template <class Scalar, std::size_t D>
struct RobotPoints {
  std::size_t leg_count = 0;
  std::array<LinkPoints<Scalar, D>, max_legs> legs;
  Point<Scalar, D> position;                 ///< of the operational point
  std::array<Point<Scalar, D>, D> rotation;  ///< rows of the rotation matrix of the platform

  /// A direction that is fixed in the platform.
  Point<Scalar, D> turned(const Point<Interval, D>& direction) const {
    Point<Scalar, D> result;
    for (std::size_t i = 0; i < D; ++i) {
      result[i] = direction[0] * rotation[i][0];
      for (std::size_t k = 1; k < D; ++k) result[i] = result[i] + direction[k] * rotation[i][k];
    }
    return result;
  }
};

/// What is proved of all constraints but the limits of actuated joints.
template <class Scalar, std::size_t D>
Verdict verdict(const ConstraintTests<D>& tests, const RobotPoints<Scalar, D>& robot) {
  Verdict result = both(tests.workspace(robot.position), tests.hinge_limits(robot));
  std::array<Point<Scalar, D>, max_legs> anchors;
  for (std::size_t j = 0; j < robot.leg_count && result != Verdict::fails; ++j) {
    anchors[j] = robot.legs[j].anchor;
    result = both(result, tests.passive_limits(j, robot.legs[j], robot));
    result = both(result, tests.cones(j, robot.legs[j], robot));
    if (tests.has_obstacles()) result = both(result, tests.obstacles(j, robot.legs[j]));
    for (std::size_t k = 0; k < j && result != Verdict::fails; ++k)
      if (tests.can_collide(k, j)) result = both(result, tests.collision(k, robot.legs[k], j, robot.legs[j]));
  }
  if (tests.has_platform() && result != Verdict::fails) result = both(result, tests.platform(anchors));
  return result;
}

/// A constraint that is proved to fail, but the limits of actuated joints; nothing where none is.
template <class Scalar, std::size_t D>
std::optional<ConstraintKind> find_failing(const ConstraintTests<D>& tests,
                                           const RobotPoints<Scalar, D>& robot) {
  const auto fails = [](Verdict verdict) { return verdict == Verdict::fails; };
  if (fails(tests.workspace(robot.position))) return ConstraintKind::workspace;
  if (fails(tests.hinge_limits(robot))) return ConstraintKind::passive_limits;
  std::array<Point<Scalar, D>, max_legs> anchors;
  for (std::size_t j = 0; j < robot.leg_count; ++j) {
    anchors[j] = robot.legs[j].anchor;
    if (fails(tests.passive_limits(j, robot.legs[j], robot))) return ConstraintKind::passive_limits;
    if (fails(tests.cones(j, robot.legs[j], robot))) return ConstraintKind::cones;
    if (tests.has_obstacles() && fails(tests.obstacles(j, robot.legs[j]))) return ConstraintKind::obstacles;
    for (std::size_t k = 0; k < j; ++k)
      if (tests.can_collide(k, j) && fails(tests.collision(k, robot.legs[k], j, robot.legs[j])))
        return ConstraintKind::self_collision;
  }
  if (tests.has_platform() && fails(tests.platform(anchors))) return ConstraintKind::obstacles;
  return std::nullopt;
}

/// Every enclosure at the middle.
template <class Scalar, std::size_t D>
Point<Interval, D> at_center(const Point<Scalar, D>& point) {
  Point<Interval, D> result;
  for (std::size_t i = 0; i < D; ++i) result[i] = center_of(point[i]);
  return result;
}

template <class Scalar, std::size_t D>
RobotPoints<Interval, D> at_center(const RobotPoints<Scalar, D>& robot) {
  RobotPoints<Interval, D> result;
  result.leg_count = robot.leg_count;
  for (std::size_t j = 0; j < robot.leg_count; ++j)
    result.legs[j] = {at_center(robot.legs[j].base), at_center(robot.legs[j].joint),
                      at_center(robot.legs[j].anchor), center_of(robot.legs[j].length)};
  result.position = at_center(robot.position);
  for (std::size_t i = 0; i < D; ++i) result.rotation[i] = at_center(robot.rotation[i]);
  return result;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_ROBOT_POINTS_H
