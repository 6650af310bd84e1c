// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_candidates.h"

#include "kinematics/direct/circle_family.h"
#include "kinematics/direct/direct_problem.h"
#include "model/linear_algebra.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects {

DirectResult direct_t1(const Manipulator& manipulator, const JointVector& q) {
  const Leg& leg = manipulator.leg(0);
  const Eigen::Vector3d center = leg.proximal_point(q[0]) - leg.anchor;
  const double size = manipulator.size();
  const double squared_half_chord = leg.squared_distance(q[0]) - center.tail<2>().squaredNorm();
  DirectResult result{DirectStatus::solved, {}};
  if (!(squared_half_chord >= -tangency_tolerance * size * size)) return result;
  const double half_chord = std::sqrt(std::max(0.0, squared_half_chord));
  for (const double sign : {1.0, -1.0}) {
    AssemblyMode mode;
    mode.pose.position.x() = center.x() + sign * half_chord;
    mode.near_singular = half_chord < short_chord * size;
    result.solutions.push_back(mode);
  }
  return result;
}

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

namespace {

// A leg seen in the plane; what it spans across the plane is taken off its length.
struct PlanarLeg {
  Eigen::Vector2d anchor;
  Eigen::Vector2d base;
  double squared_length;
};

using PlanarLegs = std::array<PlanarLeg, 3>;

PlanarLegs planar_legs(const Manipulator& manipulator, const JointVector& q) {
  PlanarLegs legs;
  for (std::size_t j = 0; j < 3; ++j) {
    const LockedLeg leg = locked(manipulator.leg(j), q[static_cast<Eigen::Index>(j)]);
    const double across = leg.anchor.z() - leg.base.z();
    legs[j] = {leg.anchor.head<2>(), leg.base.head<2>(), leg.squared_length - across * across};
  }
  return legs;
}

// With v from the first base point to the first anchor, leg j is |v + w|^2 = rho_j^2 with w = R (b_j - b_1) -
// (c_j - c_1); less the first leg, |v|^2 = rho_1^2, that is linear: 2 w . v = rho_j^2 - rho_1^2 - |w|^2.
LinearPair equations(const PlanarLegs& legs, double phi) {
  const Eigen::Rotation2Dd rotation(phi);
  LinearPair pair;
  for (const int i : {0, 1}) {
    const PlanarLeg& leg = legs[static_cast<std::size_t>(i) + 1];
    const Eigen::Vector2d w = rotation * (leg.anchor - legs[0].anchor) - (leg.base - legs[0].base);
    pair.matrix.row(i) = 2.0 * w;
    pair.right[i] = leg.squared_length - legs[0].squared_length - w.squaredNorm();
  }
  return pair;
}

}  // namespace

DirectResult direct_se2(const Manipulator& manipulator, const JointVector& q) {
  const PlanarLegs legs = planar_legs(manipulator, q);
  const CircleFamilySolutions found =
      circle_family_solutions({[&legs](double phi) { return equations(legs, phi); }, legs[0].squared_length});
  DirectResult result{found.every_angle ? DirectStatus::continuum : DirectStatus::solved, {}};
  for (const auto& [phi, v] : found.candidates) {
    AssemblyMode mode;
    mode.pose.orientation = Eigen::AngleAxisd(phi, Eigen::Vector3d::UnitZ());
    mode.pose.position.head<2>() = legs[0].base + v - Eigen::Rotation2Dd(phi) * legs[0].anchor;
    result.solutions.push_back(mode);
  }
  return result;
}

namespace {

// A leg seen from the fixed center: base . (R anchor) = cosine, with unit vectors.
struct SphericalLeg {
  Eigen::Vector3d anchor;
  Eigen::Vector3d base;
  double cosine;
};

using SphericalLegs = std::array<SphericalLeg, 3>;

// Points this close to the center, relative to the robot, have no direction.
constexpr double at_center = 1e-12;

// Nothing where a point is at the center: that leg does not feel how the platform turns.
std::optional<SphericalLegs> spherical_legs(const Manipulator& manipulator, const JointVector& q) {
  SphericalLegs legs;
  for (std::size_t j = 0; j < 3; ++j) {
    const LockedLeg leg = locked(manipulator.leg(j), q[static_cast<Eigen::Index>(j)]);
    const double b = leg.anchor.norm(), c = leg.base.norm();
    if (std::min(b, c) <= at_center * manipulator.size()) return std::nullopt;
    legs[j] = {leg.anchor / b, leg.base / c, 0.5 * (b * b + c * c - leg.squared_length) / (b * c)};
  }
  return legs;
}

Eigen::Quaterniond turn(const Eigen::Vector3d& axis, double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

// The first leg leaves R = turn(base, t) start turn(anchor, s), where `start` holds the anchor at the right
// angle from the base. In t and v = (cos s, sin s) the other two legs are linear equations.
class FirstLegLocked {
 public:
  explicit FirstLegLocked(const SphericalLegs& legs) : legs_(legs) {
    const double cosine = legs[0].cosine, sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const Eigen::Vector3d held = cosine * legs[0].base + sine * legs[0].base.unitOrthogonal();
    start_ = shortest_rotation(legs[0].anchor, held);
  }

  LinearPair equations(double t) const {
    const Eigen::Quaterniond back = (turn(legs_[0].base, t) * start_).conjugate();
    const Eigen::Vector3d& axis = legs_[0].anchor;
    LinearPair pair;
    for (const int i : {0, 1}) {
      const SphericalLeg& leg = legs_[static_cast<std::size_t>(i) + 1];
      const Eigen::Vector3d base = back * leg.base;
      const double along = axis.dot(leg.anchor);
      pair.matrix.row(i) << base.dot(leg.anchor - along * axis), base.dot(axis.cross(leg.anchor));
      pair.right[i] = leg.cosine - along * base.dot(axis);
    }
    return pair;
  }

  Pose pose(double t, const Eigen::Vector2d& v) const {
    Pose result;
    result.orientation = turn(legs_[0].base, t) * start_ * turn(legs_[0].anchor, std::atan2(v.y(), v.x()));
    return result;
  }

 private:
  SphericalLegs legs_;
  Eigen::Quaterniond start_;
};

// The leg that is farthest from stretched and folded comes first, where the split into t and s is at its
// best.
void put_best_leg_first(SphericalLegs& legs) {
  const auto best = std::min_element(
      legs.begin(), legs.end(),
      [](const SphericalLeg& a, const SphericalLeg& b) { return std::abs(a.cosine) < std::abs(b.cosine); });
  std::swap(legs.front(), *best);
}

bool out_of_reach(const SphericalLegs& legs) {
  return std::any_of(legs.begin(), legs.end(),
                     [](const SphericalLeg& leg) { return !(std::abs(leg.cosine) <= 1.0); });
}

}  // namespace

DirectResult direct_so3(const Manipulator& manipulator, const JointVector& q) {
  std::optional<SphericalLegs> legs = spherical_legs(manipulator, q);
  if (!legs) return {DirectStatus::unsolved, {}};
  if (out_of_reach(*legs)) return {DirectStatus::solved, {}};
  put_best_leg_first(*legs);
  const FirstLegLocked locked_leg(*legs);
  const CircleFamilySolutions found =
      circle_family_solutions({[&](double t) { return locked_leg.equations(t); }, 1.0});
  DirectResult result{found.every_angle ? DirectStatus::continuum : DirectStatus::solved, {}};
  for (const auto& [t, v] : found.candidates) {
    AssemblyMode mode;
    mode.pose = locked_leg.pose(t, v);
    result.solutions.push_back(mode);
  }
  return result;
}

}  // namespace parallel_aspects
