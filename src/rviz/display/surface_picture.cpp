// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/surface_picture.h"

#include "aspects/pictures/palette.h"
#include "aspects/surface/aspect_surface.h"
#include "parallel_aspects/aspects/pose_slice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <unordered_map>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double pi = EIGEN_PI;
constexpr std::size_t most_triangles = 120000;  // of all surfaces, so that software renders them
constexpr int plane_cells = 300;
constexpr double tint = 0.55;       // of the colour of a boundary in that of the aspect
constexpr double below = 0.01;      // of the robot's size: planes lie behind its links
constexpr double ball_share = 0.3;  // of the size of such a robot, that a turn is long
constexpr std::uint32_t edge_color = 0xDDDDDD;

std::uint32_t mixed(std::uint32_t one, std::uint32_t other, double share) {
  std::uint32_t result = 0;
  for (const unsigned shift : {0U, 8U, 16U}) {
    const double a = one >> shift & 0xFFU, b = other >> shift & 0xFFU;
    result |= static_cast<std::uint32_t>(std::lround(a + share * (b - a))) << shift;
  }
  return result;
}

const char* color_word(BoundaryKind kind) {
  switch (kind) {
    case BoundaryKind::parallel:
      return "red";
    case BoundaryKind::serial:
      return "blue";
    case BoundaryKind::passive_limit:
      return "brown";
    case BoundaryKind::cone:
      return "pink";
    case BoundaryKind::self_collision:
      return "violet";
    case BoundaryKind::obstacle:
      return "orange";
    case BoundaryKind::workspace:
      return "green";
    case BoundaryKind::margin:
      return "yellow";
    case BoundaryKind::limit:
      break;
  }
  return "grey";
}

bool turns(TaskSpace space) { return space == TaskSpace::SE2 || space == TaskSpace::SO3; }

// What coordinates are multiplied by to be metres.
Vector3d scale_of(TaskSpace space, double radian) {
  if (space == TaskSpace::SO3) return Vector3d::Constant(radian);
  return {1.0, 1.0, space == TaskSpace::SE2 ? radian : 1.0};
}

// One turn is as long as the robot is wide. Of robots that only turn, it is directions of axes that have the
// size.
double radian_of(const Manipulator& robot, const PictureChoice& choice) {
  if (!turns(robot.task_space())) return 1.0;
  if (choice.radian > 0.0) return choice.radian;
  return robot.size() * (robot.task_space() == TaskSpace::SO3 ? ball_share : 1.0) / (2.0 * pi);
}

std::string caption_of(const Aspect& aspect, bool is_present) {
  return (is_present ? "aspect " : "") + std::to_string(aspect.id);
}

/// Draws the aspects of one map one after the other.
class Painter {
 public:
  Painter(const AspectMap& map, const PictureChoice& choice, const std::optional<Pose>& present)
      : map_(map),
        robot_(*map.manipulator()),
        space_(robot_.task_space()),
        choice_(choice),
        present_(present),
        colors_(aspect_colors(map.aspects())) {
    picture_.radian = radian_of(robot_, choice);
    picture_.size = space_ == TaskSpace::SO3 ? 2.0 * pi * picture_.radian : robot_.size();
    picture_.is_cut = section().has_value();
  }

  SurfacePicture draw(const std::atomic<bool>& cancelled) {
    const std::vector<int> ids = shown_aspects(map_, choice_);
    if (space_ == TaskSpace::T2) {
      draw_plane(ids);
    } else if (has_surfaces(map_)) {
      for (const int id : ids)
        if (!cancelled) draw_surface(id, std::max<std::size_t>(4000, most_triangles / ids.size()));
    }
    for (const int id : ids) add_label(id);
    add_legend();
    for (const ColoredMesh& mesh : picture_.meshes) picture_.triangles += mesh.triangles.size();
    return std::move(picture_);
  }

 private:
  struct Part {
    ColoredMesh mesh;
    std::unordered_map<std::uint32_t, std::uint32_t> points;  // of the mesh, by those of the surface
  };

  const Aspect& aspect(int id) const { return map_.aspects()[static_cast<std::size_t>(id - 1)]; }

  // Surfaces have shadows, so that they are lighter than what lies in a plane.
  std::uint32_t color(int id) const {
    return lightened(colors_[static_cast<std::size_t>(id - 1)], space_ == TaskSpace::T2 ? 0.0 : 0.3);
  }

  std::uint32_t color(int id, BoundaryKind kind) {
    kinds_.insert(kind);
    if (!choice_.tells_boundaries) return color(id);
    return mixed(color(id), lightened(boundary_color(kind), 0.35), tint);
  }

  std::optional<HalfSpace> section() const {
    const bool at_robot = choice_.section == Section::at_robot;
    if (choice_.section == Section::none || (at_robot && !present_) || !has_surfaces(map_))
      return std::nullopt;
    const double value = at_robot ? section_value(space_, *present_, choice_.axis) : choice_.offset;
    const double sign = choice_.upper ? -1.0 : 1.0;
    return HalfSpace{sign * Vector3d::Unit(static_cast<Eigen::Index>(choice_.axis)), sign * value};
  }

  void draw_surface(int id, std::size_t most) {
    SurfaceOptions options;
    options.most_triangles = most;
    options.section = section();
    const AspectSurface surface = surface_of(map_, id, options);
    const Vector3d scale = scale_of(space_, picture_.radian);
    const std::vector<Vector3d> normals = normals_of(surface.mesh, scale.cwiseInverse(), Of::inner);
    std::map<std::pair<std::uint32_t, bool>, Part> parts;
    for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
      const bool is_cut = surface.mesh.kinds[t] == FaceKind::section;
      const std::uint32_t shade = triangle_color(surface, t);
      Part& part = parts[{shade, is_cut}];
      if (part.mesh.triangles.empty()) part.mesh = {id, shade, is_cut, {}, {}, {}};
      add_triangle(surface, t, normals, scale, part);
    }
    for (auto& [key, part] : parts) {
      if (part.mesh.is_cut) label_places_[id] = middle_of(part.mesh);
      picture_.meshes.push_back(std::move(part.mesh));
    }
  }

  // The point of a face that is nearest to the middle of its points.
  static Vector3f middle_of(const ColoredMesh& mesh) {
    Vector3f middle = Vector3f::Zero();
    for (const Vector3f& point : mesh.points) middle += point / static_cast<float>(mesh.points.size());
    return *std::min_element(mesh.points.begin(), mesh.points.end(), [&](const auto& a, const auto& b) {
      return (a - middle).squaredNorm() < (b - middle).squaredNorm();
    });
  }

  std::uint32_t triangle_color(const AspectSurface& surface, std::size_t t) {
    if (surface.mesh.kinds[t] == FaceKind::section) return color(surface.aspect);
    if (surface.mesh.kinds[t] == FaceKind::edge) return mixed(color(surface.aspect), edge_color, tint);
    std::map<BoundaryKind, int> votes;
    for (const std::uint32_t corner : surface.mesh.triangles[t])
      if (const auto bound = surface.bounds[corner]) ++votes[*bound];
    const auto most = std::max_element(votes.begin(), votes.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == votes.end() ? color(surface.aspect) : color(surface.aspect, most->first);
  }

  // Smooth parts share points; flat ones have normals of their own.
  static void add_triangle(const AspectSurface& surface, std::size_t t, const std::vector<Vector3d>& normals,
                           const Vector3d& scale, Part& part) {
    const SurfaceMesh& mesh = surface.mesh;
    const auto at = [&](std::uint32_t corner) { return Vector3d(mesh.points[corner].cwiseProduct(scale)); };
    const auto& corners = mesh.triangles[t];
    const Vector3d flat =
        (at(corners[1]) - at(corners[0])).cross(at(corners[2]) - at(corners[0])).normalized();
    std::array<std::uint32_t, 3> indices{};
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_smooth = mesh.kinds[t] == FaceKind::inner && !normals[corners[i]].isZero();
      const auto next = static_cast<std::uint32_t>(part.mesh.points.size());
      const auto [found, is_new] = part.points.try_emplace(corners[i], next);
      indices[i] = is_smooth ? found->second : next;
      if (is_smooth && !is_new) continue;
      part.mesh.points.push_back(at(corners[i]).cast<float>());
      part.mesh.normals.push_back((is_smooth ? normals[corners[i]] : flat).cast<float>());
    }
    part.mesh.triangles.push_back(indices);
  }

  void draw_plane(const std::vector<int>& ids) {
    std::map<int, std::size_t> meshes;
    for (const int id : ids) {
      meshes[id] = picture_.meshes.size();
      picture_.meshes.push_back({id, color(id), false, {}, {}, {}});
    }
    for (const WorkingMode& mode : map_.working_modes()) {
      const auto is_of_mode = [&](int id) { return aspect(id).mode == mode; };
      if (std::none_of(ids.begin(), ids.end(), is_of_mode)) continue;
      const BoundaryPicture traced =
          trace_slice(map_, mode, PoseSlice(space_, 0.0), slice_bounds(map_), plane_cells);
      for (const BoundarySliver& sliver : traced.slivers)
        if (const auto found = meshes.find(sliver.aspect); found != meshes.end())
          add_sliver(sliver, picture_.meshes[found->second]);
      add_segments(traced.segments, meshes);
    }
  }

  float height(double layer) const { return static_cast<float>((layer * 0.1 - 1.0) * below * robot_.size()); }

  void add_sliver(const BoundarySliver& sliver, ColoredMesh& mesh) const {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Eigen::Vector2d& corner : sliver.corners) {
      mesh.points.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()), height(0.0));
      mesh.normals.push_back(Vector3f::UnitZ());
    }
    for (std::uint32_t i = 2; i < sliver.corners.size(); ++i)
      mesh.triangles.push_back({first, first + i - 1, first + i});
  }

  void add_segments(const std::vector<BoundarySegment>& segments, const std::map<int, std::size_t>& meshes) {
    std::map<BoundaryKind, ColoredLines> lines;
    ColoredLines outline{0x202020, true, {}};
    const auto add = [this](const BoundarySegment& segment, double layer, ColoredLines& to) {
      for (const Eigen::Vector2d& end : {segment.from, segment.to})
        to.ends.emplace_back(static_cast<float>(end.x()), static_cast<float>(end.y()), height(layer));
    };
    for (const BoundarySegment& segment : segments) {
      const bool is_shown = meshes.count(segment.aspects[0]) + meshes.count(segment.aspects[1]) > 0;
      if (!is_shown) continue;
      kinds_.insert(segment.kind);
      add(segment, 2.0, lines[segment.kind]);
      if (choice_.aspect != 0 &&
          (segment.aspects[0] == choice_.aspect || segment.aspects[1] == choice_.aspect))
        add(segment, 1.0, outline);
    }
    for (auto& [kind, found] : lines) {
      found.color = boundary_color(kind);
      picture_.lines.push_back(std::move(found));
    }
    if (!outline.ends.empty()) picture_.lines.push_back(std::move(outline));
  }

  void add_label(int id) {
    const Aspect& here = aspect(id);
    Vector3d at = drawn_point(space_, here.deepest, picture_.radian);
    if (space_ == TaskSpace::T2) at.z() = height(4.0);
    if (picture_.is_cut) {
      const auto face = label_places_.find(id);
      if (face == label_places_.end()) return;
      at = face->second.cast<double>();
    }
    const std::uint32_t ink = id == choice_.aspect ? ink_color : readable_on(lightened(color(id), 0.3));
    picture_.labels.push_back({caption_of(here, id == choice_.aspect), ink, at.cast<float>()});
  }

  // Above the picture, as it is usually seen.
  void add_legend() {
    std::string& words = picture_.legend.text;
    words = choice_.aspect != 0 ? "The robot is in aspect " + std::to_string(choice_.aspect)
                                : "It is not known in which aspect the robot is";
    if (choice_.tells_boundaries || space_ == TaskSpace::T2)
      for (const auto& [kind, what] : boundary_words())
        if (kinds_.count(kind) != 0) words += std::string("\n") + color_word(kind) + ": " + what;
    picture_.legend.color = ink_color;
    Eigen::AlignedBox3f box;
    for (const ColoredMesh& mesh : picture_.meshes)
      for (const Vector3f& point : mesh.points) box.extend(point);
    if (box.isEmpty()) return;
    const auto margin = static_cast<float>(0.1 * picture_.size);
    picture_.legend.at = box.center();
    picture_.legend.at[is_planar(space_) ? 1 : 2] =
        (is_planar(space_) ? box.max().y() : box.max().z()) + margin;
  }

  const AspectMap& map_;
  const Manipulator& robot_;
  const TaskSpace space_;
  const PictureChoice& choice_;
  const std::optional<Pose>& present_;
  const std::vector<std::uint32_t> colors_;  // by id - 1
  std::set<BoundaryKind> kinds_;             // that were met
  std::map<int, Vector3f> label_places_;     // on faces of the section, by id
  SurfacePicture picture_;
};

}  // namespace

SurfacePicture draw_surfaces(const AspectMap& map, const PictureChoice& choice,
                             const std::optional<Pose>& present, const std::atomic<bool>& cancelled) {
  return Painter(map, choice, present).draw(cancelled);
}

std::vector<int> shown_aspects(const AspectMap& map, const PictureChoice& choice) {
  std::vector<int> ids;
  for (const Aspect& aspect : map.aspects()) {
    const bool is_of_mode = choice.mode && aspect.mode == *choice.mode;
    const bool is_shown = choice.shown == Shown::all ||
                          (choice.shown == Shown::chosen && choice.chosen.count(aspect.id) != 0) ||
                          (choice.shown == Shown::present_mode && is_of_mode) ||
                          (choice.shown == Shown::present_aspect && aspect.id == choice.aspect);
    if (is_shown) ids.push_back(aspect.id);
  }
  return ids;
}

std::set<int> chosen_aspects(const AspectMap& map, const std::string& text, std::string& problem) {
  static const std::regex word(R"([^\s,]*\([^)]*\)|[^\s,]+)");
  std::set<int> ids;
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) {
    const std::string name = it->str();
    bool is_known = false;
    for (const Aspect& aspect : map.aspects())
      if (name == std::to_string(aspect.id) || name == to_string(aspect.mode)) {
        ids.insert(aspect.id);
        is_known = true;
      }
    if (!is_known && problem.empty())
      problem = "'" + name + "' is no aspect of this map; give ids from 1 to " +
                std::to_string(map.aspects().size()) + ", or working modes as " +
                (map.working_modes().empty() ? "(+,-)" : to_string(map.working_modes().front())) + ".";
  }
  return ids;
}

Vector3d drawn_point(TaskSpace space, const Pose& pose, double radian) {
  if (!turns(space)) return pose.position;
  return surface_point(space, pose).cwiseProduct(scale_of(space, radian));
}

Vector3d placement(const Manipulator& manipulator, const std::optional<Pose>& present, double radian) {
  const TaskSpace space = manipulator.task_space();
  const double size = manipulator.size();
  if (space == TaskSpace::SO3) return {1.8 * pi * radian, 0.0, 0.0};
  if (space == TaskSpace::SE2) {
    const double here = present ? radian * surface_point(space, *present).z() : 0.0;
    return {0.0, 0.0, -here - below * size};
  }
  return Vector3d::Zero();
}

double section_step(const AspectMap& map, std::size_t axis) {
  const Box region = map.region();
  return region.dimension == 3 ? region.width(axis) / 128.0 : 2.0 * pi / 128.0;
}

double section_value(TaskSpace space, const Pose& pose, std::size_t axis) {
  return surface_point(space, pose)[static_cast<Eigen::Index>(axis)];
}

}  // namespace parallel_aspects
