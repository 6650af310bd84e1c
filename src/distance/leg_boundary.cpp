// SPDX-License-Identifier: BSD-3-Clause
#include "distance/leg_boundary.h"

#include "interval/half_turns.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

/// Collects the boundaries of one leg.
template <std::size_t dimension>
class Collector {
 public:
  using Boundary = LegBoundary<dimension>;
  using Surface = typename Boundary::Surface;

  Collector(const Leg& leg, std::size_t index, LegBoundaries<dimension>& all)
      : leg_(leg), index_(index), all_(all) {
    if constexpr (dimension == 2)
      squared_height_ = square(Interval(leg.anchor.z()) - Interval(leg.base_point().z()));
  }

  void operator()(const RevoluteActuation& actuation) {
    const Interval rod(leg_.rod_length), crank(actuation.radius);
    // B_jj = 0 where the rod is square to the motion of the crank's tip. In the plane that is along the
    // crank, stretched or folded; in space, in the plane of the tip and the axis: a torus about the tip's
    // circle.
    if constexpr (dimension == 2) {
      const Interval in_plane = root(square(rod) - squared_height_);
      add_serial_sphere(crank + in_plane);
      add_serial_sphere(magnitude_of(crank - in_plane));
    } else {
      for (const Surface surface : {Surface::near_torus, Surface::far_torus}) {
        Boundary boundary = at_surface(surface, rod);
        boundary.axis = point(actuation.axis);
        boundary.crank = crank;
        all_.serial.push_back(boundary);
      }
    }
    if (is_angle_limited()) {
      add_limit(actuation, LimitEnd::lower, leg_.limits.lower);
      add_limit(actuation, LimitEnd::upper, leg_.limits.upper);
    }
  }

  void operator()(const PrismaticActuation& actuation) {
    Boundary boundary =
        at_surface(Surface::cylinder, root(square(Interval(leg_.rod_length)) - squared_height_));
    boundary.axis = point(actuation.direction);
    all_.serial.push_back(boundary);
    // At a limit the anchor is on the sphere of the rod about c; the sign of u.c' parts it by branches.
    for (const auto& [end, value] : finite_limits()) {
      Boundary limit = boundary;
      limit.surface = Surface::sphere;
      limit.end = end;
      limit.sided = true;
      for (std::size_t i = 0; i < dimension; ++i) limit.center[i] = Interval(value) * boundary.axis[i];
      all_.limits.push_back(limit);
    }
  }

  void operator()(const StrutActuation& actuation) {
    // B_jj is the length: it vanishes where the anchor is at the base point, if it can come there.
    if (squared_height_.lower() <= 0.0) add_serial_sphere(Interval(0.0));
    for (const auto& [end, value] : finite_limits())
      add_limit_sphere(
          end,
          square_of_length(Interval(actuation.length_at_zero) + Interval(actuation.sense) * Interval(value)),
          0);
  }

  void operator()(const ElbowActuation& actuation) {
    const Interval inner(actuation.inner_length), outer(actuation.outer_length);
    add_serial_sphere(root(square(inner + outer) - squared_height_));
    add_serial_sphere(root(square(inner - outer) - squared_height_));
    if (!is_angle_limited()) return;
    for (const auto& [end, value] : finite_limits()) {
      const double angle = actuation.angle_at_zero + actuation.sense * value;
      // On one branch sin(angle) has one sign; at zero the limit is the serial singularity itself.
      const double entry = -actuation.sense * std::sin(angle);
      const int branch = std::abs(entry) < 1e-9 ? 0 : entry > 0.0 ? 1 : -1;
      add_limit_sphere(
          end, square(inner) + square(outer) + Interval(2.0) * inner * outer * enclosed_turn(angle).cosine,
          branch);
    }
  }

 private:
  struct FiniteLimit {
    LimitEnd end;
    double value;
  };

  static Interval magnitude_of(const Interval& a) { return root(square(a)); }

  // A length below zero assembles nowhere.
  static Interval square_of_length(const Interval& length) {
    return length.negative() ? Interval(-1.0) : square(not_negative_part(length));
  }

  static std::array<Interval, dimension> point(const Eigen::Vector3d& vector) {
    std::array<Interval, dimension> result;
    for (std::size_t i = 0; i < dimension; ++i) result[i] = Interval(vector[static_cast<Eigen::Index>(i)]);
    return result;
  }

  bool is_angle_limited() const {
    return std::isfinite(leg_.limits.lower) && std::isfinite(leg_.limits.upper) &&
           leg_.limits.upper - leg_.limits.lower < 2.0 * EIGEN_PI;
  }

  std::vector<FiniteLimit> finite_limits() const {
    std::vector<FiniteLimit> result;
    if (std::isfinite(leg_.limits.lower)) result.push_back({LimitEnd::lower, leg_.limits.lower});
    if (std::isfinite(leg_.limits.upper)) result.push_back({LimitEnd::upper, leg_.limits.upper});
    return result;
  }

  Boundary at_surface(Surface surface, const Interval& radius) const {
    Boundary boundary;
    boundary.surface = surface;
    boundary.leg = index_;
    boundary.radius = radius;
    return boundary;
  }

  void add_serial_sphere(const Interval& radius) {
    all_.serial.push_back(at_surface(Surface::sphere, radius));
  }

  void add_limit_sphere(LimitEnd end, const Interval& squared_radius, int branch) {
    const Interval in_plane = squared_radius - squared_height_;
    if (in_plane.negative()) return;
    Boundary boundary = at_surface(Surface::sphere, root(in_plane));
    boundary.end = end;
    boundary.branch = branch;
    all_.limits.push_back(boundary);
  }

  void add_limit(const RevoluteActuation& actuation, LimitEnd end, double angle) {
    const auto [cosine, sine] = enclosed_turn(angle);
    const Eigen::Vector3d& e1 = actuation.zero_direction;
    const Interval radius = root(square(Interval(leg_.rod_length)) - squared_height_);
    Boundary boundary = at_surface(Surface::sphere, radius);
    boundary.end = end;
    boundary.sided = true;
    const std::array<Interval, dimension> zero = point(e1), side = side_direction(actuation);
    for (std::size_t i = 0; i < dimension; ++i) {
      boundary.center[i] = Interval(actuation.radius) * (cosine * zero[i] + sine * side[i]);
      boundary.axis[i] = cosine * side[i] - sine * zero[i];
    }
    all_.limits.push_back(boundary);
  }

  static std::array<Interval, dimension> side_direction(const RevoluteActuation& actuation) {
    const Eigen::Vector3d &a = actuation.axis, &e = actuation.zero_direction;
    const std::array<Interval, 3> side{Interval(a.y()) * Interval(e.z()) - Interval(a.z()) * Interval(e.y()),
                                       Interval(a.z()) * Interval(e.x()) - Interval(a.x()) * Interval(e.z()),
                                       Interval(a.x()) * Interval(e.y()) - Interval(a.y()) * Interval(e.x())};
    std::array<Interval, dimension> result;
    for (std::size_t i = 0; i < dimension; ++i) result[i] = side[i];
    return result;
  }

  const Leg& leg_;
  std::size_t index_;
  LegBoundaries<dimension>& all_;
  Interval squared_height_;  // of the anchor over the base point, out of the plane
};

}  // namespace

template <std::size_t dimension>
LegBoundaries<dimension> leg_boundaries(const Manipulator& manipulator) {
  assert_rounding_upward();
  LegBoundaries<dimension> all;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    std::visit(Collector<dimension>(manipulator.leg(j), j, all), manipulator.leg(j).actuation);
  return all;
}

template LegBoundaries<2> leg_boundaries<2>(const Manipulator&);
template LegBoundaries<3> leg_boundaries<3>(const Manipulator&);

}  // namespace parallel_aspects
