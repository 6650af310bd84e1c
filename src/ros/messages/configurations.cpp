// SPDX-License-Identifier: BSD-3-Clause
#include "ros/messages/configurations.h"

#include "parallel_aspects/kinematics/direct.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/model/anchor_distance.h"

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

// The modes that a request names: one, or all; nothing where it is malformed.
std::vector<WorkingMode> modes_meant(const Manipulator& manipulator, const std::vector<std::int8_t>& signs) {
  if (std::all_of(signs.begin(), signs.end(), [](std::int8_t sign) { return sign == 0; }))
    return working_modes(manipulator);
  const auto mode = WorkingMode::from_signs({signs.begin(), signs.end()});
  if (!mode || mode->leg_count() != manipulator.leg_count()) return {};
  return {*mode};
}

std::string failure_text(const Manipulator& manipulator, const InverseSolution& solution) {
  const Leg& leg = manipulator.leg(solution.leg);
  return solution.status == InverseStatus::out_of_reach
             ? leg.name + " cannot reach the pose"
             : "joint " + leg.actuated_joint + " would be outside its limits in working mode " +
                   to_string(solution.mode);
}

}  // namespace

ConfigurationAnswer configurations_at_pose(const Manipulator& manipulator, const Pose& pose,
                                           const std::vector<std::int8_t>& working_mode) {
  const auto modes = modes_meant(manipulator, working_mode);
  if (modes.empty())
    return refusal(Status::INVALID_REQUEST, "working_mode must be empty, or 0, or have " +
                                                std::to_string(manipulator.leg_count()) +
                                                " entries, each 1 or -1.");
  ConfigurationAnswer answer;
  std::string failure;
  for (const WorkingMode& mode : modes) {
    const InverseSolution solution = inverse(manipulator, pose, mode);
    if (solution.status == InverseStatus::solved)
      answer.configurations.push_back({pose, solution.q});
    else
      failure = failure_text(manipulator, solution);
  }
  if (answer.configurations.empty())
    answer.status = make_status(Status::NO_SOLUTION, "No configuration: " + failure + ".");
  return answer;
}

ConfigurationAnswer configurations_at_joints(const Manipulator& manipulator, const JointVector& q,
                                             int determinant_sign) {
  if (std::abs(determinant_sign) > 1)
    return refusal(Status::INVALID_REQUEST, "determinant_sign must be 1, -1 or 0 for both.");
  const DirectResult result = direct(manipulator, q);
  if (result.status == DirectStatus::continuum)
    return refusal(
        Status::AMBIGUOUS,
        "With these actuated joints locked the platform can still move; its pose is not determined.");
  if (result.status == DirectStatus::unsolved)
    return refusal(Status::FAILED,
                   "The direct kinematics could not be solved completely for these actuated joints.");
  ConfigurationAnswer answer;
  for (const AssemblyMode& solution : result.solutions)
    if (determinant_sign == 0 || solution.determinant * determinant_sign > 0.0)
      answer.configurations.push_back({solution.pose, q});
  if (answer.configurations.empty())
    answer.status =
        make_status(Status::NO_SOLUTION, "The robot does not assemble so at these actuated joints.");
  return answer;
}

std::string why_not_at(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const ConfigurationAnswer there = configurations_at_pose(manipulator, pose, {});
  if (there.configurations.empty())
    return "It cannot be reached in any working mode. " + there.status.message;
  double nearest = std::numeric_limits<double>::infinity();
  for (const AssemblyMode& solution : direct(manipulator, q).solutions)
    nearest = std::min(nearest, anchor_distance(manipulator, pose, solution.pose));
  return std::isfinite(nearest)
             ? "The nearest assembly mode of these actuated joints is " + std::to_string(nearest) + " m away."
             : "With these actuated joints the robot does not assemble.";
}

}  // namespace parallel_aspects
