// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/singularity/margins.h"
#include "tools/arguments.h"
#include "tools/report/reports.h"
#include "tools/report/text_table.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

/// By how much, too: what is beyond them by the rounding of a pose that was typed looks like the limit
/// itself.
std::string outside(const JointLimits& limits, double value) {
  return "outside its limits [" + shown(limits.lower) + ", " + shown(limits.upper) + "] by " +
         shown(std::max(limits.lower - value, value - limits.upper));
}

std::string reason(const Manipulator& manipulator, const Pose& pose, const InverseSolution& solution) {
  const Leg& leg = manipulator.leg(solution.leg);
  const std::string who = "Leg '" + leg.name + "' ";
  if (solution.status == InverseStatus::out_of_reach)
    return who + "cannot reach " + to_string(manipulator.task_space(), pose) + ".";
  const double value = solution.q[static_cast<Eigen::Index>(solution.leg)];
  return who + "would need joint '" + leg.actuated_joint + "' at " + shown(value) + " " + joint_unit(leg) +
         ", " + outside(leg.limits, value) + ".";
}

// Of every joint; empty where the loops do not close.
Eigen::VectorXd completed(const Mechanism& mechanism, const Pose& pose, const JointVector& q) {
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism.joint_names().size()));
  return mechanism.complete(pose, q, positions) ? positions : Eigen::VectorXd();
}

json json_joint_positions(const Mechanism& mechanism, const Eigen::VectorXd& positions) {
  if (positions.size() == 0) return nullptr;
  json object = json::object();
  for (std::size_t i = 0; i < mechanism.joint_names().size(); ++i)
    object[mechanism.joint_names()[i]] = json_number(positions[static_cast<Eigen::Index>(i)]);
  return object;
}

json json_joint_outside_limits(const Mechanism& mechanism, const Eigen::VectorXd& positions) {
  const auto joint = mechanism.joint_outside_limits(positions);
  return joint ? json(mechanism.joint_names()[*joint]) : json();
}

json json_solution(const Mechanism& mechanism, const Pose& pose, const InverseSolution& solution) {
  const Manipulator& manipulator = *mechanism.manipulator();
  json object = {{"working_mode", solution.mode.signs()}, {"status", name(solution.status)}};
  if (solution.status != InverseStatus::solved) object["reason"] = reason(manipulator, pose, solution);
  if (solution.status == InverseStatus::out_of_reach) return object;
  object["joints"] = json_numbers(solution.q);
  const Eigen::VectorXd positions = completed(mechanism, pose, solution.q);
  object["joint_positions"] = json_joint_positions(mechanism, positions);
  object["joint_outside_limits"] = json_joint_outside_limits(mechanism, positions);
  const std::string missed = missed_margins(manipulator, pose, solution.q);
  object["missed_margins"] = missed.empty() ? json() : json(missed);
  object["indices"] = json_indices(singularity_indices(manipulator, pose, solution.q));
  return object;
}

json json_inverse(const Mechanism& mechanism, const Pose& pose,
                  const std::vector<InverseSolution>& solutions) {
  const Manipulator& manipulator = *mechanism.manipulator();
  json object = {{"mechanism", manipulator.name()},
                 {"task_space", std::string(name(manipulator.task_space()))},
                 {"pose", json_pose(manipulator.task_space(), pose)},
                 {"actuated_joints", json::array()},
                 {"units", json::array()},
                 {"solutions", json::array()}};
  for (const Leg& leg : manipulator.legs()) {
    object["actuated_joints"].push_back(leg.actuated_joint);
    object["units"].push_back(joint_unit(leg));
  }
  for (const InverseSolution& solution : solutions)
    object["solutions"].push_back(json_solution(mechanism, pose, solution));
  return object;
}

// A solution may ask of a passive joint what its limits forbid.
std::string status_text(const Mechanism& mechanism, const Pose& pose, const InverseSolution& solution) {
  const Eigen::VectorXd positions = completed(mechanism, pose, solution.q);
  const auto joint = mechanism.joint_outside_limits(positions);
  if (!joint) {
    const std::string missed = missed_margins(*mechanism.manipulator(), pose, solution.q);
    return missed.empty() ? name(solution.status) : missed;
  }
  const double value = positions[static_cast<Eigen::Index>(*joint)];
  return "passive joint '" + mechanism.joint_names()[*joint] + "' at " + shown(value) + ", " +
         outside(mechanism.joint_limits()[*joint], value);
}

std::vector<std::string> row(const Mechanism& mechanism, const Pose& pose, const InverseSolution& solution) {
  const Manipulator& manipulator = *mechanism.manipulator();
  const std::string mode = to_string(solution.mode);
  if (solution.status != InverseStatus::solved)
    return {mode, "-", "-", "-", reason(manipulator, pose, solution)};
  const SingularityIndices indices = singularity_indices(manipulator, pose, solution.q);
  return {mode, shown(solution.q), shown(indices.determinant), shown(indices.smallest_singular_value),
          status_text(mechanism, pose, solution)};
}

std::string inverse_text(const Mechanism& mechanism, const Pose& pose,
                         const std::vector<InverseSolution>& solutions) {
  const Manipulator& manipulator = *mechanism.manipulator();
  std::string joints;
  for (const Leg& leg : manipulator.legs())
    joints += (joints.empty() ? "" : ", ") + leg.actuated_joint + " [" + joint_unit(leg) + "]";
  TextTable table(
      {"working mode", joints, ">" + determinant_heading(manipulator), ">smallest singular value", "status"});
  for (const InverseSolution& solution : solutions) table.add(row(mechanism, pose, solution));
  return manipulator.name() + " at " + to_string(manipulator.task_space(), pose) + "\n\n" + table.text();
}

}  // namespace

Report report_inverse(const Mechanism& mechanism, const Pose& pose,
                      const std::vector<InverseSolution>& solutions) {
  return {json_inverse(mechanism, pose, solutions), inverse_text(mechanism, pose, solutions)};
}

Subcommand inverse_subcommand() {
  const auto choice = std::make_shared<RobotChoice>();
  const auto text = std::make_shared<std::string>();
  std::vector<Option> options = robot_options(*choice);
  options.push_back(
      {"--pose", "\"x y\"", "Pose of the platform; lengths [m]", text.get(), true, Words::numbers});
  return {"ik", "Inverse kinematics: the joint values of every working mode", options,
          [choice, text](const Surroundings&) {
            const auto mechanism = load_robot(*choice);
            const Manipulator& manipulator = *mechanism->manipulator();
            Problems problems;
            const Pose pose = parse_pose("--pose", manipulator.task_space(), *text, problems);
            if (!problems.empty()) throw InvalidDescription(std::move(problems));
            return report_inverse(*mechanism, pose, inverse_in_all_modes(manipulator, pose));
          }};
}

}  // namespace parallel_aspects::tools
