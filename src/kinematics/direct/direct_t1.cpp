// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_t1.h"

#include "kinematics/direct/tangency.h"

#include <algorithm>
#include <cmath>

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

}  // namespace parallel_aspects
