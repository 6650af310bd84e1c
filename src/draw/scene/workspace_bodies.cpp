// SPDX-License-Identifier: BSD-3-Clause
#include "draw/scene/workspace_bodies.h"

#include "draw/scene/placed_labels.h"
#include "draw/scene/robot_lines.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double in_front = 0.002;         // of the robot's size: lines before the faces that they bound
constexpr std::size_t name_letters = 2;    // of a candidate, which are larger than others
constexpr std::size_t most_places = 500;   // that are examined for a label
constexpr int most_cells_of_sphere = 120;  // along an edge, as each is a face of its own
constexpr int most_beside = 5;             // labels one over the other on each side of the platform

Vector3d scale_of(TaskSpace space, double radian) {
  if (space == TaskSpace::SO3) return Vector3d::Constant(radian);
  return {1.0, 1.0, space == TaskSpace::SE2 ? radian : 1.0};
}

// To the right and up, as the viewer sees it.
Eigen::Vector2d seen_from_front(const Vector3d& way, TaskSpace space) {
  if (is_planar(space)) return way.head<2>();
  return {way.x(), way.z() * std::cos(view_pitch) + way.y() * std::sin(view_pitch)};
}

// Whether a box about a point overlaps what corners enclose, as they are seen: no line across one of its
// sides or of theirs parts the two.
bool overlaps(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& at,
              const Eigen::Vector2d& half) {
  const auto parts = [&](const Eigen::Vector2d& across) {
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;
    for (const Eigen::Vector2d& corner : corners) {
      lower = std::min(lower, across.dot(corner - at));
      upper = std::max(upper, across.dot(corner - at));
    }
    const double reach = across.cwiseAbs().dot(half);
    return lower > reach || upper < -reach;
  };
  if (parts(Eigen::Vector2d::UnitX()) || parts(Eigen::Vector2d::UnitY())) return false;
  for (const Eigen::Vector2d& one : corners)
    for (const Eigen::Vector2d& other : corners)
      if (parts({one.y() - other.y(), other.x() - one.x()})) return false;
  return true;
}

}  // namespace

std::vector<Vector3d> platform_corners(const Manipulator& robot, const Pose& pose) {
  std::vector<Vector3d> corners;
  bool has_size = false;
  for (const Leg& leg : robot.legs()) {
    corners.push_back(pose.orientation * leg.anchor);
    has_size = has_size || !leg.anchor.isZero();
  }
  if (!has_size || !has_translation(robot.task_space())) corners.clear();
  return corners;
}

namespace {

// The common normal of the hinges, from the side of the legs to that of the platform.
Vector3d normal_of_platform(const Manipulator& robot) {
  double side = 0.0;
  for (const Leg& leg : robot.legs()) side += leg.base_point().x();
  return side > 0.0 ? Vector3d(-Vector3d::UnitX()) : Vector3d(Vector3d::UnitX());
}

Vector3d point_on_sphere(const Manipulator& robot, const Pose& pose, double radian) {
  const PoseCoordinates angles = pose_coordinates(robot.task_space(), pose);
  const double out = 1.0 - between_sheets * std::cos(angles[angles.size() - 1]);
  return radian * out * (drawing_axes(robot) * (pose.orientation * normal_of_platform(robot)));
}

}  // namespace

Vector3d drawn_point(const Manipulator& robot, const Pose& pose, double radian) {
  const TaskSpace space = robot.task_space();
  if (space == TaskSpace::T1 || space == TaskSpace::T2) return pose.position;
  if (has_hinges(space)) return point_on_sphere(robot, pose, radian);
  return surface_point(space, pose).cwiseProduct(scale_of(space, radian));
}

namespace {

/// A flat face of an aspect, as a label sees it.
struct LabelRoom {
  std::vector<Eigen::Vector3f> places;  ///< in the middle of its pieces
  std::vector<Eigen::Vector3f> ends;    ///< where it ends

  /// The place that is farthest from its ends and from the robot, where words cover neither. Not for a face
  /// without places.
  Vector3f roomiest(const std::optional<Vector3d>& robot) const {
    const std::size_t step = std::max<std::size_t>(1, places.size() / most_places);
    Vector3f best = places.front();
    float most = -1.0F;
    for (std::size_t i = 0; i < places.size(); i += step) {
      float room =
          robot ? (places[i] - robot->cast<float>()).squaredNorm() : std::numeric_limits<float>::max();
      for (const Vector3f& end : ends) room = std::min(room, (places[i] - end).squaredNorm());
      if (room <= most) continue;
      most = room;
      best = places[i];
    }
    return best;
  }
};

class WorkspaceBodies {
 public:
  WorkspaceBodies(SurfaceStore& store, AspectPaint& paint, WorkspaceStyle style)
      : store_(store),
        paint_(paint),
        style_(std::move(style)),
        space_(store.robot().task_space()),
        scale_(scale_of(space_, style_.radian)) {}

  PicturePart draw(const std::vector<int>& ids, std::size_t most_triangles, int cells,
                   const std::atomic<bool>& cancelled) {
    part_ = {};
    rooms_.clear();
    if (space_ == TaskSpace::T2 || space_ == TaskSpace::R2) {
      draw_plane(ids, space_ == TaskSpace::R2 ? std::min(cells, most_cells_of_sphere) : cells);
    } else if (has_surfaces(store_.map())) {
      for (const int id : ids)
        if (!cancelled) draw_surface(id, std::max<std::size_t>(2000, most_triangles / ids.size()));
    }
    for (const int id : ids) add_label(id);
    spread_labels();
    return std::move(part_);
  }

 private:
  void draw_surface(int id, std::size_t most_triangles) {
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

  Rgb triangle_color(const AspectSurface& surface, std::size_t t) const {
    if (surface.mesh.kinds[t] == FaceKind::section) return paint_.color(surface.aspect);
    if (surface.mesh.kinds[t] == FaceKind::edge) return paint_.edge_color(surface.aspect);
    return paint_.color(surface.aspect, bound_of(surface, t));
  }

  // Smooth parts share points; flat ones have normals of their own.
  void add_triangle(const AspectSurface& surface, std::size_t t, const std::vector<Vector3d>& normals,
                    ColoredMesh& mesh, std::map<std::uint32_t, std::uint32_t>& points) const {
    const auto at = [&](std::uint32_t corner) {
      return Vector3d(surface.mesh.points[corner].cwiseProduct(scale_));
    };
    const auto& corners = surface.mesh.triangles[t];
    const bool is_inner = surface.mesh.kinds[t] == FaceKind::inner;
    const bool is_shared = is_inner || surface.mesh.kinds[t] == FaceKind::section;
    const Vector3d flat =
        (at(corners[1]) - at(corners[0])).cross(at(corners[2]) - at(corners[0])).normalized();
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

  void add_room(const ColoredMesh& face) {
    std::vector<Vector3f>& places = rooms_[face.aspect].places;
    for (const auto& corners : face.triangles)
      places.push_back((face.points[corners[0]] + face.points[corners[1]] + face.points[corners[2]]) / 3.0F);
  }

  // Around the faces of a section, in the colours of what the aspect ends at there.
  void add_rim(const AspectSurface& surface, const HalfSpace& section) {
    std::map<BoundaryKind, ColoredLines> lines;
    ColoredLines outline{ink_color, true, false, {}};
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

  void draw_plane(const std::vector<int>& ids, int cells) {
    const AspectMap& map = store_.map();
    const PosePlane plane = plane_of(map);
    const bool is_sphere = space_ == TaskSpace::R2;
    const auto at_layer = [&](double layer) {
      const double height = (layer * 0.1 - 1.0) * plane_below * store_.robot().size();
      return [this, &plane, is_sphere, layer, height](const Eigen::Vector2d& point) {
        if (!is_sphere) return Vector3d(point.x(), point.y(), height);
        return Vector3d((1.0 + in_front * layer) *
                        drawn_point(store_.robot(), plane.slice.pose(point), style_.radian));
      };
    };
    for (const WorkingMode& mode : map.working_modes()) {
      std::set<int> shown;
      for (const int id : ids)
        if (map.aspects()[static_cast<std::size_t>(id - 1)].mode == mode) shown.insert(id);
      if (shown.empty()) continue;
      const BoundaryPicture traced =
          trace_slice(map, mode, plane.slice, plane.bounds, cells, is_sphere ? Cells::single : Cells::merged);
      const PlaneScene scene = pose_scene(map, plane, traced, shown);
      for (const PlaneArea& area : scene.areas) {
        part_.meshes.push_back(flat_mesh(area, at_layer(0.0)));
        if (is_sphere)
          for (std::size_t i = 0; i < part_.meshes.back().points.size(); ++i)
            part_.meshes.back().normals[i] = part_.meshes.back().points[i].normalized();
        add_room(part_.meshes.back());
      }
      const std::vector<BoundarySegment> boundaries = boundaries_of(scene.boundaries, shown);
      add_boundaries(boundaries, at_layer(2.0), paint_, part_);
      for (const BoundarySegment& segment : boundaries)
        for (const int id : segment.aspects)
          if (shown.count(id) != 0) rooms_[id].ends.push_back(at_layer(2.0)(segment.to).cast<float>());
      ColoredLines outline{ink_color, true, false, {}};
      for (const Eigen::Vector2d& end : outline_of(boundaries, style_.present))
        outline.ends.push_back(at_layer(1.0)(end).cast<float>());
      if (!outline.ends.empty()) part_.lines.push_back(std::move(outline));
    }
  }

  void add_label(int id) {
    const Aspect& aspect = store_.map().aspects()[static_cast<std::size_t>(id - 1)];
    Vector3d at = drawn_point(store_.robot(), aspect.deepest, style_.radian);
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

  // What would lie upon the platform is put to its side, the present aspect and candidates first; where there
  // is no room, it is left out. Returns what each label names, behind those that lie where that is.
  std::vector<Vector3f> put_beside_platform() {
    std::vector<Vector3f> named;
    if (!style_.robot || style_.platform.empty()) return named;
    const double height = id_height * store_.robot().size();
    const auto is_first = [this](const Label& label) {
      return label.aspect == style_.present || style_.candidates.count(label.aspect) != 0;
    };
    std::stable_partition(part_.labels.begin(), part_.labels.end(), is_first);
    std::vector<Eigen::Vector2d> platform;
    for (const Vector3d& corner : style_.platform) platform.push_back(seen_from_front(corner, space_));
    const auto [left, right] = std::minmax_element(
        platform.begin(), platform.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
    std::vector<Label> kept, beside;
    std::array<int, 2> counts{};
    for (Label& label : part_.labels) {
      const Eigen::Vector2d seen = seen_from_front(label.at.cast<double>() - *style_.robot, space_);
      const double half = std::max(0.5, half_letter * static_cast<double>(label.text.size())) * height;
      if (!overlaps(platform, seen, {half, 0.5 * height})) {
        kept.push_back(std::move(label));
        continue;
      }
      const std::size_t side = seen.x() < 0.5 * (left->x() + right->x()) ? 0 : 1;
      if (counts[side]++ >= most_beside && !is_first(label)) continue;
      named.push_back(label.at);
      const double across = side == 0 ? left->x() - half - height : right->x() + half + height;
      label.at.x() = static_cast<float>(style_.robot->x() + across);
      beside.push_back(std::move(label));
    }
    part_.labels = std::move(kept);
    part_.labels.insert(part_.labels.end(), beside.begin(), beside.end());
    return named;
  }

  // Aspects of several working modes, as of candidates, may be deepest at one place: one below the other
  // there.
  void spread_labels() {
    const std::vector<Vector3f> named = put_beside_platform();
    std::vector<PlacedLabel> placed;
    for (const Vector3d& name : style_.names) placed.push_back({name, name_letters});
    for (const Label& label : part_.labels) placed.push_back({label.at.cast<double>(), label.text.size()});
    keep_apart(placed, id_height * store_.robot().size(), is_planar(space_));
    for (std::size_t i = 0; i < part_.labels.size(); ++i)
      part_.labels[i].at = placed[style_.names.size() + i].at.cast<float>();
    ColoredLines leaders{ink_color, false, true, {}};
    const std::size_t first = part_.labels.size() - named.size();
    for (std::size_t i = 0; i < named.size(); ++i) {
      const Label& label = part_.labels[first + i];
      const double half =
          half_letter * id_height * store_.robot().size() * static_cast<double>(label.text.size());
      const float towards = label.at.x() < style_.robot->x() ? 1.0F : -1.0F;
      leaders.ends.push_back(label.at + towards * static_cast<float>(half) * Vector3f::UnitX());
      leaders.ends.push_back(named[i]);
    }
    if (!named.empty()) part_.lines.push_back(std::move(leaders));
  }

  SurfaceStore& store_;
  AspectPaint& paint_;
  const WorkspaceStyle style_;
  const TaskSpace space_;
  const Eigen::Vector3d scale_;     // of coordinates, to be metres
  std::map<int, LabelRoom> rooms_;  // on flat faces, by id
  PicturePart part_;
};

}  // namespace

PicturePart workspace_bodies(SurfaceStore& store, AspectPaint& paint, const WorkspaceStyle& style,
                             const std::vector<int>& ids, std::size_t most_triangles, int cells,
                             const std::atomic<bool>& cancelled) {
  return WorkspaceBodies(store, paint, style).draw(ids, most_triangles, cells, cancelled);
}

}  // namespace parallel_aspects
