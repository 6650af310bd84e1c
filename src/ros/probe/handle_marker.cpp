// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "parallel_aspects/model/manipulator.h"
#include "ros/pictures/marker_batch.h"
#include "ros/probe/probe_handle.h"

#include <array>

namespace parallel_aspects {
namespace {

using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::Marker;

// Shares of the size of the robot as it is drawn.
constexpr double handle_size = 0.16, ball_size = 0.035;
constexpr double handle_height = 0.1;  // of a planar robot: the mouse takes what is nearest to the viewer

// A control acts along its x axis, or in the plane across it.
InteractiveMarkerControl control(const std::string& name, std::uint8_t mode, const Eigen::Vector3d& axis) {
  const auto turn = shortest_rotation(Eigen::Vector3d::UnitX(), axis);
  InteractiveMarkerControl result;
  result.name = name;
  result.interaction_mode = mode;
  result.orientation.x = turn.x();
  result.orientation.y = turn.y();
  result.orientation.z = turn.z();
  result.orientation.w = turn.w();
  return result;
}

// What dragging the ball does, by how many directions there are to go.
std::uint8_t mode_of_ball(TaskSpace space) {
  switch (directions(space)) {
    case 0:
      return InteractiveMarkerControl::ROTATE_3D;
    case 1:
      return InteractiveMarkerControl::MOVE_AXIS;
    case 2:
      return InteractiveMarkerControl::MOVE_PLANE;
    default:  // of a number
      return InteractiveMarkerControl::MOVE_3D;
  }
}

InteractiveMarkerControl ball(const Manipulator& robot, double size) {
  const Eigen::Vector3d axis =
      directions(robot.task_space()) == 1 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
  InteractiveMarkerControl result = control("move", mode_of_ball(robot.task_space()), axis);
  result.always_visible = true;
  Marker shape;
  shape.type = Marker::SPHERE;
  shape.scale.x = shape.scale.y = shape.scale.z = ball_size * size;
  shape.pose.orientation.w = 1.0;
  if (is_planar(robot.task_space())) shape.pose.position.z = handle_height * size;
  shape.color = color(0xE07B00);
  result.markers.push_back(std::move(shape));
  return result;
}

}  // namespace

visualization_msgs::InteractiveMarker handle_marker(const Manipulator& manipulator,
                                                    const geometry_msgs::Pose& pose, double radius) {
  const TaskSpace space = manipulator.task_space();
  const double size = (space == TaskSpace::SO3 ? radius : 1.0) * manipulator.size();
  visualization_msgs::InteractiveMarker marker;
  marker.header.frame_id = manipulator.base_frame();  // stamp zero: feedback comes in this frame
  marker.name = "probe";
  marker.pose = pose;
  marker.scale = static_cast<float>(handle_size * size);
  marker.controls.push_back(ball(manipulator, size));
  const std::array<std::string, 3> names{"x", "y", "z"};
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < directions(space); ++i)
    marker.controls.push_back(control("move_" + names[i], InteractiveMarkerControl::MOVE_AXIS,
                                      axes.col(static_cast<Eigen::Index>(i))));
  const std::size_t turns = degrees_of_freedom(space) - directions(space);
  for (std::size_t i = 3 - (turns == 1 ? 1 : turns); i < 3; ++i)
    marker.controls.push_back(control("turn_" + names[i], InteractiveMarkerControl::ROTATE_AXIS,
                                      axes.col(static_cast<Eigen::Index>(i))));
  return marker;
}

}  // namespace parallel_aspects
