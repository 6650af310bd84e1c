// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SURFACE_SURFACE_MESH_H
#define PARALLEL_ASPECTS_DRAW_SURFACE_SURFACE_MESH_H

#include "draw/surface/cell_set.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

/// What a face of the outermost cells is.
enum class FaceKind : std::uint8_t {
  inner,    ///< the aspect ends there, or it is not known whether
  edge,     ///< the region of the map, the range of an angle or the ball of rotations ends there
  section,  ///< it was cut there (`section_of`)
};

/// The outermost faces of a set of cells as triangles, counter-clockwise as seen from outside. Every edge has
/// two triangles: where four faces meet, each pair of them has a point of its own in the middle of the edge.
struct SurfaceMesh {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> triangles;
  std::vector<FaceKind> kinds;               ///< of the triangles
  std::vector<std::array<bool, 3>> is_flat;  ///< of the points: axes along which an edge holds them
};

SurfaceMesh mesh_of(const CellSet& cells);

/// Moves points towards the middle of their neighbours `rounds` times, by no more than `most` along each
/// axis, and by nothing along the axes that they are flat along. In the ball of rotations, what lies on its
/// surface stays there.
void smooth(SurfaceMesh& mesh, int rounds, const Eigen::Vector3d& most, bool is_ball);

/// Whose normals are asked for.
enum class Of { all, inner };

/// Directions of unit length out of the surface, by point, from the areas of its triangles in units of
/// `edges`; zero where a point has none.
std::vector<Eigen::Vector3d> normals_of(const SurfaceMesh& mesh, const Eigen::Vector3d& edges,
                                        Of of = Of::all);

/// What the surface encloses, in the product of the units of its coordinates.
double volume_of(const SurfaceMesh& mesh);

/// A half space of the coordinates of surfaces: normal . point <= offset.
struct HalfSpace {
  Eigen::Vector3d normal;  ///< of unit length
  double offset = 0.0;
};

/// What a plane leaves of a mesh.
struct MeshSection {
  SurfaceMesh mesh;  ///< the part in the half space, closed by faces of kind `section` in the plane
  /// By point of `mesh`: the point of the mesh before that it is, or the one next to it that was left.
  std::vector<std::uint32_t> origins;
  std::vector<std::array<std::uint32_t, 2>> rim;  ///< edges of the faces in the plane
};

/// Cuts a closed mesh.
MeshSection section_of(const SurfaceMesh& mesh, const HalfSpace& half_space);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SURFACE_SURFACE_MESH_H
