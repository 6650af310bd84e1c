// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/configurations.h"

#include "model/message_text.h"
#include "model/spherical_links.h"
#include "parallel_aspects/ask/inverse_direct.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

ConfigurationAnswer refusal(std::uint8_t code, std::string message) {
  return {make_status(code, std::move(message)), {}, {}};
}

bool any_meant(const std::vector<std::int8_t>& signs) {
  return std::all_of(signs.begin(), signs.end(), [](std::int8_t sign) { return sign == 0; });
}

// The modes that a request names: one, or all; nothing where it is malformed.
std::vector<WorkingMode> modes_meant(const Manipulator& manipulator, const std::vector<std::int8_t>& signs) {
  if (any_meant(signs)) return working_modes(manipulator);
  const auto mode = WorkingMode::from_signs({signs.begin(), signs.end()});
  if (!mode || mode->leg_count() != manipulator.leg_count()) return {};
  return {*mode};
}

std::string fault_of_mode(const Manipulator& manipulator) {
  return "working_mode must be empty, or 0, or have " + std::to_string(manipulator.leg_count()) +
         " entries, each 1 or -1.";
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

std::string branch_text(const Manipulator& manipulator, const SolvedPose& solved) {
  const TaskVector diagonal = inverse_diagonal(manipulator, solved.pose, solved.q);
  WorkingMode mode(manipulator.leg_count());
  for (std::size_t j = 0; j < mode.leg_count(); ++j)
    mode.set_sign(j, diagonal[static_cast<Eigen::Index>(j)] < 0.0 ? -1 : 1);
  const double determinant = direct_determinant(manipulator, solved.pose, solved.q);
  return branch_text(mode, (determinant > 0.0) - (determinant < 0.0));
}

std::string text(const StatedSigns& stated) {
  std::string text;
  if (const auto mode = WorkingMode::from_signs({stated.working_mode.begin(), stated.working_mode.end()}))
    text = "working_mode " + to_string(*mode);
  if (stated.determinant_sign != 0)
    text += (text.empty() ? "determinant_sign " : ", determinant_sign ") +
            std::to_string(stated.determinant_sign);
  return text;
}

bool fits(const Manipulator& manipulator, const SolvedPose& solved, const StatedSigns& stated) {
  if (direct_determinant(manipulator, solved.pose, solved.q) * stated.determinant_sign < 0.0) return false;
  if (any_meant(stated.working_mode)) return true;
  const TaskVector diagonal = inverse_diagonal(manipulator, solved.pose, solved.q);
  for (std::size_t j = 0; j < stated.working_mode.size(); ++j)
    if (diagonal[static_cast<Eigen::Index>(j)] * stated.working_mode[j] < 0.0) return false;
  return true;
}

}  // namespace

StatedSigns stated_signs(const Configuration& configuration) {
  return {configuration.working_mode, configuration.determinant_sign};
}

std::string fault_of(const Manipulator& manipulator, const Configuration& configuration) {
  if (configuration.kind > Configuration::JOINTS) return "kind must be 0 (now), 1 (pose) or 2 (joints).";
  if (std::abs(configuration.determinant_sign) > 1) return "determinant_sign must be 1, -1 or 0 for both.";
  if (modes_meant(manipulator, configuration.working_mode).empty()) return fault_of_mode(manipulator);
  const std::string remedy =
      ", but kind is " + std::to_string(configuration.kind) + "; leave out what is not meant.";
  if (configuration.kind != Configuration::POSE && says_pose(configuration.pose))
    return "pose belongs to kind 1 (pose)" + remedy;
  if (configuration.kind != Configuration::JOINTS && says_joints(configuration))
    return "joint_names and joint_positions belong to kind 2 (joints)" + remedy;
  return {};
}

ConfigurationAnswer as_stated(const Manipulator& manipulator, ConfigurationAnswer answer,
                              const StatedSigns& stated) {
  auto& all = answer.configurations;
  const auto fitting = std::stable_partition(
      all.begin(), all.end(), [&](const SolvedPose& solved) { return fits(manipulator, solved, stated); });
  if (fitting == all.begin() && !all.empty()) {
    std::string found;
    for (const SolvedPose& solved : all)
      found += (found.empty() ? "" : " or ") + branch_text(manipulator, solved);
    answer.status = make_status(
        Status::NO_SOLUTION, "The robot is then in " + found + ", which contradicts " + text(stated) + ".");
  }
  all.erase(fitting, all.end());
  return answer;
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

std::string beyond_margins(const Manipulator& manipulator, const std::vector<SolvedPose>& configurations) {
  std::string text;
  for (const SolvedPose& solved : configurations)
    if (const std::string missed = missed_margins(manipulator, solved.pose, solved.q); !missed.empty())
      text += (text.empty() ? "In " : " In ") + branch_text(manipulator, solved) + " " + missed + ".";
  return text;
}

ConfigurationAnswer configurations_at_pose(const Manipulator& manipulator, const Pose& pose,
                                           const std::vector<std::int8_t>& working_mode) {
  const auto modes = modes_meant(manipulator, working_mode);
  if (modes.empty()) return refusal(Status::INVALID_REQUEST, fault_of_mode(manipulator));
  ConfigurationAnswer answer;
  std::string failure;
  for (const WorkingMode& mode : modes) {
    const InverseSolution solution = inverse(manipulator, pose, mode);
    if (solution.status == InverseStatus::solved)
      answer.configurations.push_back({pose, solution.q});
    else
      failure = ask::reason_of(manipulator, pose, solution);
  }
  if (answer.configurations.empty())
    answer.status = make_status(Status::NO_SOLUTION, "No configuration: " + failure);
  return answer;
}

ConfigurationAnswer configurations_at_joints(const Manipulator& manipulator, const JointVector& q) {
  const DirectResult result = direct(manipulator, q);
  if (result.status == DirectStatus::continuum)
    return refusal(
        Status::AMBIGUOUS,
        "With these actuated joints locked the platform can still move; its pose is not determined.");
  if (result.status == DirectStatus::unsolved)
    return refusal(Status::FAILED,
                   "The direct kinematics could not be solved completely for these actuated joints.");
  ConfigurationAnswer answer;
  for (const AssemblyMode& solution : result.solutions) answer.configurations.push_back({solution.pose, q});
  if (answer.configurations.empty())
    answer.status = make_status(Status::NO_SOLUTION, "The robot does not assemble at these actuated joints.");
  return answer;
}

std::string why_not_at(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const ConfigurationAnswer there = configurations_at_pose(manipulator, pose, {});
  if (there.configurations.empty())
    return "It cannot be reached in any working mode. " + there.status.message;
  double nearest = std::numeric_limits<double>::infinity();
  for (const AssemblyMode& solution : direct(manipulator, q).solutions)
    nearest = std::min(nearest, anchor_distance(manipulator, pose, solution.pose));
  return std::isfinite(nearest) ? "The nearest assembly mode of these actuated joints is " +
                                      distance_text(manipulator, nearest) + " away."
                                : "With these actuated joints the robot does not assemble.";
}

void report_component(const Manipulator& manipulator, const SolvedPose& solved, const PoseRoadmap* roadmap,
                      SolvedConfiguration& message) {
  message.aspect_status = SolvedConfiguration::NO_MAP;
  const auto mode = working_mode(manipulator, solved.pose, solved.q);
  if (roadmap == nullptr || !mode) return;
  const RoadmapLocation location = locate(*roadmap, solved.pose, *mode);
  if (location.component) message.roadmap_component = *location.component + 1;
}

}  // namespace parallel_aspects
