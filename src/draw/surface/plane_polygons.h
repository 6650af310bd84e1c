// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SURFACE_PLANE_POLYGONS_H
#define PARALLEL_ASPECTS_DRAW_SURFACE_PLANE_POLYGONS_H

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// A closed polygon of a plane, by its corners.
using PlaneLoop = std::vector<std::uint32_t>;

/// Twice the area that a loop runs around counter-clockwise.
double doubled_area(const PlaneLoop& loop, const std::vector<Eigen::Vector2d>& points);

/// Triangles, counter-clockwise, of the areas that loops enclose: counter-clockwise ones from outside,
/// clockwise ones as holes. Every edge of a loop is one of a triangle, and every other edge is one of two,
/// also where rounding made loops meet; then some triangles may be turned over.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<PlaneLoop>& loops,
                                                       const std::vector<Eigen::Vector2d>& points);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SURFACE_PLANE_POLYGONS_H
