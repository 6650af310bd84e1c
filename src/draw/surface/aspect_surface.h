// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SURFACE_ASPECT_SURFACE_H
#define PARALLEL_ASPECTS_DRAW_SURFACE_ASPECT_SURFACE_H

#include "draw/plane/map_pictures.h"
#include "draw/surface/surface_mesh.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace parallel_aspects {

struct SurfaceOptions {
  std::size_t most_triangles = 60000;  ///< cells are as fine as this allows, but not finer than the map
  bool smoothed = true;                ///< else the faces of the cells as they are
};

/// The surface of an aspect, to be drawn: around the cells that its inside leaves fill, so that what it
/// encloses is proved but for what smoothing adds. That moves a point by no more than one cell along each
/// axis, and to the singularity or the limit that bounds the aspect where one is so near.
struct AspectSurface {
  int aspect = 0;  ///< id
  SurfaceMesh mesh;
  std::vector<std::optional<BoundaryKind>>
      bounds;             ///< by point: what the aspect ends at there, where it is found
  Eigen::Vector3d edges;  ///< of a cell [m or rad]
  double measure = 0.0;   ///< of its cells, in the unit of `measure_unit`; of a section likewise of all
  std::vector<std::array<std::uint32_t, 2>> rim{};  ///< of a section: edges of its faces in the plane
};

/// Whether `surface_of` draws the aspects of this map: those of three pose coordinates, whole.
bool has_surfaces(const AspectMap& map) noexcept;

/// The surface of an aspect of a map that has surfaces.
AspectSurface surface_of(const AspectMap& map, int aspect, const SurfaceOptions& options = {});

/// The part of a surface in a half space, closed by faces in its plane; without triangles where it leaves
/// nothing.
AspectSurface section_of(const AspectSurface& surface, const HalfSpace& half_space);

/// Where a pose lies in the coordinates of surfaces: x, y, z [m]; x, y [m], phi [rad]; or the rotation
/// vector.
Eigen::Vector3d surface_point(TaskSpace space, const Pose& pose) noexcept;

/// The pose at a point of the surfaces of a map.
Pose surface_pose(const AspectMap& map, const Eigen::Vector3d& point) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SURFACE_ASPECT_SURFACE_H
