// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_hinges.h"

#include "kinematics/direct/circle_family.h"
#include "kinematics/direct/direct_candidates.h"
#include "kinematics/direct/direct_problem.h"

#include <cmath>

namespace parallel_aspects {
namespace {

// A leg of which the first hinge alone is free: matrix . (cos theta, sin theta) = right, which is half of
// |Rz(theta) p - c|^2 = rho^2 with p where theta is 0.
struct HingeEquation {
  Eigen::Vector2d matrix;
  double right;
};

HingeEquation equation_of(const LockedLeg& leg, const Eigen::Vector3d& p) {
  const Eigen::Vector3d& c = leg.base;
  return {{c.x() * p.x() + c.y() * p.y(), c.y() * p.x() - c.x() * p.y()},
          0.5 * (p.squaredNorm() + c.squaredNorm() - leg.squared_length) - c.z() * p.z()};
}

AssemblyMode at(const Manipulator& manipulator, const PoseCoordinates& angles) {
  AssemblyMode mode;
  mode.pose = pose_from_coordinates(manipulator.motions(), angles).value_or(Pose{});
  return mode;
}

}  // namespace

DirectResult direct_r1(const Manipulator& manipulator, const JointVector& q) {
  const LockedLeg leg = locked(manipulator.leg(0), q[0]);
  const auto [matrix, right] = equation_of(leg, leg.anchor);
  const double squared_size = manipulator.size() * manipulator.size();
  const double radius = matrix.norm(), squared_half_chord = radius * radius - right * right;
  if (radius <= tangency_tolerance * squared_size)
    return {
        std::abs(right) <= tangency_tolerance * squared_size ? DirectStatus::continuum : DirectStatus::solved,
        {}};
  DirectResult result{DirectStatus::solved, {}};
  if (!(squared_half_chord >= -tangency_tolerance * squared_size * squared_size)) return result;
  const double half_chord = std::sqrt(std::max(0.0, squared_half_chord));
  const double middle = std::atan2(matrix.y(), matrix.x()), aside = std::atan2(half_chord, right);
  for (const double sign : {1.0, -1.0}) {
    result.solutions.push_back(at(manipulator, PoseCoordinates::Constant(1, middle + sign * aside)));
    result.solutions.back().near_singular = half_chord < short_chord * radius;
  }
  return result;
}

// With theta2 known both legs are linear in the cosine and sine of theta1, by trigonometric polynomials of
// degree 1 in theta2: |p|^2 has no more, since the operational point and the length of the arm do not change.
DirectResult direct_r2(const Manipulator& manipulator, const JointVector& q) {
  const LockedLeg legs[2] = {locked(manipulator.leg(0), q[0]), locked(manipulator.leg(1), q[1])};
  const auto equations = [&](double second) {
    const Pose pose = at(manipulator, Eigen::Vector2d(0.0, second)).pose;
    LinearPair pair;
    for (Eigen::Index j = 0; j < 2; ++j) {
      const HingeEquation equation = equation_of(legs[j], pose.transform(legs[j].anchor));
      pair.matrix.row(j) = equation.matrix;
      pair.right[j] = equation.right;
    }
    return pair;
  };
  const CircleFamilySolutions found = circle_family_solutions({equations, 1.0});
  DirectResult result{found.every_angle ? DirectStatus::continuum : DirectStatus::solved, {}};
  for (const auto& [second, v] : found.candidates)
    result.solutions.push_back(at(manipulator, Eigen::Vector2d(std::atan2(v.y(), v.x()), second)));
  return result;
}

}  // namespace parallel_aspects
