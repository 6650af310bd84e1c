// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_WORKSPACE_PAINTER_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_WORKSPACE_PAINTER_H

#include "rviz/display/painted_parts.h"

#include <atomic>
#include <map>
#include <optional>
#include <vector>

namespace parallel_aspects {

/// How far planes lie below what is drawn, behind the robot's links; of the robot's size.
inline constexpr double plane_below = 0.01;

/// How aspects are drawn among the poses.
struct WorkspaceStyle {
  double radian = 1.0;       ///< how long an angle of one rad is drawn [m]
  int present = 0;           ///< id of the present aspect, which has an outline; 0 where none is known
  std::set<int> candidates;  ///< ids that the robot may be in
  std::optional<HalfSpace> section;  ///< what is left of surfaces, in their coordinates; nothing for all
  std::optional<Eigen::Vector3d> robot{};  ///< where it is among the points of the picture, if that is known
  std::vector<Eigen::Vector3d> names{};    ///< of candidates, which no label lies upon
};

/// A flat face of an aspect, as a label sees it.
struct LabelRoom {
  std::vector<Eigen::Vector3f> places;  ///< in the middle of its pieces
  std::vector<Eigen::Vector3f> ends;    ///< where it ends

  /// The place that is farthest from its ends and from the robot, where words cover neither. Not for a face
  /// without places.
  Eigen::Vector3f roomiest(const std::optional<Eigen::Vector3d>& robot) const;
};

/// Where a pose is in the coordinates of the picture [m].
Eigen::Vector3d drawn_point(TaskSpace space, const Pose& pose, double radian);

/// Draws aspects of a map in the workspace: areas of T2, and surfaces of three coordinates.
class WorkspacePainter {
 public:
  WorkspacePainter(SurfaceStore& store, AspectPaint& paint, WorkspaceStyle style);

  /// `most_triangles`: of all surfaces together. `cells`: of the grid that areas are traced on, along an
  /// edge.
  PicturePart draw(const std::vector<int>& ids, std::size_t most_triangles, int cells,
                   const std::atomic<bool>& cancelled);

 private:
  void draw_surface(int id, std::size_t most_triangles);
  void add_triangle(const AspectSurface& surface, std::size_t t, const std::vector<Eigen::Vector3d>& normals,
                    ColoredMesh& mesh, std::map<std::uint32_t, std::uint32_t>& points) const;
  void add_rim(const AspectSurface& surface, const HalfSpace& section);
  void draw_plane(const std::vector<int>& ids, int cells);
  void add_sliver(const BoundarySliver& sliver, ColoredMesh& mesh) const;
  void add_segments(const std::vector<BoundarySegment>& segments, const std::set<int>& ids);
  void add_room(const ColoredMesh& face);
  void add_label(int id);
  void spread_labels();
  std::uint32_t triangle_color(const AspectSurface& surface, std::size_t t) const;
  float height(double layer) const;

  SurfaceStore& store_;
  AspectPaint& paint_;
  const WorkspaceStyle style_;
  const TaskSpace space_;
  const Eigen::Vector3d scale_;     // of coordinates, to be metres
  std::map<int, LabelRoom> rooms_;  // on flat faces, by id
  PicturePart part_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_WORKSPACE_PAINTER_H
