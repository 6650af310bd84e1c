// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/constraints/constraint_clearance.h"

#include "aspects/constraints/separation.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int parts_in_box = 32;

struct Body {
  Vector3d from, to;
  double radius = 0.0;
  LinkName link;
};

double direction_of(const Vector3d& vector) { return std::atan2(vector.y(), vector.x()); }

double side_of(const Body& line, const Vector3d& point) {
  return (line.to - line.from).cross(point - line.from).z();
}

double distance(const Vector3d& point, const Body& body) {
  return closest_points(point, point, body.from, body.to).difference.norm();
}

// Where segments of the plane cross, how far an end would have to go back.
double depth(const Body& a, const Body& b) {
  const bool cross =
      side_of(a, b.from) * side_of(a, b.to) < 0.0 && side_of(b, a.from) * side_of(b, a.to) < 0.0;
  return cross ? std::min({distance(a.from, b), distance(a.to, b), distance(b.from, a), distance(b.to, a)})
               : 0.0;
}

class Configuration {
 public:
  Configuration(const Manipulator& robot, const Pose& pose, const JointVector& q)
      : robot_(robot), constraints_(robot.constraints()), pose_(pose), q_(q) {}

  double in_workspace() const {
    double least = infinity;
    if (!constraints_.workspace) return least;
    const auto count = static_cast<Eigen::Index>(directions(robot_.task_space()));
    for (Eigen::Index i = 0; i < count; ++i)
      least = std::min({least, pose_.position[i] - constraints_.workspace->lower[i],
                        constraints_.workspace->upper[i] - pose_.position[i]});
    return least;
  }

  double of_passive_joints() const {
    double least = infinity;
    for (const PassiveLimit& limit : constraints_.passive_limits) {
      const JointLimits& range = limit.limits;
      const double value = limit.sense * (angle(limit) - limit.offset);
      const double off = std::remainder(value - 0.5 * (range.lower + range.upper), 2.0 * EIGEN_PI);
      least = std::min(least, 0.5 * (range.upper - range.lower) - std::abs(off));
    }
    for (const HingeLimit& limit : constraints_.hinge_limits) {
      const JointLimits& range = limit.limits;
      const double value =
          pose_coordinates(robot_.task_space(), pose_)[static_cast<Eigen::Index>(limit.hinge)];
      const double off = std::remainder(value - 0.5 * (range.lower + range.upper), 2.0 * EIGEN_PI);
      least = std::min(least, 0.5 * (range.upper - range.lower) - std::abs(off));
    }
    for (const PassiveCone& limit : constraints_.passive_cones) least = std::min(least, in_cone(limit.cone));
    return least;
  }

  double of_cones() const {
    double least = infinity;
    for (const BallJointCone& cone : constraints_.cones) least = std::min(least, in_cone(cone));
    return least;
  }

  double of_margins() const {
    const Margins& margins = constraints_.margins;
    double least = infinity;
    if (margins.parallel > 0.0) least = parallel_index(robot_, pose_, q_) - margins.parallel;
    if (margins.serial > 0.0)
      least = std::min(least, serial_indices(robot_, pose_, q_).minCoeff() - margins.serial);
    // Over the least one, so that it is an index, too.
    if (margins.det_a > 0.0)
      least = std::min(least, std::abs(direct_determinant(robot_, pose_, q_)) / margins.det_a - 1.0);
    return least;
  }

  double of_links() const {
    double least = infinity;
    if (!constraints_.self_collision) return least;
    const std::vector<Body> bodies = links();
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (std::size_t j = i + 1; j < bodies.size(); ++j)
        if (can_collide(robot_, bodies[i].link, bodies[j].link))
          least = std::min(least, between(bodies[i], bodies[j]));
    return least;
  }

  double of_obstacles() const {
    double least = infinity;
    if (constraints_.obstacles.empty()) return least;
    std::vector<Body> bodies = links();
    add_platform(bodies);
    for (const Obstacle& obstacle : constraints_.obstacles)
      for (const Body& body : bodies)
        least = std::min(
            least, std::visit([&body](const auto& shape) { return from(body, shape); }, obstacle.shape));
    return least;
  }

 private:
  Vector3d anchor(std::size_t j) const { return pose_.transform(robot_.leg(j).anchor); }
  Vector3d joint(std::size_t j) const {
    return robot_.leg(j).proximal_point(q_[static_cast<Eigen::Index>(j)]);
  }

  double in_cone(const BallJointCone& cone) const {
    const Vector3d rod = anchor(cone.leg) - joint(cone.leg), axis = seen_from_base(cone);
    return cone.angle - std::atan2(rod.cross(axis).norm(), rod.dot(axis));
  }

  Vector3d seen_from_base(const BallJointCone& cone) const {
    if (cone.end == LegEnd::platform) return pose_.orientation * cone.axis;
    const RevoluteActuation* crank = robot_.leg(cone.leg).crank();
    if (crank == nullptr) return cone.axis;
    const Vector3d along = (joint(cone.leg) - crank->center) / crank->radius;
    return cone.axis.x() * along + cone.axis.y() * crank->axis.cross(along) + cone.axis.z() * crank->axis;
  }

  std::vector<Body> links() const {
    std::vector<Body> bodies;
    for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
      bodies.push_back({joint(j), anchor(j), 0.5 * constraints_.thickness.rod, {LinkKind::rod, j}});
      if (robot_.leg(j).kind().has_crank)
        bodies.push_back(
            {robot_.leg(j).base_point(), joint(j), 0.5 * constraints_.thickness.crank, {LinkKind::crank, j}});
    }
    return bodies;
  }

  void add_platform(std::vector<Body>& bodies) const {
    if (!constraints_.thickness.platform) return;
    const std::size_t count = robot_.leg_count();
    for (std::size_t j = 0; j < (count > 2 ? count : count - 1); ++j)
      bodies.push_back({anchor(j), anchor((j + 1) % count), 0.5 * *constraints_.thickness.platform, {}});
  }

  double between(const Body& a, const Body& b) const {
    const double apart = closest_points(a.from, a.to, b.from, b.to).difference.norm();
    return (is_planar(robot_.task_space()) ? apart - depth(a, b) : apart) - a.radius - b.radius;
  }

  double angle(const PassiveLimit& limit) const {
    const double rod = direction_of(anchor(limit.leg) - joint(limit.leg));
    switch (limit.angle) {
      case PassiveAngle::base_to_rod:
        return rod;
      case PassiveAngle::crank_to_rod:
        return rod - direction_of(joint(limit.leg) - robot_.leg(limit.leg).base_point());
      case PassiveAngle::rod_to_platform:
        break;
    }
    return direction_of(pose_.orientation * Vector3d::UnitX()) - rod;
  }

  static double from(const Body& body, const BallObstacle& ball) {
    return distance(ball.center, body) - ball.radius - body.radius;
  }

  static double from(const Body& body, const BoxObstacle& box) {
    const Eigen::Quaterniond to_box = box.orientation.conjugate();
    const Vector3d begin = to_box * (body.from - box.center), end = to_box * (body.to - box.center);
    const double apart = closest_point_to_box(begin, end, box.half_size).difference.norm();
    if (apart > 0.0) return apart - body.radius;
    double deepest = 0.0;
    for (int i = 0; i <= parts_in_box; ++i) {
      const Vector3d point = begin + (end - begin) * i / parts_in_box;
      Vector3d below = box.half_size - point.cwiseAbs();
      if (box.half_size.z() == 0.0) below.z() = infinity;  // a rectangle
      deepest = std::max(deepest, below.minCoeff());
    }
    return -deepest - body.radius;
  }

  const Manipulator& robot_;
  const Constraints& constraints_;
  const Pose& pose_;
  const JointVector& q_;
};

}  // namespace

double constraint_clearance(const Manipulator& manipulator, ConstraintKind kind, const Pose& pose,
                            const JointVector& q) {
  const Configuration configuration(manipulator, pose, q);
  switch (kind) {
    case ConstraintKind::passive_limits:
      return configuration.of_passive_joints();
    case ConstraintKind::cones:
      return configuration.of_cones();
    case ConstraintKind::self_collision:
      return configuration.of_links();
    case ConstraintKind::obstacles:
      return configuration.of_obstacles();
    case ConstraintKind::workspace:
      return configuration.in_workspace();
    case ConstraintKind::margins:
      return configuration.of_margins();
    case ConstraintKind::actuated_limits:
      break;
  }
  return infinity;
}

}  // namespace parallel_aspects
