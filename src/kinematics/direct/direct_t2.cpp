// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_t2.h"

#include "kinematics/direct/tangency.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

struct Circle {
  Eigen::Vector2d center;
  double squared_radius;
};

// Two centers closer than this, relative to the robot, are taken as one.
constexpr double same_center = 1e-13;

Circle circle(const Leg& leg, double q) {
  const Eigen::Vector3d center = leg.proximal_point(q) - leg.anchor;
  return {center.head<2>(), leg.squared_distance(q) - center.z() * center.z()};
}

AssemblyMode at(const Eigen::Vector2d& point, bool near_singular) {
  AssemblyMode mode;
  mode.pose.position.head<2>() = point;
  mode.near_singular = near_singular;
  return mode;
}

}  // namespace

DirectResult direct_t2(const Manipulator& manipulator, const JointVector& q) {
  const Circle first = circle(manipulator.leg(0), q[0]);
  const Circle second = circle(manipulator.leg(1), q[1]);
  const double size = manipulator.size();
  const Eigen::Vector2d between = second.center - first.center;
  const double distance = between.norm();
  if (distance <= same_center * size) {
    const bool same = std::abs(first.squared_radius - second.squared_radius) <= same_center * size * size;
    return {same && first.squared_radius > 0.0 ? DirectStatus::continuum : DirectStatus::solved, {}};
  }
  // One circle less the other is linear: the line through both points of intersection.
  const double along = 0.5 * (distance * distance + first.squared_radius - second.squared_radius) / distance;
  const double squared_half_chord = first.squared_radius - along * along;
  DirectResult result{DirectStatus::solved, {}};
  if (!(squared_half_chord >= -tangency_tolerance * size * size)) return result;

  const double half_chord = std::sqrt(std::max(0.0, squared_half_chord));
  const bool near_singular = half_chord < short_chord * size;
  const Eigen::Vector2d direction = between / distance;
  const Eigen::Vector2d across(-direction.y(), direction.x());
  for (const double sign : {1.0, -1.0})
    result.solutions.push_back(
        at(first.center + along * direction + sign * half_chord * across, near_singular));
  return result;
}

}  // namespace parallel_aspects
