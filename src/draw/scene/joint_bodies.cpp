// SPDX-License-Identifier: BSD-3-Clause
#include "draw/scene/bodies.h"
#include "model/message_text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr Rgb frame_color = 0x909090;

/// How many joints there are to draw.
unsigned joints_of(const AspectMap& map) { return has_joint_surfaces(map) ? 3 : 2; }

/// Their values; those of a third that is not there are zero.
JointRange<3> range_of(SurfaceStore& store) {
  if (has_joint_surfaces(store.map())) return store.block();
  const JointWindow& window = store.projection().window();
  return {Vector3d(window.lower.x(), window.lower.y(), 0.0),
          Vector3d(window.upper.x(), window.upper.y(), 0.0),
          {window.turns[0], window.turns[1], false}};
}

Vector3d placed(const JointTile& tile, const Vector3d& q) {
  return tile.at + tile.scale.cwiseProduct(q - tile.middle);
}

// Normals of the points of a mesh out of its triangles.
void add_normals(ColoredMesh& mesh) {
  mesh.normals.assign(mesh.points.size(), Eigen::Vector3f::Zero());
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.points[triangle[0]];
    const Eigen::Vector3f normal = (mesh.points[triangle[1]] - a).cross(mesh.points[triangle[2]] - a);
    for (const std::uint32_t corner : triangle) mesh.normals[corner] += normal;
  }
  for (Eigen::Vector3f& normal : mesh.normals) {
    const float length = normal.norm();
    normal = length > 0.0F ? Eigen::Vector3f(normal / length) : Eigen::Vector3f(Eigen::Vector3f::UnitZ());
  }
}

}  // namespace

bool has_joint_space(const AspectMap& map) noexcept {
  return has_joint_surfaces(map) || (JointProjection::is_possible(map) && !map.slice());
}

JointTile joint_tile(SurfaceStore& store, const WorkingMode& mode, const Vector3d& center, double side) {
  const JointRange<3> range = range_of(store);
  const Vector3d width = (range.upper - range.lower).cwiseMax(1e-9);
  JointTile tile{mode, center, side * width.cwiseInverse(), 0.5 * (range.lower + range.upper), range.turns};
  if (joints_of(store.map()) == 2) tile.scale.z() = 0.0;
  return tile;
}

namespace {

class JointBodies {
 public:
  JointBodies(SurfaceStore& store, AspectPaint& paint) : store_(store), paint_(paint) {}

  PicturePart draw(const std::vector<int>& ids, const JointTile& tile, std::size_t most_triangles,
                   int cells) {
    part_ = {};
    const std::vector<int> shown = of_mode(ids, tile.mode);
    if (has_joint_surfaces(store_.map()))
      for (const int id : shown)
        draw_surface(id, tile, std::max<std::size_t>(2000, most_triangles / shown.size()));
    else
      draw_plane(shown, tile, cells);
    add_frame(tile);
    return std::move(part_);
  }

 private:
  std::vector<int> of_mode(const std::vector<int>& ids, const WorkingMode& mode) const {
    std::vector<int> result;
    for (const int id : ids)
      if (store_.map().aspects()[static_cast<std::size_t>(id - 1)].mode == mode) result.push_back(id);
    return result;
  }

  void draw_plane(const std::vector<int>& ids, const JointTile& tile, int cells) {
    const AspectMap& map = store_.map();
    const PosePlane plane = plane_of(map);
    const BoundaryPicture traced =
        trace_slice(map, tile.mode, plane.slice, plane.bounds, cells, Cells::single);
    const PlaneScene scene =
        joint_scene(map, store_.projection(), traced, {ids.begin(), ids.end()}, tile.mode, Pieces::enlarged);
    const auto place = [&tile](double height) {
      return [&tile, height](const Eigen::Vector2d& q) {
        return Vector3d(placed(tile, Vector3d(q.x(), q.y(), 0.0)) + height * Vector3d::UnitZ());
      };
    };
    for (const PlaneArea& area : scene.areas) part_.meshes.push_back(flat_mesh(area, place(0.0)));
    add_boundaries(scene.boundaries, place(1e-3 * store_.robot().size()), paint_, part_);
  }

  void draw_surface(int id, const JointTile& tile, std::size_t most_triangles) {
    const JointSurface surface =
        joint_surface_of(store_.map(), store_.surface(id, most_triangles), store_.block());
    std::map<Rgb, std::pair<ColoredMesh, std::map<std::uint32_t, std::uint32_t>>> parts;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const Rgb shade = paint_.color(id, surface.bounds[t]);
      auto& [mesh, points] = parts[shade];
      if (mesh.triangles.empty()) mesh = {id, shade, false, {}, {}, {}};
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [found, is_new] =
            points.try_emplace(surface.triangles[t][i], static_cast<std::uint32_t>(mesh.points.size()));
        corners[i] = found->second;
        if (is_new)
          mesh.points.push_back(placed(tile, surface.points[surface.triangles[t][i]]).cast<float>());
      }
      mesh.triangles.push_back(corners);
    }
    for (auto& [shade, part] : parts) {
      add_normals(part.first);
      part_.meshes.push_back(std::move(part.first));
    }
  }

  // The edges of the tile, with the name and the ends of a joint at one along each axis.
  void add_frame(const JointTile& tile) {
    const JointRange<3> range = range_of(store_);
    const unsigned joints = joints_of(store_.map());
    ColoredLines frame{frame_color, false, false, {}};
    const auto corner = [&](unsigned bits) {
      Vector3d q = range.lower;
      for (Eigen::Index i = 0; i < 3; ++i)
        if ((bits >> i & 1U) != 0) q[i] = range.upper[i];
      return placed(tile, q);
    };
    for (unsigned axis = 0; axis < joints; ++axis)
      for (unsigned bits = 0; bits < (1U << joints); ++bits)
        if ((bits >> axis & 1U) == 0)
          for (const unsigned end : {bits, bits | 1U << axis})
            frame.ends.push_back(corner(end).cast<float>());
    part_.lines.push_back(std::move(frame));
    for (unsigned axis = 0; axis < joints; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      const Vector3d middle = 0.5 * (corner(0) + corner(1U << axis));
      const Vector3d outward = middle - 0.5 * (corner(0) + corner((1U << joints) - 1U));
      const std::string ends = number_text(range.lower[i], 3) + " to " + number_text(range.upper[i], 3);
      part_.labels.push_back({store_.robot().leg(axis).actuated_joint + "\n" + ends, ink_color,
                              (middle + 0.22 * outward).cast<float>(), 0.6});
    }
    part_.labels.push_back(
        {"joint space of " + to_string(tile.mode), ink_color,
         (tile.at + 1.12 * (corner((1U << joints) - 1U) - tile.at) - 0.56 * (corner(1) - corner(0)))
             .cast<float>(),
         0.8});
  }

  SurfaceStore& store_;
  AspectPaint& paint_;
  PicturePart part_;
};

}  // namespace

PicturePart joint_bodies(SurfaceStore& store, AspectPaint& paint, const std::vector<int>& ids,
                         const JointTile& tile, std::size_t most_triangles, int cells) {
  return JointBodies(store, paint).draw(ids, tile, most_triangles, cells);
}

}  // namespace parallel_aspects
