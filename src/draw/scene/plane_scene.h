// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SCENE_PLANE_SCENE_H
#define PARALLEL_ASPECTS_DRAW_SCENE_PLANE_SCENE_H

#include "draw/plane/map_pictures.h"
#include "draw/plane/palette.h"
#include "parallel_aspects/aspects/aspect_map.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// What is drawn of a plane, as values that say nothing of how it is painted: on pages, as markers, in rviz's
/// display or by matplotlib.
namespace parallel_aspects {

/// One coordinate of a plane.
struct PlaneAxis {
  std::string title;                ///< with its unit
  double lower = 0.0, upper = 1.0;  ///< what is shown [m or rad]
  bool is_turn = false;             ///< from -pi to pi
};

/// A set of points of a plane.
struct PlaneArea {
  std::vector<std::vector<Eigen::Vector2d>> polygons;  ///< convex, turned the same way
  Rgb color = 0;
  std::string label;  ///< written on it; empty for none
  std::string title;  ///< what it is
  int aspect = 0;     ///< id; 0 for no aspect
};

/// A line, of a colour of its own.
struct PlaneLine {
  std::vector<Eigen::Vector2d> points;
  Rgb color = 0;
  std::string title;  ///< what it is
};

/// A point, with what is written beside it.
struct PlaneMark {
  Eigen::Vector2d at;
  std::string label;
  bool is_ring = false;  ///< a circle in place of a dot
};

/// What is drawn of a plane, from the bottom to the top. Points are in its coordinates.
struct PlaneScene {
  std::string caption;
  std::array<PlaneAxis, 2> axes;
  bool keeps_proportion = false;  ///< whether both axes have one scale
  std::vector<PlaneArea> areas;
  std::vector<LevelSegment> levels;
  std::vector<BoundarySegment> boundaries;
  std::vector<PlaneLine> lines;
  std::vector<PlaneMark> marks;
};

/// The boundaries of one kind.
struct BoundaryCurves {
  const BoundaryStyle* style;         ///< of the kind; never null
  std::vector<Eigen::Vector2d> ends;  ///< of pieces, two each
};

/// Those that there are, from the bottom to the top.
std::vector<BoundaryCurves> curves_of(const std::vector<BoundarySegment>& boundaries);

/// Those that have one of these aspects on either side.
std::vector<BoundarySegment> boundaries_of(const std::vector<BoundarySegment>& boundaries,
                                           const std::set<int>& ids);

/// The ends of pieces that have the aspect on either side, two each; none for id 0.
std::vector<Eigen::Vector2d> outline_of(const std::vector<BoundarySegment>& boundaries, int aspect);

/// What a colour means: of an area, or of a line.
struct LegendEntry {
  Rgb color = 0;
  bool is_line = false;
  std::string text;
  bool is_framed = false;  ///< an area that is not seen on white without a frame
};

/// Light and dark: the sign of det A.
std::vector<LegendEntry> sign_legend();

/// The kinds of boundary that there are.
std::vector<LegendEntry> boundary_legend(const std::set<BoundaryKind>& kinds);
std::set<BoundaryKind> kinds_of(const std::vector<BoundarySegment>& boundaries);

/// "aspect 3: det A > 0, 193.6 m^2"
std::string aspect_words(const AspectMap& map, const Aspect& aspect);

/// A section through a map: what is held, or in SO3 the torsion [rad].
struct PoseSection {
  std::optional<MapSlice> slice;
  double torsion = 0.0;
};

/// A plane of poses.
struct PosePlane {
  PoseSlice slice;
  Eigen::AlignedBox2d bounds;
  std::array<PlaneAxis, 2> axes;
  bool keeps_proportion = false;
};

/// That of a map of two coordinates, or of a section through one of three.
PosePlane plane_of(const AspectMap& map, const std::optional<PoseSection>& section = std::nullopt);

/// That of a map of two coordinates, or the one of a map of all poses that `slice` cuts out.
PosePlane plane_of(const AspectMap& map, const PoseSlice& slice);

/// The coordinates of joint space, with `rim` of their range on each side where they do not wrap.
std::array<PlaneAxis, 2> joint_axes(const Manipulator& robot, const JointProjection& projection, double rim);

/// The aspects with pieces in a plane that was traced.
std::set<int> aspects_in(const BoundaryPicture& traced);

/// These aspects of one working mode in a plane of poses.
PlaneScene pose_scene(const AspectMap& map, const PosePlane& plane, const BoundaryPicture& traced,
                      const std::set<int>& ids);

/// All aspects of a working mode, traced on a grid of so many cells along an edge.
PlaneScene pose_scene(const AspectMap& map, const PosePlane& plane, const WorkingMode& mode, int cells);

/// How the pieces of an area in joint space meet: as they are, or a little enlarged, so that no gap is seen
/// between them where each is painted by itself.
enum class Pieces { exact, enlarged };

/// The same carried to joint space, with the boundaries of these aspects alone.
PlaneScene joint_scene(const AspectMap& map, const JointProjection& projection, const BoundaryPicture& traced,
                       const std::set<int>& ids, const WorkingMode& mode, Pieces pieces = Pieces::exact);

/// The polygons of an area as triangles, three corners each.
std::vector<Eigen::Vector2d> triangles_of(const PlaneArea& area);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SCENE_PLANE_SCENE_H
