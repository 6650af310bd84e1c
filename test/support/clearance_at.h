// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_CLEARANCE_AT_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_CLEARANCE_AT_H

#include "model/linear_algebra.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Dense>

#include "support/index_at.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace parallel_aspects::test {

/// A second way to the constraints, in plain double precision: how far a configuration is from breaking one
/// of them, negative where one is broken [m or rad]. Limits of actuated joints are left out.
class ClearanceAt {
 public:
  ClearanceAt(const Manipulator& robot, const Pose& pose, const JointVector& q)
      : robot_(robot), constraints_(robot.constraints()), pose_(pose), q_(q) {}

  double of_all() const {
    return std::min(
        {of_workspace(), of_passive_joints(), of_cones(), of_self_collision(), of_obstacles(), of_margins()});
  }

  /// No unit: of indices.
  double of_margins() const {
    const Margins& margins = constraints_.margins;
    const IndexAt at(robot_, pose_, q_);
    const auto parallel = static_cast<double>(at.parallel()), serial = static_cast<double>(at.serial());
    return std::min(margins.parallel > 0.0 ? parallel - margins.parallel : infinity,
                    margins.serial > 0.0 ? serial - margins.serial : infinity);
  }

  double of_workspace() const {
    double least = infinity;
    if (!constraints_.workspace) return least;
    for (std::size_t i = 0; i < directions(robot_.task_space()); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      least = std::min({least, pose_.position[row] - constraints_.workspace->lower[row],
                        constraints_.workspace->upper[row] - pose_.position[row]});
    }
    return least;
  }

  double of_passive_joints() const {
    double least = infinity;
    for (const PassiveLimit& limit : constraints_.passive_limits) {
      const double middle = 0.5 * (limit.limits.lower + limit.limits.upper);
      const double off = std::remainder(passive_value(limit) - middle, 2.0 * EIGEN_PI);
      least = std::min(least, 0.5 * (limit.limits.upper - limit.limits.lower) - std::abs(off));
    }
    for (const PassiveCone& limit : constraints_.passive_cones) least = std::min(least, in_cone(limit.cone));
    return least;
  }

  /// How much farther the rods may lean [rad].
  double of_cones() const {
    double least = infinity;
    for (const BallJointCone& cone : constraints_.cones) least = std::min(least, in_cone(cone));
    return least;
  }

  double of_self_collision() const {
    double least = infinity;
    if (!constraints_.self_collision) return least;
    for (std::size_t i = 0; i < robot_.leg_count(); ++i)
      for (std::size_t j = i + 1; j < robot_.leg_count(); ++j)
        for (const Body& one : links(i))
          for (const Body& other : links(j))
            if (!joined(one, other)) least = std::min(least, between(one, other) - one.radius - other.radius);
    return least;
  }

  double of_obstacles() const {
    double least = infinity;
    std::vector<Body> bodies;
    for (std::size_t j = 0; j < robot_.leg_count(); ++j)
      for (const Body& body : links(j)) bodies.push_back(body);
    const std::size_t legs = robot_.leg_count();
    if (constraints_.thickness.platform)
      for (std::size_t j = 0; j < (legs > 2 ? legs : legs - 1); ++j)
        bodies.push_back({anchor(j), anchor((j + 1) % legs), 0.5 * *constraints_.thickness.platform, 0, 0});
    for (const Obstacle& obstacle : constraints_.obstacles)
      for (const Body& body : bodies)
        least =
            std::min(least, std::visit([&](const auto& shape) { return from(body, shape); }, obstacle.shape));
    return least;
  }

  /// The rod, turned into what holds the ball joint at this end [m].
  Eigen::Vector3d seen_rod(std::size_t leg, LegEnd end) const {
    const Eigen::Vector3d rod = anchor(leg) - joint(leg);
    if (end == LegEnd::platform) return pose_.orientation.conjugate() * rod;
    const RevoluteActuation* crank = robot_.leg(leg).crank();
    if (crank == nullptr) return rod;
    Eigen::Matrix3d axes;
    axes << crank->zero_direction, crank->axis.cross(crank->zero_direction), crank->axis;
    return axes.transpose() * (Eigen::AngleAxisd(-q_[static_cast<Eigen::Index>(leg)], crank->axis) * rod);
  }

 private:
  struct Body {
    Eigen::Vector3d from, to;
    double radius;
    std::size_t leg;
    int kind;  // 0 for a crank, 1 for a rod
  };
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Eigen::Vector3d anchor(std::size_t j) const { return pose_.transform(robot_.leg(j).anchor); }
  Eigen::Vector3d joint(std::size_t j) const {
    return robot_.leg(j).proximal_point(q_[static_cast<Eigen::Index>(j)]);
  }

  double in_cone(const BallJointCone& cone) const {
    const Eigen::Vector3d rod = seen_rod(cone.leg, cone.end);
    return cone.angle - std::acos(std::clamp(rod.normalized().dot(cone.axis.normalized()), -1.0, 1.0));
  }

  std::vector<Body> links(std::size_t j) const {
    std::vector<Body> bodies{{joint(j), anchor(j), 0.5 * constraints_.thickness.rod, j, 1}};
    if (const RevoluteActuation* crank = robot_.leg(j).crank())
      bodies.push_back({crank->center, joint(j), 0.5 * constraints_.thickness.crank, j, 0});
    return bodies;
  }

  bool joined(const Body& a, const Body& b) const {
    const auto ignored = [&](const auto& pair) {
      const auto is = [](const LinkName& link, const Body& body) {
        return link.leg == body.leg && (link.kind == LinkKind::rod) == (body.kind == 1);
      };
      return (is(pair[0], a) && is(pair[1], b)) || (is(pair[0], b) && is(pair[1], a));
    };
    const auto& pairs = constraints_.self_collision->ignored;
    if (std::any_of(pairs.begin(), pairs.end(), ignored)) return true;
    return a.kind == b.kind &&
           (a.kind == 1 ? (robot_.leg(a.leg).anchor - robot_.leg(b.leg).anchor).norm() < 1e-9
                        : (a.from - b.from).norm() < 1e-9);
  }

  double passive_value(const PassiveLimit& limit) const {
    const Eigen::Vector3d rod = anchor(limit.leg) - joint(limit.leg);
    const double rod_angle = std::atan2(rod.y(), rod.x());
    const Eigen::Vector3d x = pose_.orientation * Eigen::Vector3d::UnitX();
    double angle = rod_angle;
    if (limit.angle == PassiveAngle::rod_to_platform) angle = std::atan2(x.y(), x.x()) - rod_angle;
    if (limit.angle == PassiveAngle::crank_to_rod) {
      const Eigen::Vector3d crank = joint(limit.leg) - robot_.leg(limit.leg).base_point();
      angle = rod_angle - std::atan2(crank.y(), crank.x());
    }
    return limit.sense * (angle - limit.offset);
  }

  static double to_segment(const Eigen::Vector3d& point, const Body& body) {
    const Eigen::Vector3d along = body.to - body.from;
    const double share = std::clamp((point - body.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (point - body.from - share * along).norm();
  }

  // Negative where they cross in the plane: then less the shortest path from an end to the other segment.
  double between(const Body& a, const Body& b) const {
    const double ends =
        std::min({to_segment(a.from, b), to_segment(a.to, b), to_segment(b.from, a), to_segment(b.to, a)});
    Eigen::Matrix<double, 3, 2> directions;
    directions << a.to - a.from, b.from - b.to;
    const Eigen::Vector2d shares = least_squares_solution(directions, b.from - a.from, 1e-15);
    if (!(shares.minCoeff() > 0.0 && shares.maxCoeff() < 1.0)) return ends;
    const double distance = (a.from - b.from + directions * shares).norm();
    return is_planar(robot_.task_space()) ? -ends : std::min(ends, distance);
  }

  static double from(const Body& body, const BallObstacle& ball) {
    return to_segment(ball.center, body) - ball.radius - body.radius;
  }

  // Distance of the nearest of many points; less the greatest depth where some are in the box.
  double from(const Body& body, const BoxObstacle& box) const {
    const Eigen::Index dimension = is_planar(robot_.task_space()) ? 2 : 3;
    const auto at = [&](double share) {
      const Eigen::Vector3d world = body.from + share * (body.to - body.from) - box.center;
      const Eigen::Vector3d local = box.orientation.conjugate() * world;
      const Eigen::VectorXd out = (local.cwiseAbs() - box.half_size).head(dimension);
      return out.maxCoeff() > 0.0 ? out.cwiseMax(0.0).norm() : out.maxCoeff();
    };
    double least = infinity;
    for (int i = 0; i <= samples; ++i) least = std::min(least, at(static_cast<double>(i) / samples));
    return least - body.radius;
  }

  static constexpr int samples = 400;

  const Manipulator& robot_;
  const Constraints& constraints_;
  const Pose& pose_;
  const JointVector& q_;
};

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_CLEARANCE_AT_H
