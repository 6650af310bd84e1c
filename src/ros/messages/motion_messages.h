// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_MOTION_MESSAGES_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_MOTION_MESSAGES_H

#include "parallel_aspects/ask/check.h"
#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/motion/plan_path.h"

#include <parallel_aspects/CheckTrajectory.h>
#include <parallel_aspects/ChooseWorkingMode.h>
#include <parallel_aspects/ModeConnection.h>
#include <parallel_aspects/PlanPathResult.h>
#include <parallel_aspects/Status.h>

#include <nav_msgs/Path.h>
#include <trajectory_msgs/JointTrajectory.h>
#include <vector>

namespace parallel_aspects {

/// The points of a path in the base frame, with stamps of zero.
nav_msgs::Path path_message(const Manipulator& manipulator, const PlannedPath& path);

/// Waypoints with velocities; the stamp is zero, which controllers take for now.
trajectory_msgs::JointTrajectory trajectory_message(const Manipulator& manipulator,
                                                    const std::vector<JointWaypoint>& waypoints);

/// Writes the path, its changes of posture and its length into a result.
void write_path(const Manipulator& manipulator, const PlannedPath& path, PlanPathResult& result);

/// Writes what became of the trajectory into it.
void write_timing(const Manipulator& manipulator, const TimedPath& timed, PlanPathResult& result);

/// Likewise of a check.
void write_check(const Manipulator& manipulator, const ask::CheckAnswer& answer,
                 CheckTrajectory::Response& response);

/// Reads the region that a request is about: a coordinate whose ends are equal is held.
Status read_region(const Manipulator& manipulator, const ChooseWorkingMode::Request& request,
                   ask::ChooseQuestion& question);

/// Writes an answer into a response.
void write_choice(const Manipulator& manipulator, const ask::ChooseAnswer& answer,
                  ChooseWorkingMode::Response& response);

ModeConnection connection_message(const Manipulator& manipulator, const ask::ConnectionInMode& connection);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_MOTION_MESSAGES_H
