// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/roadmap_component.h"

#include "parallel_aspects/aspects/roadmap_location.h"
#include "parallel_aspects/kinematics/jacobians.h"

namespace parallel_aspects {

void report_component(const Manipulator& manipulator, const SolvedPose& solved, const PoseRoadmap* roadmap,
                      SolvedConfiguration& message) {
  message.aspect_status = SolvedConfiguration::NO_MAP;
  const auto mode = working_mode(manipulator, solved.pose, solved.q);
  if (roadmap == nullptr || !mode) return;
  const RoadmapLocation location = locate(*roadmap, solved.pose, *mode);
  if (location.component) message.roadmap_component = *location.component + 1;
}

}  // namespace parallel_aspects
