// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/surface/mesh_section.h"

#include "aspects/surface/plane_polygons.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using PointIndex = std::uint32_t;

constexpr PointIndex not_left = std::numeric_limits<PointIndex>::max();

/// Cuts one mesh. A point in the plane counts as left, so that every edge that is cut has one new point.
class Cutter {
 public:
  Cutter(const SurfaceMesh& mesh, const HalfSpace& half_space)
      : mesh_(mesh), half_space_(half_space), kept_(mesh.points.size(), not_left) {
    for (const Vector3d& point : mesh.points)
      heights_.push_back(half_space.normal.dot(point) - half_space.offset);
  }

  MeshSection cut() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) add(t);
    close();
    return std::move(section_);
  }

 private:
  using Edge = std::pair<PointIndex, PointIndex>;

  bool is_left(PointIndex point) const { return heights_[point] <= 0.0; }

  PointIndex append(const Vector3d& point, PointIndex origin) {
    section_.mesh.points.push_back(point);
    section_.mesh.is_flat.push_back(mesh_.is_flat[origin]);
    section_.origins.push_back(origin);
    return static_cast<PointIndex>(section_.mesh.points.size() - 1);
  }

  PointIndex kept(PointIndex point) {
    if (kept_[point] == not_left) kept_[point] = append(mesh_.points[point], point);
    return kept_[point];
  }

  PointIndex crossing(PointIndex left, PointIndex gone) {
    const auto found = crossings_.find({left, gone});
    if (found != crossings_.end()) return found->second;
    const double share = heights_[left] / (heights_[left] - heights_[gone]);
    const Vector3d &a = mesh_.points[left], &b = mesh_.points[gone];
    Vector3d point = a + share * (b - a);
    point -= (half_space_.normal.dot(point) - half_space_.offset) * half_space_.normal;
    return crossings_[{left, gone}] = append(point, left);
  }

  void add(std::size_t t) {
    std::vector<PointIndex> polygon;
    PointIndex leaves = not_left, enters = not_left;
    for (std::size_t i = 0; i < 3; ++i) {
      const PointIndex here = mesh_.triangles[t][i], next = mesh_.triangles[t][(i + 1) % 3];
      if (is_left(here)) polygon.push_back(kept(here));
      if (is_left(here) == is_left(next)) continue;
      polygon.push_back(is_left(here) ? crossing(here, next) : crossing(next, here));
      (is_left(here) ? leaves : enters) = polygon.back();
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      section_.mesh.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
      section_.mesh.kinds.push_back(mesh_.kinds[t]);
    }
    if (leaves != not_left) next_[enters] = leaves;
  }

  // The edges in the plane, each of which has one triangle so far, run around the faces that are missing.
  void close() {
    const Vector3d first = half_space_.normal.unitOrthogonal(), second = half_space_.normal.cross(first);
    std::vector<Vector2d> flat;
    for (const Vector3d& point : section_.mesh.points) flat.emplace_back(first.dot(point), second.dot(point));
    std::vector<PlaneLoop> loops;
    while (!next_.empty()) {
      PlaneLoop loop;
      for (auto step = next_.begin(); step != next_.end(); step = next_.find(loop.back())) {
        section_.rim.push_back({step->first, step->second});
        loop.push_back(step->second);
        next_.erase(step);
      }
      loops.push_back(std::move(loop));
    }
    for (const auto& triangle : triangles_of(loops, flat)) {
      section_.mesh.triangles.push_back(triangle);
      section_.mesh.kinds.push_back(FaceKind::section);
    }
  }

  const SurfaceMesh& mesh_;
  const HalfSpace& half_space_;
  std::vector<double> heights_;
  std::vector<PointIndex> kept_;  // by point of the mesh
  std::map<Edge, PointIndex> crossings_;
  std::map<PointIndex, PointIndex> next_;  // along the faces in the plane
  MeshSection section_;
};

}  // namespace

MeshSection section_of(const SurfaceMesh& mesh, const HalfSpace& half_space) {
  return Cutter(mesh, half_space).cut();
}

}  // namespace parallel_aspects
