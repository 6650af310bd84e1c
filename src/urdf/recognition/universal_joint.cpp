// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/universal_joint.h"

#include <Eigen/Geometry>

#include <cmath>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double quarter_turn = 0.5 * EIGEN_PI;

// Wide enough for limits of a quarter of a turn that are rounded to four digits.
constexpr double angle_tolerance = 5e-4;

// Axes that miss a right angle by more would make the cones wrong in more than the last digits.
constexpr double perpendicular_tolerance = 1e-6;

bool are_perpendicular(const Vector3d& a, const Vector3d& b) {
  return std::abs(a.dot(b)) < perpendicular_tolerance;
}

/// The range of an angle that is `now` and grows with the joint value.
JointLimits range_of(const UniversalAxis& pivot, double now) {
  JointLimits range;
  range.lower = now + (pivot.limits.lower - pivot.value);
  range.upper = now + (pivot.limits.upper - pivot.value);
  return range;
}

}  // namespace

// Seen from what the first axis a is fixed in, with phi the elevation of the rod u over the plane across a,
// psi its azimuth there and g its direction there now, u = cos phi (cos psi g + sin psi a x g) + sin phi a.
// The second joint changes phi alone, the first psi. With cos phi > 0,
//   phi >= l  is  u.a >= cos(pi/2 - l),  and  phi <= h  is  u.(-a) >= cos(pi/2 + h);
//   psi in [l, h], not longer than half a turn, is  u.n >= 0  for the directions n at azimuth l + pi/2 and
//   h - pi/2.
std::optional<std::vector<LimitedDirection>> limited_directions(const UniversalAxis& first,
                                                                const UniversalAxis& second,
                                                                const Vector3d& rod) {
  const Vector3d u = rod.normalized(), a = first.axis;
  if (!are_perpendicular(a, second.axis) || !are_perpendicular(second.axis, u)) return std::nullopt;
  const Vector3d across = a.cross(second.axis);
  const double side = u.dot(across) < 0.0 ? -1.0 : 1.0;  // where the rod is on the other side, phi falls
  const Vector3d g = side * across, h = a.cross(g);
  const double elevation = std::atan2(u.dot(a), u.dot(g));
  JointLimits phi = range_of(second, side * elevation);
  if (side < 0.0) phi = {-phi.upper, -phi.lower};
  const JointLimits psi = range_of(first, 0.0);
  if (!(phi.lower >= -quarter_turn - angle_tolerance && phi.upper <= quarter_turn + angle_tolerance &&
        phi.lower < quarter_turn && phi.upper > -quarter_turn))
    return std::nullopt;
  if (psi.limited() && !(psi.upper - psi.lower <= EIGEN_PI)) return std::nullopt;
  std::vector<LimitedDirection> result;
  if (phi.lower > -quarter_turn) result.push_back({second.joint, a, quarter_turn - phi.lower});
  if (phi.upper < quarter_turn) result.push_back({second.joint, -a, quarter_turn + phi.upper});
  if (!psi.limited()) return result;
  result.push_back({first.joint, std::cos(psi.lower) * h - std::sin(psi.lower) * g, quarter_turn});
  result.push_back({first.joint, std::sin(psi.upper) * g - std::cos(psi.upper) * h, quarter_turn});
  return result;
}

}  // namespace parallel_aspects
