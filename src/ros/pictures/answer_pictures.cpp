// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/answer_pictures.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"
#include "ros/messages/conversions.h"
#include "ros/pictures/marker_batch.h"

#include <algorithm>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int steps_of_a_segment = 20;
constexpr double line_width = 0.006, ball_width = 0.025;  // of the size of what is drawn

/// Where a path is drawn, in the base frame [m].
Eigen::Vector3d path_point(const Manipulator& robot, const Pose& pose, double radius) {
  const double up = has_translation(robot.task_space()) ? 0.0 : radius;
  return platform_in_base(robot, pose) * Eigen::Vector3d(0.0, 0.0, up);
}

}  // namespace

visualization_msgs::MarkerArray path_markers(const Manipulator& manipulator, const PlannedPath& path,
                                             const PoseBetween& between, double radius) {
  const double size = has_translation(manipulator.task_space()) ? manipulator.size() : 2.0 * radius;
  const MarkerBatch::Plane base{manipulator.base_frame()};
  std::vector<Eigen::Vector3d> line, gates;
  std::vector<std_msgs::ColorRGBA> colors;
  const auto extend = [&](const Pose& pose, const WorkingMode& mode) {
    line.push_back(path_point(manipulator, pose, radius));
    const InverseSolution solution = inverse(manipulator, pose, mode);
    const bool solved = solution.status != InverseStatus::out_of_reach;  // else B_jj = 0, but for rounding
    colors.push_back(color(solved ? index_color(parallel_index(manipulator, pose, solution.q)) : ink_color));
  };
  extend(path.points.front().pose, path.points.front().mode);
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int step = 1; step <= steps_of_a_segment; ++step)
      extend(between(path.points[i].pose, path.points[i + 1].pose,
                     static_cast<double>(step) / static_cast<double>(steps_of_a_segment)),
             path.points[i].mode);
  for (const PathCrossing& crossing : path.crossings)
    gates.push_back(path_point(manipulator, path.points[crossing.point].pose, radius));
  MarkerBatch batch;
  batch.strip(base, "planned_path/line", line, colors, line_width * size);
  batch.balls(base, "planned_path/ends", {line.front(), line.back()}, ball_width * size, color(ink_color));
  batch.balls(base, "planned_path/gates", gates, ball_width * size,
              color(boundary_color(BoundaryKind::serial)));
  return batch.take();
}

namespace {

using visualization_msgs::Marker;

constexpr float opacity = 0.6F;
constexpr double flat = 0.002;  // thickness where there is none, of the robot's size

int marker_type(RegularShape shape) {
  switch (shape) {
    case RegularShape::box:
    case RegularShape::square:
      return Marker::CUBE;
    case RegularShape::disc:
    case RegularShape::cylinder:
      return Marker::CYLINDER;
    case RegularShape::ball:
      break;
  }
  return Marker::SPHERE;
}

/// Along x, y and z [m].
Eigen::Vector3d size_of_marker(const AspectMap& map, const WorkspaceQuestion& question, double size) {
  const auto lengths = lengths_of(map, question, size);
  const std::size_t free = free_positions(*map.manipulator(), map.slice());
  Eigen::Vector3d extent = Eigen::Vector3d::Constant(flat * map.manipulator()->size());
  const bool is_edged = question.shape == RegularShape::box || question.shape == RegularShape::square;
  const double first = lengths.front().second * (is_edged ? 1.0 : 2.0);
  for (std::size_t i = 0; i < free; ++i) {
    const bool has_own = is_edged && i < lengths.size();
    extent[static_cast<Eigen::Index>(i)] = has_own ? lengths[i].second : first;
  }
  if (question.shape == RegularShape::cylinder) extent.z() = lengths.back().second;
  return extent;
}

}  // namespace

Eigen::Isometry3d center_in_base(const AspectMap& map, const RegularWorkspace& workspace) {
  const Motions& motions = map.manipulator()->motions();
  const auto free = static_cast<Eigen::Index>(free_positions(*map.manipulator(), map.slice()));
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  center.head(free) = Eigen::Map<const Eigen::VectorXd>(workspace.center.data(), free);
  if (has_hinges(motions.space)) {
    const Pose pose = pose_from_coordinates(motions, center.head(free)).value_or(Pose{});
    return map.manipulator()->task_frame() * Eigen::Translation3d(pose.position) * pose.orientation;
  }
  return map.manipulator()->task_frame() * Eigen::Translation3d(center);
}

visualization_msgs::MarkerArray workspace_markers(const AspectMap& map, const WorkspaceQuestion& question,
                                                  const RegularWorkspace& workspace) {
  visualization_msgs::MarkerArray array = MarkerBatch().take();
  if (!(workspace.lower > 0.0) || has_hinges(map.manipulator()->task_space())) return array;  // of angles
  Marker marker;
  marker.header.frame_id = map.manipulator()->base_frame();
  marker.ns = "regular_workspace";
  marker.type = marker_type(question.shape);
  marker.pose = pose_message(center_in_base(map, workspace));
  const Eigen::Vector3d extent = size_of_marker(map, question, workspace.lower);
  marker.scale.x = extent.x();
  marker.scale.y = extent.y();
  marker.scale.z = extent.z();
  marker.color = color(aspect_colors(map.aspects())[static_cast<std::size_t>(workspace.aspect - 1)], opacity);
  array.markers.push_back(std::move(marker));
  return array;
}

}  // namespace parallel_aspects
