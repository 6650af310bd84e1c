// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_t3.h"

#include "kinematics/direct/locked_legs.h"
#include "kinematics/direct/tangency.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace parallel_aspects {
namespace {

struct Sphere {
  Eigen::Vector3d center;
  double squared_radius;
};

using Spheres = std::array<Sphere, 3>;

// Centers this close to one line, relative to the robot, are taken to be on it.
constexpr double collinear = 1e-13;

// Spheres that miss a common circle by less than this, relative to the robot, are taken to share it.
constexpr double same_circle = 1e-12;

Spheres spheres(const Manipulator& manipulator, const JointVector& q) {
  Spheres result;
  for (std::size_t j = 0; j < 3; ++j) {
    const LockedLeg leg = locked(manipulator.leg(j), q[static_cast<Eigen::Index>(j)]);
    result[j] = {leg.base - leg.anchor, leg.squared_length};
  }
  return result;
}

double power(const Sphere& sphere, const Eigen::Vector3d& point) {
  return (point - sphere.center).squaredNorm() - sphere.squared_radius;
}

// Three spheres with centers on a line through `first` share a circle or a point, or have nothing in common.
DirectStatus status_of_collinear(const Spheres& all, double size) {
  const Sphere& first = all[0];
  const bool second_is_farther =
      (all[1].center - first.center).norm() > (all[2].center - first.center).norm();
  const Sphere& other = all[second_is_farther ? 1 : 2];
  const Eigen::Vector3d between = other.center - first.center;
  const double distance = between.norm();
  double along = 0.0;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  if (distance > collinear * size) {
    axis = between / distance;
    along = 0.5 * (distance * distance + first.squared_radius - other.squared_radius) / distance;
  }
  const double squared_radius = first.squared_radius - along * along;
  if (!(squared_radius > 0.0)) return DirectStatus::solved;
  const Eigen::Vector3d point =
      first.center + along * axis + std::sqrt(squared_radius) * axis.unitOrthogonal();
  for (const Sphere& sphere : all)
    if (std::abs(power(sphere, point)) > same_circle * size * size) return DirectStatus::solved;
  return DirectStatus::continuum;
}

}  // namespace

DirectResult direct_t3(const Manipulator& manipulator, const JointVector& q) {
  const Spheres all = spheres(manipulator, q);
  const double size = manipulator.size();
  const Eigen::Vector3d second = all[1].center - all[0].center, third = all[2].center - all[0].center;
  const Eigen::Vector3d normal = second.cross(third);
  const double squared_normal = normal.squaredNorm();
  if (std::sqrt(squared_normal) <= collinear * size * size) return {status_of_collinear(all, size), {}};

  // Seen from the first center, |p|^2 = R1; the other spheres less the first are linear, p.second = r2 and
  // p.third = r3. The foot solves both in the plane of the centers, and p is straight above or below it.
  const double r2 = 0.5 * (second.squaredNorm() + all[0].squared_radius - all[1].squared_radius);
  const double r3 = 0.5 * (third.squaredNorm() + all[0].squared_radius - all[2].squared_radius);
  const Eigen::Vector3d foot = (r2 * third.cross(normal) + r3 * normal.cross(second)) / squared_normal;
  const double squared_height = all[0].squared_radius - foot.squaredNorm();
  DirectResult result{DirectStatus::solved, {}};
  if (!(squared_height >= -tangency_tolerance * size * size)) return result;
  const double share = std::sqrt(std::max(0.0, squared_height) / squared_normal);
  for (const double sign : {1.0, -1.0}) {
    AssemblyMode mode;
    mode.pose.position = all[0].center + foot + sign * share * normal;
    result.solutions.push_back(mode);
  }
  return result;
}

}  // namespace parallel_aspects
