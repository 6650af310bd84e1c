// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_CONFIGURATIONS_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_CONFIGURATIONS_H

#include "parallel_aspects/aspects/pose_roadmap.h"
#include "ros/messages/conversions.h"

#include <parallel_aspects/Configuration.h>

#include <ros/time.h>

#include <cstdint>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The configurations that a request means.
struct ConfigurationAnswer {
  Status status;  ///< OK with at least one configuration, or why there is none
  ros::Time stamp;
  std::vector<SolvedPose> configurations;
};

/// What is said of a configuration besides its pose or joint values.
struct StatedSigns {
  std::vector<std::int8_t> working_mode;  ///< empty, or zeros alone, for any
  int determinant_sign = 0;               ///< of det A; 0 for any
};
StatedSigns stated_signs(const Configuration& configuration);

/// What cannot be meant by a question: a kind or signs that there are not, or fields that its kind does not
/// look at. Empty where there is nothing.
std::string fault_of(const Manipulator& manipulator, const Configuration& configuration);

/// Those of the configurations that are as stated. Where none is, the status says what they are and what was
/// stated. A sign that is exactly zero contradicts nothing.
ConfigurationAnswer as_stated(const Manipulator& manipulator, ConfigurationAnswer answer,
                              const StatedSigns& stated);

/// That an actuated joint is beyond its limits; empty where none is.
std::string beyond_limits(const Manipulator& manipulator, const JointVector& q);

/// Which margins from singularities the configurations do not keep; empty where all keep them.
std::string beyond_margins(const Manipulator& manipulator, const std::vector<SolvedPose>& configurations);

/// Every configuration with this pose, in the given working mode or, where it is empty, in all.
ConfigurationAnswer configurations_at_pose(const Manipulator& manipulator, const Pose& pose,
                                           const std::vector<std::int8_t>& working_mode);

/// Every assembly mode at these actuated joints.
ConfigurationAnswer configurations_at_joints(const Manipulator& manipulator, const JointVector& q);

/// Why a robot with these actuated joints is not at a pose, for people: nothing reaches it, or how far the
/// nearest assembly mode is from it.
std::string why_not_at(const Manipulator& manipulator, const Pose& pose, const JointVector& q);

/// Where no map exists: which component of the roadmap, which may be null, a configuration is joined to.
void report_component(const Manipulator& manipulator, const SolvedPose& solved, const PoseRoadmap* roadmap,
                      SolvedConfiguration& message);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_CONFIGURATIONS_H
