// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/plan_messages.h"

#include "ros/messages/conversions.h"

#include <cmath>
#include <cstdint>

namespace parallel_aspects {
namespace {

std::uint8_t answer_of(SameAspect answer) {
  switch (answer) {
    case SameAspect::yes:
      return PlanPathResult::YES;
    case SameAspect::no:
      return PlanPathResult::NO;
    case SameAspect::unknown:
      break;
  }
  return PlanPathResult::UNKNOWN;
}

std::vector<double> numbers(const JointVector& values) {
  return {values.data(), values.data() + values.size()};
}

}  // namespace

nav_msgs::Path path_message(const Manipulator& manipulator, const PlannedPath& path) {
  nav_msgs::Path message;
  message.header.frame_id = manipulator.base_frame();
  for (const PathPoint& point : path.points) {
    geometry_msgs::PoseStamped pose;
    pose.header = message.header;
    pose.pose = pose_message(platform_in_base(manipulator, point.pose));
    message.poses.push_back(pose);
  }
  return message;
}

trajectory_msgs::JointTrajectory trajectory_message(const Manipulator& manipulator,
                                                    const std::vector<JointWaypoint>& waypoints) {
  trajectory_msgs::JointTrajectory message;
  message.header.frame_id = manipulator.base_frame();
  for (const Leg& leg : manipulator.legs()) message.joint_names.push_back(leg.actuated_joint);
  for (const JointWaypoint& waypoint : waypoints) {
    trajectory_msgs::JointTrajectoryPoint point;
    point.positions = numbers(waypoint.q);
    point.velocities = numbers(waypoint.velocity);
    point.time_from_start.fromNSec(std::llround(waypoint.time * 1e9));
    message.points.push_back(point);
  }
  return message;
}

void write_path(const Manipulator& manipulator, const PlannedPath& path, PlanPathResult& result) {
  result.answer = answer_of(path.answer);
  result.reason = path.message;
  if (!path) return;
  result.path = path_message(manipulator, path);
  for (const PathPoint& point : path.points)
    for (const std::int8_t sign : signs_message(point.mode)) result.working_modes.push_back(sign);
  for (const PathCrossing& crossing : path.crossings) {
    result.crossings.push_back(static_cast<std::uint32_t>(crossing.point));
    result.crossings_behind.push_back(static_cast<std::uint32_t>(crossing.behind));
    result.crossing_legs.push_back(crossing.kind == Crossing::serial ? manipulator.leg(crossing.leg).name
                                                                     : std::string());
  }
  result.length = path.length;
  result.turned = path.turned;
  result.least_index = path.least_index;
  result.least_det_a = path.least_det_a;
}

void write_timing(const Manipulator& manipulator, const TimedPath& timed, PlanPathResult& result) {
  result.timing = timed.message;
  result.seconds = timed.seconds;
  result.trajectory = trajectory_message(manipulator, timed.waypoints);
}

}  // namespace parallel_aspects
