// SPDX-License-Identifier: BSD-3-Clause
#include "draw/surface/surface_mesh.h"

#include "draw/surface/plane_polygons.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

namespace parallel_aspects {
namespace {

using Index = std::uint32_t;
using Edge = std::pair<Index, Index>;

constexpr double step = 0.5;  // of the way to the middle of the neighbours, in a round

struct EdgeHash {
  std::size_t operator()(const Edge& edge) const noexcept {
    return std::hash<std::uint64_t>()(static_cast<std::uint64_t>(edge.first) << 32U | edge.second);
  }
};

Edge ordered(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }

struct Face {
  std::array<Index, 4> corners;  // counter-clockwise from outside
  Index cell;                    // count of the cell that it bounds
  FaceKind kind;
};

// The corners of a face of a cell, as bits, counter-clockwise from outside.
std::array<unsigned, 4> corners_of(std::size_t axis, bool upper) {
  const unsigned next = 1U << (axis + 1) % 3, last = 1U << (axis + 2) % 3, here = upper ? 1U << axis : 0U;
  return upper ? std::array<unsigned, 4>{here, here | next, here | next | last, here | last}
               : std::array<unsigned, 4>{here, here | last, here | next | last, here | next};
}

class Builder {
 public:
  explicit Builder(const CellSet& cells) : cells_(cells) {}

  SurfaceMesh build() {
    Index count = 0;
    cells_.visit([&](const CellIndex& cell) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) look_beyond(cell, count, axis, upper);
      ++count;
    });
    for (const Face& face : faces_)
      for (std::size_t i = 0; i < 4; ++i) ++faces_at_[ordered(face.corners[i], face.corners[(i + 1) % 4])];
    for (const Face& face : faces_) add(face);
    return std::move(mesh_);
  }

 private:
  void look_beyond(const CellIndex& cell, Index count, std::size_t axis, bool upper) {
    const std::optional<CellIndex> other = cells_.beyond(cell, axis, upper);
    if (other && cells_.holds(*other)) return;
    const FaceKind kind = other ? FaceKind::inner : FaceKind::edge;
    Face face{{}, count, kind};
    const std::array<unsigned, 4> corners = corners_of(axis, upper);
    for (std::size_t i = 0; i < 4; ++i) {
      face.corners[i] = point(cell, corners[i]);
      if (kind != FaceKind::inner) mesh_.is_flat[face.corners[i]][axis] = true;
    }
    turn_outward(face, cells_.center(cell));
    faces_.push_back(face);
  }

  // Some of the cubes of SO3 have left-handed coordinates.
  void turn_outward(Face& face, const Eigen::Vector3d& center) const {
    const auto at = [&](std::size_t i) { return mesh_.points[face.corners[i]]; };
    const Eigen::Vector3d normal = (at(2) - at(0)).cross(at(3) - at(1));
    if (normal.dot(at(0) + at(2) - 2.0 * center) < 0.0) std::swap(face.corners[1], face.corners[3]);
  }

  Index point(const CellIndex& cell, unsigned corner) {
    const auto [found, is_new] =
        points_.try_emplace(cells_.corner_key(cell, corner), static_cast<Index>(mesh_.points.size()));
    if (is_new) append(cells_.corner_point(cell, corner));
    return found->second;
  }

  void append(const Eigen::Vector3d& at) {
    mesh_.points.push_back(at);
    mesh_.is_flat.push_back({});
  }

  // Where more than two faces meet, those of one cell share the middle of the edge.
  void add(const Face& face) {
    std::vector<Index> polygon;
    std::size_t first = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Index from = face.corners[i], to = face.corners[(i + 1) % 4];
      polygon.push_back(from);
      if (faces_at_[ordered(from, to)] <= 2) continue;
      first = polygon.size();
      polygon.push_back(middle(from, to, face.cell));
    }
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const auto at = [&](std::size_t k) { return polygon[(first + k) % polygon.size()]; };
      mesh_.triangles.push_back({at(0), at(i), at(i + 1)});
      mesh_.kinds.push_back(face.kind);
    }
  }

  Index middle(Index from, Index to, Index cell) {
    const auto [found, is_new] =
        middles_[ordered(from, to)].try_emplace(cell, static_cast<Index>(mesh_.points.size()));
    if (!is_new) return found->second;
    append(0.5 * (mesh_.points[from] + mesh_.points[to]));
    for (std::size_t i = 0; i < 3; ++i)
      mesh_.is_flat.back()[i] = mesh_.is_flat[from][i] && mesh_.is_flat[to][i];
    return found->second;
  }

  const CellSet& cells_;
  SurfaceMesh mesh_;
  std::vector<Face> faces_;
  std::unordered_map<std::uint64_t, Index> points_;
  std::unordered_map<Edge, int, EdgeHash> faces_at_;
  std::unordered_map<Edge, std::unordered_map<Index, Index>, EdgeHash> middles_;
};

bool is_flat(const std::array<bool, 3>& axes) { return axes[0] || axes[1] || axes[2]; }

}  // namespace

SurfaceMesh mesh_of(const CellSet& cells) { return Builder(cells).build(); }

void smooth(SurfaceMesh& mesh, int rounds, const Eigen::Vector3d& most, bool is_ball) {
  const std::vector<Eigen::Vector3d> start = mesh.points;
  std::vector<Eigen::Vector3d> sums(start.size());
  std::vector<int> counts(start.size());
  for (int round = 0; round < rounds; ++round) {
    std::fill(sums.begin(), sums.end(), Eigen::Vector3d::Zero());
    std::fill(counts.begin(), counts.end(), 0);
    for (const SurfaceMesh::Triangle& triangle : mesh.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        sums[triangle[i]] += mesh.points[triangle[(i + 1) % 3]] + mesh.points[triangle[(i + 2) % 3]];
        counts[triangle[i]] += 2;
      }
    for (std::size_t p = 0; p < start.size(); ++p) {
      Eigen::Vector3d moved = mesh.points[p] + step * (sums[p] / std::max(1, counts[p]) - mesh.points[p]);
      moved = moved.cwiseMin(start[p] + most).cwiseMax(start[p] - most);
      for (std::size_t i = 0; i < 3 && !is_ball; ++i)
        if (mesh.is_flat[p][i]) moved[static_cast<Eigen::Index>(i)] = start[p][static_cast<Eigen::Index>(i)];
      const bool on_ball = is_ball && is_flat(mesh.is_flat[p]) && start[p].norm() > EIGEN_PI - 1e-9;
      mesh.points[p] = on_ball && moved.norm() > 0.0 ? Eigen::Vector3d(EIGEN_PI * moved.normalized()) : moved;
    }
  }
}

std::vector<Eigen::Vector3d> normals_of(const SurfaceMesh& mesh, const Eigen::Vector3d& edges, Of of) {
  std::vector<Eigen::Vector3d> normals(mesh.points.size(), Eigen::Vector3d::Zero());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (of == Of::inner && mesh.kinds[t] != FaceKind::inner) continue;
    const SurfaceMesh::Triangle& triangle = mesh.triangles[t];
    const Eigen::Vector3d a = mesh.points[triangle[0]].cwiseQuotient(edges),
                          b = mesh.points[triangle[1]].cwiseQuotient(edges),
                          c = mesh.points[triangle[2]].cwiseQuotient(edges);
    for (const Index corner : triangle) normals[corner] += (b - a).cross(c - a);
  }
  for (Eigen::Vector3d& normal : normals)
    if (normal.norm() > 0.0) normal.normalize();
  return normals;
}

double volume_of(const SurfaceMesh& mesh) {
  double sum = 0.0;
  for (const SurfaceMesh::Triangle& triangle : mesh.triangles)
    sum += mesh.points[triangle[0]].dot(mesh.points[triangle[1]].cross(mesh.points[triangle[2]]));
  return sum / 6.0;
}

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
