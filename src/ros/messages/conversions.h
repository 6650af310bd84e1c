// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MESSAGES_CONVERSIONS_H
#define PARALLEL_ASPECTS_ROS_MESSAGES_CONVERSIONS_H

#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/singularity/indices.h"
#include "parallel_aspects/tracking/tracker.h"
#include "ros/messages/not_a_number.h"

#include <parallel_aspects/AspectState.h>
#include <parallel_aspects/AspectSummary.h>
#include <parallel_aspects/AspectTransition.h>
#include <parallel_aspects/AssemblyCandidates.h>
#include <parallel_aspects/Jacobian.h>
#include <parallel_aspects/MetricDistance.h>
#include <parallel_aspects/SingularityReport.h>
#include <parallel_aspects/SolvedConfiguration.h>
#include <parallel_aspects/Status.h>

#include <Eigen/Geometry>
#include <ros/time.h>

#include <cstdint>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Whether maps are computed in this task space; with six degrees of freedom there are roadmaps instead.
constexpr bool has_map(TaskSpace space) noexcept { return space != TaskSpace::SE3; }

/// A pose and joint values that assemble.
struct SolvedPose {
  Pose pose;      ///< in the task frame [m, unit quaternion]
  JointVector q;  ///< [rad or m]
};

/// What a node with ~read_only answers to all that would change it.
Status refused_as_read_only();

Status make_status(std::uint8_t code, std::string message = {});
Status invalid_request(std::string message);

/// The platform frame in the base frame [m].
Eigen::Isometry3d platform_in_base(const Manipulator& manipulator, const Pose& pose);

geometry_msgs::Pose pose_message(const Eigen::Isometry3d& isometry);
geometry_msgs::Transform transform_message(const Eigen::Isometry3d& isometry);

/// The pose of the platform that a message in the base frame means, projected onto the motions that the task
/// space has. Nothing where a number is not finite, or the platform can turn and the quaternion is zero.
std::optional<Pose> pose_from_base(const Manipulator& manipulator, const geometry_msgs::Pose& pose);

/// Distance between the operational point of the message and that of its projection [m].
double distance_off_task_space(const Manipulator& manipulator, const geometry_msgs::Pose& pose);

std::vector<std::int8_t> signs_message(const WorkingMode& mode);

/// "(+,-), det A > 0"
std::string branch_text(const WorkingMode& mode, int determinant_sign);

/// "m^2/rad" for an actuated angle, "1/rad" for that of spherical links, "m" for an actuated length.
const char* inverse_entry_unit(const Leg& leg);

SolvedConfiguration solved_message(const Manipulator& manipulator, const ask::LocatedConfiguration& located,
                                   const ros::Time& stamp);

/// The assembly modes that remain possible; complete, and none, where the robot is followed.
AssemblyCandidates candidates_message(const Manipulator& manipulator, const TrackedState& tracked,
                                      const PossibleAssemblyModes& candidates, const ros::Time& stamp);

/// Upper bound of the number of aspects with a pose in the region, proved; -1 where none is.
std::int64_t count_at_most(const AspectMap& map) noexcept;

/// Of all aspects, by id.
std::vector<AspectSummary> summary_messages(const std::shared_ptr<const AspectMap>& map);

/// What the distance of the configuration at `solved` is. `of_leg`: whether the boundary is one leg's, as
/// serial singularities and limits are.
MetricDistance distance_message(const Manipulator& manipulator, const SolvedPose& solved,
                                const BoundaryDistance& distance, bool of_leg);

SingularityReport report_message(const Manipulator& manipulator, const ask::LocatedConfiguration& located,
                                 const BoundaryDistances& distances, const ros::Time& stamp);

Jacobian jacobian_message(const Manipulator& manipulator, const ask::LocatedConfiguration& located,
                          const ros::Time& stamp);

/// State of a robot that is being tracked.
AspectState state_message(const Manipulator& manipulator, const TrackedState& state, const ros::Time& stamp);

/// State that says only why nothing is known.
AspectState unknown_state(const Manipulator& manipulator, const Status& status, const ros::Time& stamp);

/// `stated_anew`: whether the assembly mode was stated since the transition before.
AspectTransition transition_message(const Manipulator& manipulator, const Transition& transition,
                                    const ros::Time& stamp, bool stated_anew = false);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MESSAGES_CONVERSIONS_H
