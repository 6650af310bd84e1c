// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_LEG_BOUNDARY_H
#define PARALLEL_ASPECTS_DISTANCE_LEG_BOUNDARY_H

#include "distance/point_dual.h"
#include "interval/interval.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// Where one leg meets a boundary: a surface that its anchor must lie on, in coordinates d = p - base point.
/// Of three coordinates, or of two where the anchor moves in a parallel of the x-y plane; then surfaces are
/// curves.
///
/// | surface | points d | boundary |
/// |---|---|---|
/// | sphere | |d - center| = radius | limits; elbow or planar crank stretched or folded; strut of no length |
/// | cylinder | at `radius` from the line through 0 along `axis` | rod square to an actuated prismatic joint
/// | | near torus | at `radius` from the nearest point of the circle of `crank` about `axis` | leg stretched
/// | | far torus | at `radius` from the farthest point of that circle | leg folded |
template <std::size_t dimension>
struct LegBoundary {
  enum class Surface { sphere, cylinder, near_torus, far_torus };
  using Point = std::array<Interval, dimension>;

  Surface surface = Surface::sphere;
  std::size_t leg = 0;
  LimitEnd end = LimitEnd::lower;  // of a limit
  Point center{};
  Point axis{};  // unit
  Interval radius, crank;
  int branch = 0;      // sign of B_jj that the boundary belongs to, 0 for both
  bool sided = false;  // only the half with branch * (d - center) . axis >= 0, for both signs

  /// Positive on one side of the surface and negative on the other; its magnitude is the distance of d from
  /// the whole surface.
  template <class Scalar>
  Scalar signed_distance(const std::array<Scalar, dimension>& d) const noexcept {
    const Scalar squared = squared_length(d);
    if (surface == Surface::sphere) return root(squared_length(from_center(d))) - Scalar(radius);
    const Scalar across = root(squared - square(along_axis(d)));
    if (surface == Surface::cylinder) return Scalar(radius) - across;
    const Scalar twice = Interval(2.0) * crank * across, base = squared + Scalar(square(crank));
    if (surface == Surface::near_torus) return Scalar(radius) - root(base - twice);
    return root(base + twice) - Scalar(radius);
  }

  template <class Scalar>
  Scalar side(const std::array<Scalar, dimension>& d) const noexcept {
    return along_axis(from_center(d));
  }

  /// Distance from the rim of a sided sphere.
  template <class Scalar>
  Scalar rim_distance(const std::array<Scalar, dimension>& d) const noexcept {
    const std::array<Scalar, dimension> from = from_center(d);
    const Scalar squared = squared_length(from), across = root(squared - square(along_axis(from)));
    return root(squared + Scalar(square(radius)) - Interval(2.0) * radius * across);
  }

 private:
  template <class Scalar>
  std::array<Scalar, dimension> from_center(const std::array<Scalar, dimension>& d) const noexcept {
    std::array<Scalar, dimension> result;
    for (std::size_t i = 0; i < dimension; ++i) result[i] = d[i] - Scalar(center[i]);
    return result;
  }
  template <class Scalar>
  Scalar along_axis(const std::array<Scalar, dimension>& d) const noexcept {
    Scalar sum = axis[0] * d[0];
    for (std::size_t i = 1; i < dimension; ++i) sum = sum + axis[i] * d[i];
    return sum;
  }
  template <class Scalar>
  static Scalar squared_length(const std::array<Scalar, dimension>& d) noexcept {
    Scalar sum = square(d[0]);
    for (std::size_t i = 1; i < dimension; ++i) sum = sum + square(d[i]);
    return sum;
  }
};

template <std::size_t dimension>
struct LegBoundaries {
  std::vector<LegBoundary<dimension>> serial, limits;
};

/// Of all legs; dimension 2 for T1, T2 and SE2. Needs a live `RoundingUpward`.
template <std::size_t dimension>
LegBoundaries<dimension> leg_boundaries(const Manipulator& manipulator);

extern template LegBoundaries<2> leg_boundaries<2>(const Manipulator&);
extern template LegBoundaries<3> leg_boundaries<3>(const Manipulator&);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_LEG_BOUNDARY_H
