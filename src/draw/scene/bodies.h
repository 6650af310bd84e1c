// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SCENE_BODIES_H
#define PARALLEL_ASPECTS_DRAW_SCENE_BODIES_H

#include "draw/scene/plane_scene.h"
#include "draw/surface/joint_surface.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// What is drawn of a space, as values that say nothing of how it is painted: one colour of a surface, or of
/// a part of a plane.
struct ColoredMesh {
  int aspect = 0;           ///< id
  std::uint32_t color = 0;  ///< 0xRRGGBB
  bool is_flat = false;     ///< in a plane: the face of a section, or all of a picture of two coordinates
  std::vector<Eigen::Vector3f> points, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Segments of one colour, two points each.
struct ColoredLines {
  std::uint32_t color = 0;  ///< 0xRRGGBB
  bool is_outline = false;  ///< around the present aspect, wider than the others
  bool is_leader = false;   ///< from a label to what it names: before all else, as the label
  std::vector<Eigen::Vector3f> ends;
};

/// How high a label is, over the size of the robot.
inline constexpr double id_height = 0.045;

/// Words, as the viewer sees them.
struct Label {
  std::string text;
  std::uint32_t color = 0;
  Eigen::Vector3f at = Eigen::Vector3f::Zero();
  double share = 1.0;   ///< of `id_height`
  int aspect = 0;       ///< id of the aspect that it names; 0 for other words
  double raised = 0.0;  ///< above its place as the viewer sees it, over its height
};

/// What is drawn together.
struct PicturePart {
  std::vector<ColoredMesh> meshes;
  std::vector<ColoredLines> lines;
  std::vector<Label> labels;
};

/// A picture of the joint space of a working mode: joint values q are drawn at `at + scale * (q - middle)`,
/// in the task frame.
struct JointTile {
  WorkingMode mode;
  Eigen::Vector3d at, scale, middle;
  std::array<bool, 3> turns{};  ///< whether a joint is an angle that wraps into (-pi, pi]

  /// Where joint values are drawn [m].
  Eigen::Vector3d drawn(const JointVector& q) const;
};

/// Points moved by `offset` after they were drawn `scale` times as large.
void move(PicturePart& part, double scale, const Eigen::Vector3d& offset);

void append(PicturePart&& part, PicturePart& to);

/// What the sets of a picture are called: with six degrees of freedom they are of the positions at one
/// orientation.
inline std::string set_word(TaskSpace space) { return space == TaskSpace::SE3 ? "part" : "aspect"; }

/// How the colours of aspects are changed on surfaces, which have shadows in rviz, so that they are lighter
/// there than what lies in a plane.
enum class Tint {
  none,        ///< not at all
  light,       ///< lighter
  boundaries,  ///< lighter, and tinted by what the aspect ends at there
};

/// The colours of one picture.
class AspectPaint {
 public:
  AspectPaint(const AspectMap& map, Tint tint) : colors_(aspect_colors(map.aspects())), tint_(tint) {}

  Rgb color(int id) const { return colors_[static_cast<std::size_t>(id - 1)]; }

  /// Of a surface.
  Rgb color(int id, const std::optional<BoundaryKind>& kind) {
    const Rgb body = tint_ == Tint::none ? color(id) : lightened(color(id), 0.25);
    if (!kind) return body;
    kinds_.insert(*kind);
    return tint_ == Tint::boundaries ? mixed(body, lightened(boundary_color(*kind), 0.35), 0.55) : body;
  }

  /// Of a surface where the map ends, not the aspect.
  Rgb edge_color(int id) const { return tint_ == Tint::none ? color(id) : mixed(color(id), 0xDDDDDD, 0.55); }

  void meet(BoundaryKind kind) { kinds_.insert(kind); }
  const std::set<BoundaryKind>& kinds() const noexcept { return kinds_; }  ///< that were met

 private:
  std::vector<Rgb> colors_;  // by id - 1
  Tint tint_;
  std::set<BoundaryKind> kinds_;
};

/// An area as a mesh; `place` says where a point of the plane is drawn [m].
template <class Place>
ColoredMesh flat_mesh(const PlaneArea& area, const Place& place) {
  ColoredMesh mesh{area.aspect, area.color, true, {}, {}, {}};
  for (const auto& polygon : area.polygons) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Eigen::Vector2d& corner : polygon) mesh.points.push_back(place(corner).template cast<float>());
    for (std::uint32_t i = 2; i < polygon.size(); ++i)
      mesh.triangles.push_back({first, first + i - 1, first + i});
  }
  mesh.normals.assign(mesh.points.size(), Eigen::Vector3f::UnitZ());
  return mesh;
}

/// Boundaries in the colours of their kinds, likewise.
template <class Place>
void add_boundaries(const std::vector<BoundarySegment>& boundaries, const Place& place, AspectPaint& paint,
                    PicturePart& part) {
  for (const BoundaryCurves& curves : curves_of(boundaries)) {
    paint.meet(curves.style->kind);
    part.lines.push_back({curves.style->color, false, false, {}});
    for (const Eigen::Vector2d& end : curves.ends)
      part.lines.back().ends.push_back(place(end).template cast<float>());
  }
}

/// What pictures of one map share, each made when it is first asked for: a section that is dragged makes no
/// surface anew.
class SurfaceStore {
 public:
  explicit SurfaceStore(std::shared_ptr<const AspectMap> map) : map_(std::move(map)) {}

  const AspectMap& map() const noexcept { return *map_; }
  const Manipulator& robot() const noexcept { return *map_->manipulator(); }

  /// Of an aspect, with at most so many triangles.
  const AspectSurface& surface(int aspect, std::size_t most_triangles) {
    auto& kept = surfaces_[{aspect, most_triangles}];
    if (!kept) {
      SurfaceOptions options;
      options.most_triangles = most_triangles;
      kept = surface_of(*map_, aspect, options);
    }
    return *kept;
  }

  /// Of a map with `has_joint_surfaces`.
  const JointBlock& block() {
    if (!block_) block_ = joint_block(*map_);
    return *block_;
  }

  /// Of a map of which `JointProjection::is_possible`.
  const JointProjection& projection() {
    if (!projection_) projection_.emplace(map_);
    return *projection_;
  }

 private:
  std::shared_ptr<const AspectMap> map_;
  std::map<std::pair<int, std::size_t>, std::optional<AspectSurface>> surfaces_;
  std::optional<JointBlock> block_;
  std::optional<JointProjection> projection_;
};

/// Whether there are pictures of this map in joint space: with two and with three actuated joints.
bool has_joint_space(const AspectMap& map) noexcept;

/// A tile of joint space with edges of at most `side` around `center` [m].
JointTile joint_tile(SurfaceStore& store, const WorkingMode& mode, const Eigen::Vector3d& center,
                     double side);

/// Aspects of the working mode of a tile in the space of the actuated joints, with its frame and the names of
/// the joints.
PicturePart joint_bodies(SurfaceStore& store, AspectPaint& paint, const std::vector<int>& ids,
                         const JointTile& tile, std::size_t most_triangles, int cells);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SCENE_BODIES_H
