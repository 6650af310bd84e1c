// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/joint_painter.h"

#include "model/message_text.h"

#include <Eigen/Geometry>

#include "draw/plane/map_pictures.h"
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr Rgb frame_color = 0x909090;

/// The joint values that are drawn.
struct JointRange {
  Vector3d lower = Vector3d::Zero(), upper = Vector3d::Zero();
  std::array<bool, 3> turns{};
  std::size_t joints = 3;
};

JointRange range_of(SurfaceStore& store) {
  if (has_joint_surfaces(store.map()))
    return {store.block().lower, store.block().upper, store.block().turns, 3};
  const JointWindow& window = store.projection().window();
  JointRange range;
  range.joints = 2;
  range.lower.head<2>() = window.lower;
  range.upper.head<2>() = window.upper;
  std::copy(window.turns.begin(), window.turns.end(), range.turns.begin());
  return range;
}

Vector3d placed(const JointTile& tile, const Vector3d& q) {
  return tile.at + tile.scale.cwiseProduct(q - tile.middle);
}

Vector3d placed(const JointTile& tile, const Eigen::Vector2d& q) {
  return placed(tile, Vector3d(q.x(), q.y(), 0.0));
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

JointTile JointPainter::tile(const WorkingMode& mode, const Vector3d& center, double side) const {
  const JointRange range = range_of(store_);
  const Vector3d width = (range.upper - range.lower).cwiseMax(1e-9);
  JointTile tile{mode, center, side * width.cwiseInverse(), 0.5 * (range.lower + range.upper), range.turns};
  if (range.joints == 2) tile.scale.z() = 0.0;
  return tile;
}

PicturePart JointPainter::draw(const std::vector<int>& ids, const JointTile& tile, std::size_t most_triangles,
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

std::vector<int> JointPainter::of_mode(const std::vector<int>& ids, const WorkingMode& mode) const {
  std::vector<int> result;
  for (const int id : ids)
    if (store_.map().aspects()[static_cast<std::size_t>(id - 1)].mode == mode) result.push_back(id);
  return result;
}

void JointPainter::draw_plane(const std::vector<int>& ids, const JointTile& tile, int cells) {
  const AspectMap& map = store_.map();
  const BoundaryPicture traced = trace_slice(map, tile.mode, PoseSlice(map.manipulator()->motions(), 0.0),
                                             slice_bounds(map), cells, Cells::single);
  for (const int id : ids) {
    ColoredMesh mesh{id, paint_.color(id), true, {}, {}, {}};
    for (const Eigen::Vector2d& corner : store_.projection().triangles(id, traced.slivers)) {
      const auto next = static_cast<std::uint32_t>(mesh.points.size());
      if (next % 3 == 2) mesh.triangles.push_back({next - 2, next - 1, next});
      mesh.points.push_back(placed(tile, corner).cast<float>());
      mesh.normals.push_back(Eigen::Vector3f::UnitZ());
    }
    part_.meshes.push_back(std::move(mesh));
  }
  std::vector<BoundarySegment> segments;
  const std::set<int> shown(ids.begin(), ids.end());
  for (const BoundarySegment& segment : traced.segments)
    if (shown.count(segment.aspects[0]) + shown.count(segment.aspects[1]) > 0) segments.push_back(segment);
  std::map<BoundaryKind, ColoredLines> lines;
  for (const BoundarySegment& segment : store_.projection().images(segments, tile.mode))
    for (const Eigen::Vector2d& end : {segment.from, segment.to})
      lines[segment.kind].ends.push_back(
          (placed(tile, end) + Vector3d(0.0, 0.0, 1e-3 * store_.robot().size())).cast<float>());
  for (auto& [kind, found] : lines) {
    found.color = boundary_color(kind);
    paint_.meet(kind);
    part_.lines.push_back(std::move(found));
  }
}

void JointPainter::draw_surface(int id, const JointTile& tile, std::size_t most_triangles) {
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
      if (is_new) mesh.points.push_back(placed(tile, surface.points[surface.triangles[t][i]]).cast<float>());
    }
    mesh.triangles.push_back(corners);
  }
  for (auto& [shade, part] : parts) {
    add_normals(part.first);
    part_.meshes.push_back(std::move(part.first));
  }
}

// The edges of the tile, with the name and the ends of a joint at one along each axis.
void JointPainter::add_frame(const JointTile& tile) {
  const JointRange range = range_of(store_);
  ColoredLines frame{frame_color, false, {}};
  const auto corner = [&](unsigned bits) {
    Vector3d q = range.lower;
    for (Eigen::Index i = 0; i < 3; ++i)
      if ((bits >> i & 1U) != 0) q[i] = range.upper[i];
    return placed(tile, q);
  };
  for (unsigned axis = 0; axis < range.joints; ++axis)
    for (unsigned bits = 0; bits < (1U << range.joints); ++bits)
      if ((bits >> axis & 1U) == 0)
        for (const unsigned end : {bits, bits | 1U << axis}) frame.ends.push_back(corner(end).cast<float>());
  part_.lines.push_back(std::move(frame));
  for (unsigned axis = 0; axis < range.joints; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const Vector3d middle = 0.5 * (corner(0) + corner(1U << axis));
    const Vector3d outward = middle - 0.5 * (corner(0) + corner((1U << range.joints) - 1U));
    const std::string ends = number_text(range.lower[i], 3) + " to " + number_text(range.upper[i], 3);
    part_.labels.push_back({store_.robot().leg(axis).actuated_joint + "\n" + ends, ink_color,
                            (middle + 0.22 * outward).cast<float>(), 0.6});
  }
  part_.labels.push_back(
      {"joint space of " + to_string(tile.mode), ink_color,
       (tile.at + 1.12 * (corner((1U << range.joints) - 1U) - tile.at) - 0.56 * (corner(1) - corner(0)))
           .cast<float>(),
       0.8});
}

}  // namespace parallel_aspects
