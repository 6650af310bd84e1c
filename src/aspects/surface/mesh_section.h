// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_SURFACE_MESH_SECTION_H
#define PARALLEL_ASPECTS_ASPECTS_SURFACE_MESH_SECTION_H

#include "aspects/surface/surface_mesh.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_ASPECTS_SURFACE_MESH_SECTION_H
