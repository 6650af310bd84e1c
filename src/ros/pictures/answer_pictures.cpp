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

using visualization_msgs::Marker;

constexpr int steps_of_a_segment = 20;
constexpr double line_width = 0.006, ball_width = 0.025;  // of the size of what is drawn

class PathDrawing {
 public:
  PathDrawing(const Manipulator& manipulator, double radius)
      : robot_(manipulator),
        only_turns_(!has_translation(manipulator.task_space())),
        radius_(radius),
        size_(only_turns_ ? 2.0 * radius : manipulator.size()) {
    array_.markers.resize(1);
    array_.markers.front().action = Marker::DELETEALL;
  }

  geometry_msgs::Point point(const Pose& pose) const {
    const Eigen::Isometry3d platform = platform_in_base(robot_, pose);
    const Eigen::Vector3d at =
        platform * (only_turns_ ? Eigen::Vector3d(0.0, 0.0, radius_) : Eigen::Vector3d::Zero().eval());
    geometry_msgs::Point message;
    message.x = at.x();
    message.y = at.y();
    message.z = at.z();
    return message;
  }

  Marker& add(const std::string& group, int type, double width, const std_msgs::ColorRGBA& color) {
    Marker marker;
    marker.header.frame_id = robot_.base_frame();
    marker.ns = "planned_path/" + group;
    marker.type = type;
    marker.pose.orientation.w = 1.0;
    marker.scale.x = marker.scale.y = marker.scale.z = width * size_;
    marker.color = color;
    array_.markers.push_back(marker);
    return array_.markers.back();
  }

  void extend(Marker& line, const Pose& pose, const WorkingMode& mode) const {
    line.points.push_back(point(pose));
    const InverseSolution solution = inverse(robot_, pose, mode);
    const bool solved = solution.status != InverseStatus::out_of_reach;  // else B_jj = 0, but for rounding
    line.colors.push_back(solved ? color(index_color(parallel_index(robot_, pose, solution.q)))
                                 : color(ink_color));
  }

  visualization_msgs::MarkerArray take() { return std::move(array_); }

 private:
  const Manipulator& robot_;
  bool only_turns_;
  double radius_, size_;
  visualization_msgs::MarkerArray array_;
};

}  // namespace

visualization_msgs::MarkerArray path_markers(const Manipulator& manipulator, const PlannedPath& path,
                                             const PoseBetween& between, double radius) {
  PathDrawing drawing(manipulator, radius);
  Marker& line = drawing.add("line", Marker::LINE_STRIP, line_width, color(ink_color));
  drawing.extend(line, path.points.front().pose, path.points.front().mode);
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int step = 1; step <= steps_of_a_segment; ++step)
      drawing.extend(line,
                     between(path.points[i].pose, path.points[i + 1].pose,
                             static_cast<double>(step) / static_cast<double>(steps_of_a_segment)),
                     path.points[i].mode);
  drawing.add("ends", Marker::SPHERE_LIST, ball_width, color(ink_color)).points = {
      drawing.point(path.points.front().pose), drawing.point(path.points.back().pose)};
  if (path.crossings.empty()) return drawing.take();
  Marker& gates =
      drawing.add("gates", Marker::SPHERE_LIST, ball_width, color(boundary_color(BoundaryKind::serial)));
  for (const PathCrossing& crossing : path.crossings)
    gates.points.push_back(drawing.point(path.points[crossing.point].pose));
  return drawing.take();
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
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < free_positions(*map.manipulator(), map.slice()); ++i)
    center[static_cast<Eigen::Index>(i)] = workspace.center[i];
  return map.manipulator()->task_frame() * Eigen::Translation3d(center);
}

visualization_msgs::MarkerArray workspace_markers(const AspectMap& map, const WorkspaceQuestion& question,
                                                  const RegularWorkspace& workspace) {
  visualization_msgs::MarkerArray array;
  array.markers.emplace_back();
  array.markers.back().action = Marker::DELETEALL;
  if (!(workspace.lower > 0.0)) return array;
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
