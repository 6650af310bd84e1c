// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/configurations.h"

#include "model/message_text.h"
#include "parallel_aspects/model/manipulator.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace parallel_aspects {
namespace {

bool any_meant(const std::vector<std::int8_t>& signs) {
  return std::all_of(signs.begin(), signs.end(), [](std::int8_t sign) { return sign == 0; });
}

// What the completion of rosservice fills in says nothing.
bool says_pose(const geometry_msgs::PoseStamped& stamped) {
  const geometry_msgs::Point& p = stamped.pose.position;
  const geometry_msgs::Quaternion& o = stamped.pose.orientation;
  const bool origin = p.x == 0.0 && p.y == 0.0 && p.z == 0.0 && o.x == 0.0 && o.y == 0.0 && o.z == 0.0;
  return !origin || !(o.w == 0.0 || o.w == 1.0) || !stamped.header.frame_id.empty();
}

bool says_joints(const Configuration& configuration) {
  const auto& names = configuration.joint_names;
  const auto& positions = configuration.joint_positions;
  return std::any_of(names.begin(), names.end(), [](const std::string& name) { return !name.empty(); }) ||
         std::any_of(positions.begin(), positions.end(), [](double position) { return position != 0.0; });
}

}  // namespace

std::optional<WorkingMode> stated_mode(const std::vector<std::int8_t>& signs) {
  return any_meant(signs) ? std::nullopt : WorkingMode::from_signs({signs.begin(), signs.end()});
}

bool is_mode_of(const Manipulator& manipulator, const std::vector<std::int8_t>& signs) {
  const auto mode = stated_mode(signs);
  const std::vector<WorkingMode> all = working_modes(manipulator);
  return mode ? std::find(all.begin(), all.end(), *mode) != all.end() : any_meant(signs);
}

StatedSigns stated_signs(const Configuration& configuration) {
  return {stated_mode(configuration.working_mode), configuration.determinant_sign};
}

std::string fault_of(const Manipulator& manipulator, const Configuration& configuration) {
  if (configuration.kind > Configuration::JOINTS) return "kind must be 0 (now), 1 (pose) or 2 (joints).";
  if (std::abs(configuration.determinant_sign) > 1) return "determinant_sign must be 1, -1 or 0 for both.";
  const std::optional<WorkingMode> mode = stated_mode(configuration.working_mode);
  if (mode ? mode->leg_count() != manipulator.leg_count() : !any_meant(configuration.working_mode))
    return "working_mode must be empty, or 0, or have " + std::to_string(manipulator.leg_count()) +
           " entries, each 1 or -1.";
  const std::string remedy =
      ", but kind is " + std::to_string(configuration.kind) + "; leave out what is not meant.";
  if (configuration.kind != Configuration::POSE && says_pose(configuration.pose))
    return "pose belongs to kind 1 (pose)" + remedy;
  if (configuration.kind != Configuration::JOINTS && says_joints(configuration))
    return "joint_names and joint_positions belong to kind 2 (joints)" + remedy;
  return {};
}

std::string beyond_limits(const Manipulator& manipulator, const JointVector& q) {
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    const double value = q[static_cast<Eigen::Index>(j)];
    if (leg.limits.contain(value)) continue;
    const std::string unit = leg.actuated_by_angle() ? " rad" : " m";
    return "Joint " + leg.actuated_joint + " is at " + number_text(value) + unit + ", beyond its limits " +
           number_text(leg.limits.lower) + " to " + number_text(leg.limits.upper) + unit + ".";
  }
  return {};
}

std::string beyond_margins(const std::vector<ask::LocatedConfiguration>& configurations) {
  std::string text;
  for (const ask::LocatedConfiguration& each : configurations)
    if (!each.missed_margins.empty())
      text += (text.empty() ? "In " : " In ") + (each.mode ? to_string(*each.mode) : "B_jj = 0") +
              ", det A " + (each.determinant_sign > 0 ? "> 0 " : "< 0 ") + each.missed_margins + ".";
  return text;
}

Status read_pose(const Manipulator& manipulator, const PoseTransformer& to_base,
                 const geometry_msgs::PoseStamped& message, const std::string& which, Pose& pose) {
  std::string failure;
  const auto in_base = to_base(message, failure);
  if (!in_base) return make_status(Status::NO_TRANSFORM, std::move(failure));
  const auto found = pose_from_base(manipulator, *in_base);
  if (!found)
    return invalid_request(which +
                           " must be finite, and its quaternion of unit length "
                           "where the platform turns.");
  pose = *found;
  const double off = distance_off_task_space(manipulator, *in_base);
  if (!(off > 1e-6 * manipulator.size())) return {};
  return make_status(Status::OK,
                     which + " is " + std::to_string(off) +
                         " m off the motions of the platform; the answer is about its projection.");
}

Status read_waypoints(const Manipulator& manipulator, const PoseTransformer& to_base,
                      const std::vector<geometry_msgs::PoseStamped>& poses, const std::vector<double>& times,
                      std::vector<PoseWaypoint>& waypoints) {
  Status status;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Pose pose;
    const Status read = read_pose(manipulator, to_base, poses[i], "Pose " + std::to_string(i + 1), pose);
    if (read.code != Status::OK) return read;
    if (status.message.empty()) status = read;
    waypoints.push_back({times[i], pose});
  }
  return status;
}

}  // namespace parallel_aspects
