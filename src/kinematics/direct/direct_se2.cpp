// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_se2.h"

#include "kinematics/direct/circle_family.h"
#include "kinematics/direct/locked_legs.h"

#include <Eigen/Geometry>

#include <array>

namespace parallel_aspects {
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

}  // namespace parallel_aspects
