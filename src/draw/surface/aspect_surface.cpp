// SPDX-License-Identifier: BSD-3-Clause
#include "draw/surface/aspect_surface.h"

#include "draw/plane/boundary_functions.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double turn = 2.0 * EIGEN_PI;
constexpr std::uint32_t finest = 7;    // halvings of the region, unless the aspect is small
constexpr std::size_t fewest = 80;     // cells that a small one is drawn with
constexpr std::uint32_t coarsest = 3;  // halvings of the region
constexpr int rounds = 4;              // of smoothing
constexpr int searches = 3;            // for the boundary, each from where the last one left the points
constexpr int halvings = 7;            // of the way to the boundary
constexpr double gap = 0.04;  // left before the boundary, in cells, since the aspect beyond ends there too

/// Searches along a line for the end of an aspect.
class BoundarySearch {
 public:
  BoundarySearch(const AspectMap& map, const Aspect& aspect)
      : map_(map), functions_(*map.manipulator(), aspect.mode), sign_(aspect.determinant_sign) {}

  /// Moves `point` to the end of the aspect, where that is no more than `along` away, before or behind.
  std::optional<BoundaryKind> move(Vector3d& point, const Vector3d& along) const {
    const auto range = bracket(point, along);
    if (!range) return std::nullopt;
    auto [inside, outside] = *range;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (inside + outside);
      (broken_at(point + middle * along) ? outside : inside) = middle;
    }
    const auto kind = broken_at(point + outside * along);
    point += (inside - gap) * along;
    return kind;
  }

 private:
  std::optional<std::pair<double, double>> bracket(const Vector3d& point, const Vector3d& along) const {
    const bool starts_inside = !broken_at(point);
    const double direction = starts_inside ? 1.0 : -1.0;
    double before = 0.0;
    for (const double here : {0.5, 1.0}) {
      if (!broken_at(point + direction * here * along).has_value() != starts_inside) {
        const double near = direction * before, far = direction * here;
        return starts_inside ? std::pair(near, far) : std::pair(far, near);
      }
      before = here;
    }
    return std::nullopt;
  }

  // What a pose violates; det A, which has no meaning where a leg does not reach, comes last.
  std::optional<BoundaryKind> broken_at(const Vector3d& point) const {
    const BoundaryFunctions::Values values = functions_.values(surface_pose(map_, point));
    for (Eigen::Index k = 1; k < values.size(); ++k)
      if (!(values[k] > 0.0)) return functions_.list()[static_cast<std::size_t>(k)].kind;
    if (!(sign_ * values[0] > 0.0)) return BoundaryKind::parallel;
    return std::nullopt;
  }

  const AspectMap& map_;
  const BoundaryFunctions functions_;
  const int sign_;
};

// Which way a point may move: out of the surface, but along an edge.
Vector3d way_out(const SurfaceMesh& mesh, std::size_t p, const Vector3d& normal, const CellSet& cells) {
  Vector3d way = normal;
  const auto& flat = mesh.is_flat[p];
  if (cells.is_ball()) {
    if (flat[0] || flat[1] || flat[2]) return Vector3d::Zero();
  } else {
    for (std::size_t i = 0; i < 3; ++i)
      if (flat[i]) way[static_cast<Eigen::Index>(i)] = 0.0;
  }
  const double length = way.norm();
  return length > 0.3 ? Vector3d((way / length).cwiseProduct(cells.edges())) : Vector3d(Vector3d::Zero());
}

void move_to_boundary(const AspectMap& map, const CellSet& cells, const std::vector<Vector3d>& start,
                      AspectSurface& surface) {
  const BoundarySearch search(map, map.aspects()[static_cast<std::size_t>(surface.aspect - 1)]);
  const std::vector<Vector3d> normals = normals_of(surface.mesh, cells.edges(), Of::inner);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, start.size()), [&](const auto& range) {
    for (std::size_t p = range.begin(); p < range.end(); ++p) {
      const Vector3d along = way_out(surface.mesh, p, normals[p], cells);
      if (along.isZero()) continue;
      Vector3d& point = surface.mesh.points[p];
      surface.bounds[p] = search.move(point, along);
      point = point.cwiseMin(start[p] + cells.edges()).cwiseMax(start[p] - cells.edges());
    }
  });
}

// Points for which no end was found follow those for which one was.
void settle(AspectSurface& surface, const std::vector<Vector3d>& start, const CellSet& cells) {
  const std::vector<Vector3d> found = surface.mesh.points;
  smooth(surface.mesh, rounds, cells.edges(), cells.is_ball());
  for (std::size_t p = 0; p < start.size(); ++p) {
    Vector3d& point = surface.mesh.points[p];
    if (surface.bounds[p]) point = found[p];
    point = point.cwiseMin(start[p] + cells.edges()).cwiseMax(start[p] - cells.edges());
  }
}

AspectSurface finished(const AspectMap& map, int aspect, const CellSet& cells, SurfaceMesh mesh,
                       const SurfaceOptions& options) {
  AspectSurface surface;
  surface.aspect = aspect;
  surface.mesh = std::move(mesh);
  surface.edges = cells.edges();
  surface.measure = cells.measure();
  surface.bounds.resize(surface.mesh.points.size());
  if (!options.smoothed) return surface;
  const std::vector<Vector3d> start = surface.mesh.points;
  smooth(surface.mesh, rounds, 0.5 * cells.edges(), cells.is_ball());
  for (int search = 0; search < searches; ++search) {
    if (search > 0) smooth(surface.mesh, 1, cells.edges(), cells.is_ball());
    move_to_boundary(map, cells, start, surface);
    settle(surface, start, cells);
  }
  return surface;
}

}  // namespace

bool has_surfaces(const AspectMap& map) noexcept {
  if (map.slice()) return map.slice()->free_positions() == 3 && map.slice()->dimension() == 3;
  const TaskSpace space = map.manipulator()->task_space();
  return space == TaskSpace::SE2 || space == TaskSpace::T3 || space == TaskSpace::SO3;
}

AspectSurface surface_of(const AspectMap& map, int aspect, const SurfaceOptions& options) {
  for (std::uint32_t level = std::min(map.contents().depth, finest);; --level) {
    const CellSet cells(map, aspect, level, fewest);
    SurfaceMesh mesh = mesh_of(cells);
    if (mesh.triangles.size() > options.most_triangles && level > coarsest) continue;
    return finished(map, aspect, cells, std::move(mesh), options);
  }
}

AspectSurface section_of(const AspectSurface& surface, const HalfSpace& half_space) {
  MeshSection section = section_of(surface.mesh, half_space);
  AspectSurface result{surface.aspect, std::move(section.mesh), {}, surface.edges, surface.measure, {}};
  for (const std::uint32_t origin : section.origins) result.bounds.push_back(surface.bounds[origin]);
  result.rim = std::move(section.rim);
  return result;
}

Vector3d surface_point(TaskSpace space, const Pose& pose) noexcept {
  if (space == TaskSpace::T3 || space == TaskSpace::SE3) return pose.position;
  const Eigen::AngleAxisd rotation(pose.orientation);
  if (space == TaskSpace::SO3) return std::remainder(rotation.angle(), turn) * rotation.axis();
  const double phi = 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w());
  return {pose.position.x(), pose.position.y(), std::remainder(phi, turn)};
}

Pose surface_pose(const AspectMap& map, const Vector3d& point) noexcept {
  const TaskSpace space = map.manipulator()->task_space();
  if (space == TaskSpace::SE2) return Pose::planar(point.x(), point.y(), point.z());
  Pose pose;
  if (map.slice()) pose.orientation = map.slice()->held.orientation;
  if (space != TaskSpace::SO3) {
    pose.position = point;
  } else if (const double angle = point.norm(); angle > 0.0) {
    pose.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, point / angle));
  }
  return pose;
}

}  // namespace parallel_aspects
