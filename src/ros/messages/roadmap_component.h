// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_ROADMAP_COMPONENT_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_ROADMAP_COMPONENT_H

#include "parallel_aspects/aspects/pose_roadmap.h"
#include "ros/messages/conversions.h"

namespace parallel_aspects {

/// Where no map exists: which component of the roadmap, which may be null, a configuration is joined to.
void report_component(const Manipulator& manipulator, const SolvedPose& solved, const PoseRoadmap* roadmap,
                      SolvedConfiguration& message);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_ROADMAP_COMPONENT_H
