// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_so3.h"

#include "kinematics/direct/circle_family.h"
#include "kinematics/direct/locked_legs.h"
#include "model/linear_algebra.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects {
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
