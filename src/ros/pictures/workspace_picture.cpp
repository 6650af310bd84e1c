// SPDX-License-Identifier: BSD-3-Clause
#include "ros/pictures/workspace_picture.h"

#include "ros/messages/conversions.h"
#include "ros/pictures/marker_colors.h"

#include <utility>

namespace parallel_aspects {
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
  marker.color = AspectColors(map).of(workspace.aspect);
  marker.color.a = opacity;
  array.markers.push_back(std::move(marker));
  return array;
}

}  // namespace parallel_aspects
