// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/unassembled.h"

#include "interval/path_form.h"
#include "legs/link_points.h"
#include "legs/spatial_leg.h"
#include "tracking/leg_enclosure.h"

#include <cstddef>

namespace parallel_aspects {
namespace {

/// Where a leg keeps the operational point: |X - center|^2 = squared_radius.
struct Sphere {
  IntervalVector center;
  Interval squared_radius;
};

/// Seen from the origin, the anchor is off the proximal point by u = -center. What `q` is off its middle
/// moves the center at most with the speed of the proximal point, and changes rho^2 at most as 2 B_jj does.
Sphere sphere_of(const Leg& leg, const Interval& q) {
  const LegForm form(leg);
  const double middle = 0.5 * (q.lower() + q.upper());
  const double off = magnitude(q - Interval(middle));
  const LegEnclosure at = form.enclose(Pose{}, nullptr, middle);
  const double moved = form.point_speed() * off;
  const Interval squared_distance = squared_norm(at.u);
  const double rod = square_root(squared_distance).upper() + moved;
  const double grown = 2.0 * off * (magnitude(at.inverse_diagonal) + form.joint_curvature(rod) * off);
  Sphere sphere;
  for (std::size_t i = 0; i < 3; ++i) sphere.center[i] = Interval(-moved, moved) - at.u[i];
  sphere.squared_radius = squared_distance - Interval(2.0) * at.half_residual + Interval(-grown, grown);
  return sphere;
}

/// The section of a sphere with the line or plane that the operational point stays in.
Sphere section(Sphere sphere, std::size_t moved) {
  for (std::size_t i = moved; i < 3; ++i) {
    sphere.squared_radius = sphere.squared_radius - square(sphere.center[i]);
    sphere.center[i] = Interval(0.0);
  }
  return sphere;
}

/// Of the center of another sphere from the first, e, and of e.Y for a common point that is Y from the first
/// center.
struct Direction {
  IntervalVector e;
  Interval product;
};

Direction direction(const Sphere& first, const Sphere& other) {
  const IntervalVector e = other.center - first.center;
  return {e, Interval(0.5) * (dot(e, e) + first.squared_radius - other.squared_radius)};
}

}  // namespace

// For a common point Y the Gram determinant of Y and the directions is not negative, with |Y|^2 the squared
// radius of the first sphere.
bool proved_unassembled(const Manipulator& manipulator, const std::array<Interval, max_legs>& q) noexcept {
  assert_rounding_upward();
  if (has_rotation(manipulator.task_space())) return false;
  const std::size_t n = manipulator.leg_count();
  std::array<Sphere, 3> spheres;
  for (std::size_t j = 0; j < n; ++j) spheres[j] = section(sphere_of(manipulator.leg(j), q[j]), n);
  const Interval& squared = spheres[0].squared_radius;
  if (n == 1) return squared.negative();
  const Direction a = direction(spheres[0], spheres[1]);
  if (n == 2) return (squared * dot(a.e, a.e) - square(a.product)).negative();
  const Direction b = direction(spheres[0], spheres[2]);
  const Interval aa = dot(a.e, a.e), bb = dot(b.e, b.e), ab = dot(a.e, b.e);
  const Interval gram = aa * bb - square(ab);
  const Interval least =
      square(a.product) * bb - Interval(2.0) * (a.product * b.product) * ab + square(b.product) * aa;
  return (squared * gram - least).negative();
}

}  // namespace parallel_aspects
