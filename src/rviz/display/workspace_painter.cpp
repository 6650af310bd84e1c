// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/workspace_painter.h"

#include "ros/labels/placed_labels.h"

#include <Eigen/Geometry>

#include "draw/plane/map_pictures.h"
#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double in_front = 0.002;       // of the robot's size: lines before the faces that they bound
constexpr std::size_t name_letters = 2;  // of a candidate, which are larger than others
constexpr Rgb edge_color = 0xDDDDDD;
constexpr std::size_t most_places = 500;  // that are looked at for a label

Vector3d scale_of(TaskSpace space, double radian) {
  if (space == TaskSpace::SO3) return Vector3d::Constant(radian);
  return {1.0, 1.0, space == TaskSpace::SE2 ? radian : 1.0};
}

}  // namespace

Vector3f LabelRoom::roomiest(const std::optional<Vector3d>& robot) const {
  const std::size_t step = std::max<std::size_t>(1, places.size() / most_places);
  Vector3f best = places.front();
  float most = -1.0F;
  for (std::size_t i = 0; i < places.size(); i += step) {
    float room = robot ? (places[i] - robot->cast<float>()).squaredNorm() : std::numeric_limits<float>::max();
    for (const Vector3f& end : ends) room = std::min(room, (places[i] - end).squaredNorm());
    if (room <= most) continue;
    most = room;
    best = places[i];
  }
  return best;
}

Vector3d drawn_point(TaskSpace space, const Pose& pose, double radian) {
  if (space == TaskSpace::T1 || space == TaskSpace::T2) return pose.position;
  return surface_point(space, pose).cwiseProduct(scale_of(space, radian));
}

WorkspacePainter::WorkspacePainter(SurfaceStore& store, AspectPaint& paint, WorkspaceStyle style)
    : store_(store),
      paint_(paint),
      style_(std::move(style)),
      space_(store.robot().task_space()),
      scale_(scale_of(space_, style_.radian)) {}

PicturePart WorkspacePainter::draw(const std::vector<int>& ids, std::size_t most_triangles, int cells,
                                   const std::atomic<bool>& cancelled) {
  part_ = {};
  rooms_.clear();
  if (space_ == TaskSpace::T2) {
    draw_plane(ids, cells);
  } else if (has_surfaces(store_.map())) {
    for (const int id : ids)
      if (!cancelled) draw_surface(id, std::max<std::size_t>(2000, most_triangles / ids.size()));
  }
  for (const int id : ids) add_label(id);
  spread_labels();
  return std::move(part_);
}

void WorkspacePainter::draw_surface(int id, std::size_t most_triangles) {
  const AspectSurface& whole = store_.surface(id, most_triangles);
  std::optional<AspectSurface> cut;
  if (style_.section) cut = section_of(whole, *style_.section);
  const AspectSurface& surface = cut ? *cut : whole;
  const std::vector<Vector3d> normals = normals_of(surface.mesh, scale_.cwiseInverse(), Of::inner);
  struct Part {
    ColoredMesh mesh;
    std::map<std::uint32_t, std::uint32_t> points;  // of the mesh, by those of the surface
  };
  std::map<std::pair<Rgb, bool>, Part> parts;
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    const bool is_flat = surface.mesh.kinds[t] == FaceKind::section;
    const Rgb shade = triangle_color(surface, t);
    Part& part = parts[{shade, is_flat}];
    if (part.mesh.triangles.empty()) part.mesh = {id, shade, is_flat, {}, {}, {}};
    add_triangle(surface, t, normals, part.mesh, part.points);
  }
  for (auto& [key, part] : parts) {
    if (part.mesh.is_flat) add_room(part.mesh);
    part_.meshes.push_back(std::move(part.mesh));
  }
  if (cut) add_rim(surface, *style_.section);
}

Rgb WorkspacePainter::triangle_color(const AspectSurface& surface, std::size_t t) const {
  if (surface.mesh.kinds[t] == FaceKind::section) return paint_.color(surface.aspect);
  if (surface.mesh.kinds[t] == FaceKind::edge) return mixed(paint_.color(surface.aspect), edge_color, 0.55);
  return paint_.color(surface.aspect, bound_of(surface, t));
}

// Smooth parts share points; flat ones have normals of their own.
void WorkspacePainter::add_triangle(const AspectSurface& surface, std::size_t t,
                                    const std::vector<Vector3d>& normals, ColoredMesh& mesh,
                                    std::map<std::uint32_t, std::uint32_t>& points) const {
  const auto at = [&](std::uint32_t corner) {
    return Vector3d(surface.mesh.points[corner].cwiseProduct(scale_));
  };
  const auto& corners = surface.mesh.triangles[t];
  const bool is_inner = surface.mesh.kinds[t] == FaceKind::inner;
  const bool is_shared = is_inner || surface.mesh.kinds[t] == FaceKind::section;
  const Vector3d flat = (at(corners[1]) - at(corners[0])).cross(at(corners[2]) - at(corners[0])).normalized();
  const Vector3d of_face = style_.section && !is_inner && is_shared ? style_.section->normal : flat;
  std::array<std::uint32_t, 3> indices{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto next = static_cast<std::uint32_t>(mesh.points.size());
    const auto [found, is_new] = points.try_emplace(corners[i], next);
    indices[i] = is_shared ? found->second : next;
    if (is_shared && !is_new) continue;
    const bool is_smooth = is_inner && !normals[corners[i]].isZero();
    mesh.points.push_back(at(corners[i]).cast<float>());
    mesh.normals.push_back((is_smooth ? normals[corners[i]] : of_face).cast<float>());
  }
  mesh.triangles.push_back(indices);
}

void WorkspacePainter::add_room(const ColoredMesh& face) {
  std::vector<Vector3f>& places = rooms_[face.aspect].places;
  for (const auto& corners : face.triangles)
    places.push_back((face.points[corners[0]] + face.points[corners[1]] + face.points[corners[2]]) / 3.0F);
}

// Around the faces of a section, in the colours of what the aspect ends at there.
void WorkspacePainter::add_rim(const AspectSurface& surface, const HalfSpace& section) {
  std::map<BoundaryKind, ColoredLines> lines;
  ColoredLines outline{ink_color, true, {}};
  const Vector3d forward = in_front * store_.robot().size() * section.normal;
  const auto add = [&](const std::array<std::uint32_t, 2>& edge, double layer, ColoredLines& to) {
    for (const std::uint32_t end : edge)
      to.ends.emplace_back((surface.mesh.points[end].cwiseProduct(scale_) + layer * forward).cast<float>());
  };
  for (const auto& edge : surface.rim) {
    rooms_[surface.aspect].ends.push_back(surface.mesh.points[edge[0]].cwiseProduct(scale_).cast<float>());
    if (surface.aspect == style_.present) add(edge, 1.0, outline);
    const auto kind = surface.bounds[edge[0]] ? surface.bounds[edge[0]] : surface.bounds[edge[1]];
    if (!kind) continue;
    paint_.meet(*kind);
    add(edge, 2.0, lines[*kind]);
  }
  if (!outline.ends.empty()) part_.lines.push_back(std::move(outline));
  for (auto& [kind, found] : lines) {
    found.color = boundary_color(kind);
    part_.lines.push_back(std::move(found));
  }
}

void WorkspacePainter::draw_plane(const std::vector<int>& ids, int cells) {
  std::map<int, std::size_t> meshes;
  for (const int id : ids) {
    meshes[id] = part_.meshes.size();
    part_.meshes.push_back({id, paint_.color(id), true, {}, {}, {}});
  }
  const AspectMap& map = store_.map();
  for (const WorkingMode& mode : map.working_modes()) {
    const auto is_of_mode = [&](int id) {
      return map.aspects()[static_cast<std::size_t>(id - 1)].mode == mode;
    };
    if (std::none_of(ids.begin(), ids.end(), is_of_mode)) continue;
    const BoundaryPicture traced =
        trace_slice(map, mode, PoseSlice(map.manipulator()->motions(), 0.0), slice_bounds(map), cells);
    for (const BoundarySliver& sliver : traced.slivers)
      if (const auto found = meshes.find(sliver.aspect); found != meshes.end())
        add_sliver(sliver, part_.meshes[found->second]);
    add_segments(traced.segments, {ids.begin(), ids.end()});
  }
  for (const auto& [id, index] : meshes) add_room(part_.meshes[index]);
}

float WorkspacePainter::height(double layer) const {
  return static_cast<float>((layer * 0.1 - 1.0) * plane_below * store_.robot().size());
}

void WorkspacePainter::add_sliver(const BoundarySliver& sliver, ColoredMesh& mesh) const {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const Eigen::Vector2d& corner : sliver.corners) {
    mesh.points.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()), height(0.0));
    mesh.normals.push_back(Vector3f::UnitZ());
  }
  for (std::uint32_t i = 2; i < sliver.corners.size(); ++i)
    mesh.triangles.push_back({first, first + i - 1, first + i});
}

void WorkspacePainter::add_segments(const std::vector<BoundarySegment>& segments, const std::set<int>& ids) {
  std::map<BoundaryKind, ColoredLines> lines;
  ColoredLines outline{ink_color, true, {}};
  const auto add = [this](const BoundarySegment& segment, double layer, ColoredLines& to) {
    for (const Eigen::Vector2d& end : {segment.from, segment.to})
      to.ends.emplace_back(static_cast<float>(end.x()), static_cast<float>(end.y()), height(layer));
  };
  for (const BoundarySegment& segment : segments) {
    const auto bounds = [&segment](int id) { return segment.aspects[0] == id || segment.aspects[1] == id; };
    if (std::none_of(ids.begin(), ids.end(), bounds)) continue;
    paint_.meet(segment.kind);
    add(segment, 2.0, lines[segment.kind]);
    for (const int id : segment.aspects)
      if (ids.count(id) != 0) rooms_[id].ends.push_back(lines[segment.kind].ends.back());
    if (style_.present != 0 && bounds(style_.present)) add(segment, 1.0, outline);
  }
  for (auto& [kind, found] : lines) {
    found.color = boundary_color(kind);
    part_.lines.push_back(std::move(found));
  }
  if (!outline.ends.empty()) part_.lines.push_back(std::move(outline));
}

void WorkspacePainter::add_label(int id) {
  const Aspect& aspect = store_.map().aspects()[static_cast<std::size_t>(id - 1)];
  Vector3d at = drawn_point(space_, aspect.deepest, style_.radian);
  const auto room = rooms_.find(id);
  if (room != rooms_.end() && !room->second.places.empty())
    at = room->second.roomiest(style_.robot).cast<double>();
  else if (style_.section)
    return;
  std::string words = std::to_string(id);
  if (id == style_.present) words = set_word(space_) + " " + words;
  if (style_.candidates.count(id) != 0) words = set_word(space_) + " " + words + "?";
  part_.labels.push_back({words, ink_color, at.cast<float>(), 1.0, id});
}

// Aspects of several working modes, as of candidates, may be deepest at one place: one below the other there.
void WorkspacePainter::spread_labels() {
  std::vector<PlacedLabel> placed;
  for (const Vector3d& name : style_.names) placed.push_back({name, name_letters});
  for (const Label& label : part_.labels) placed.push_back({label.at.cast<double>(), label.text.size()});
  keep_apart(placed, id_height * store_.robot().size(), is_planar(space_));
  for (std::size_t i = 0; i < part_.labels.size(); ++i)
    part_.labels[i].at = placed[style_.names.size() + i].at.cast<float>();
}

}  // namespace parallel_aspects
