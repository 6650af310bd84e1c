// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SCENE_WORKSPACE_BODIES_H
#define PARALLEL_ASPECTS_DRAW_SCENE_WORKSPACE_BODIES_H

#include "draw/scene/bodies.h"

#include <atomic>
#include <optional>
#include <set>
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
  std::optional<Eigen::Vector3d> robot{};   ///< where it is among the points of the picture, if that is known
  std::vector<Eigen::Vector3d> platform{};  ///< corners of its platform about it [m]; none where it has none
  std::vector<Eigen::Vector3d> names{};     ///< of candidates, which no label lies upon
};

/// The anchors of the platform at a pose, about the operational point, as they are drawn among the poses;
/// none where they are that point, and of robots that only turn, which are drawn elsewhere [m].
std::vector<Eigen::Vector3d> platform_corners(const Manipulator& robot, const Pose& pose);

/// Where a pose is in the coordinates of the picture [m]. In R2 it is where the normal of the platform, which
/// is the common normal of both hinges where their angles are 0, points on a sphere about the task frame, on
/// the side that the legs leave. Two poses have one normal: those where theta2 is beyond a quarter of a turn
/// are a little farther out. In R1 likewise, on a circle.
Eigen::Vector3d drawn_point(const Manipulator& robot, const Pose& pose, double radian);

/// Aspects of a map in the workspace: areas of T2 and R2, and surfaces of three coordinates.
/// `most_triangles`: of all surfaces together. `cells`: of the grid that areas are traced on, along an edge.
PicturePart workspace_bodies(SurfaceStore& store, AspectPaint& paint, const WorkspaceStyle& style,
                             const std::vector<int>& ids, std::size_t most_triangles, int cells,
                             const std::atomic<bool>& cancelled);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SCENE_WORKSPACE_BODIES_H
