// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/direct.h"
#include "parallel_aspects/kinematics/jacobians.h"
#include "tools/numbers.h"
#include "tools/report/reports.h"
#include "tools/report/text_table.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

std::vector<std::string> actuated_joints(const Manipulator& manipulator) {
  std::vector<std::string> names;
  for (const Leg& leg : manipulator.legs()) names.push_back(leg.actuated_joint);
  return names;
}

// None at a serial singularity, where the sign of a B_jj is rounding.
std::optional<WorkingMode> mode_of(const Manipulator& manipulator, const JointVector& q,
                                   const AssemblyMode& assembly) {
  return assembly.serially_singular ? std::nullopt : working_mode(manipulator, assembly.pose, q);
}

json json_assembly_mode(const Manipulator& manipulator, const JointVector& q, const AssemblyMode& assembly) {
  const auto mode = mode_of(manipulator, q, assembly);
  return {{"pose", json_pose(manipulator.task_space(), assembly.pose)},
          {"working_mode", mode ? json(mode->signs()) : json()},
          {"det_a", json_number(assembly.determinant)},
          {"residual", json_number(assembly.residual)},
          {"near_singular", assembly.near_singular},
          {"serially_singular", assembly.serially_singular},
          {"indices", json_indices(singularity_indices(manipulator, assembly.pose, q))}};
}

json json_direct(const Manipulator& manipulator, const JointVector& q, const DirectResult& result) {
  json object = {{"mechanism", manipulator.name()},
                 {"task_space", std::string(name(manipulator.task_space()))},
                 {"actuated_joints", actuated_joints(manipulator)},
                 {"joints", json_numbers(q)},
                 {"within_limits", manipulator.within_limits(q)},
                 {"status", name(result.status)},
                 {"assembly_modes", json::array()}};
  for (const AssemblyMode& assembly : result.solutions)
    object["assembly_modes"].push_back(json_assembly_mode(manipulator, q, assembly));
  return object;
}

std::string joints_text(const Manipulator& manipulator, const JointVector& q) {
  std::string text;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    text += (j == 0 ? "" : ", ") + leg.actuated_joint + " " + shown(q[static_cast<Eigen::Index>(j)]) + " " +
            joint_unit(leg);
  }
  return text;
}

// Those at a serial singularity are counted too, and distinguished.
std::string count_text(const std::vector<AssemblyMode>& solutions) {
  const auto serial = static_cast<std::size_t>(
      std::count_if(solutions.begin(), solutions.end(),
                    [](const AssemblyMode& assembly) { return assembly.serially_singular; }));
  const std::string text = counted(solutions.size(), "assembly mode");
  return serial == 0 ? text : text + ", " + std::to_string(serial) + " of them at a serial singularity";
}

std::string summary(const DirectResult& result) {
  switch (result.status) {
    case DirectStatus::solved:
      return count_text(result.solutions);
    case DirectStatus::continuum:
      return "the platform can move with the actuated joints locked, so there is no list of assembly modes";
    case DirectStatus::unsolved:
      break;
  }
  return "not solved; the list of assembly modes may be incomplete";
}

std::string direct_text(const Manipulator& manipulator, const JointVector& q, const DirectResult& result) {
  std::string text =
      manipulator.name() + " at " + joints_text(manipulator, q) + ": " + summary(result) + "\n";
  if (!manipulator.within_limits(q)) text += "note: a joint value is outside its joint limits\n";
  if (result.solutions.empty()) return text;
  TextTable table({"pose", "working mode", ">" + determinant_heading(manipulator), ">smallest singular value",
                   "near singular"});
  for (const AssemblyMode& assembly : result.solutions) {
    const auto mode = mode_of(manipulator, q, assembly);
    table.add({to_string(manipulator.task_space(), assembly.pose), mode ? to_string(*mode) : "B_jj = 0",
               shown(assembly.determinant),
               shown(singularity_indices(manipulator, assembly.pose, q).smallest_singular_value),
               assembly.near_singular ? "yes" : "no"});
  }
  return text + '\n' + table.text();
}

JointVector parse_joints(const Manipulator& manipulator, const std::string& text) {
  Problems problems;
  const std::vector<double> numbers = parse_numbers("--joints", text, actuated_joints(manipulator), problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

Report report_direct(const Mechanism& mechanism, const JointVector& q, const DirectResult& result) {
  const Manipulator& manipulator = *mechanism.manipulator();
  return {json_direct(manipulator, q, result), direct_text(manipulator, q, result)};
}

Subcommand direct_subcommand() {
  const auto choice = std::make_shared<RobotChoice>();
  const auto text = std::make_shared<std::string>();
  std::vector<Option> options = robot_options(*choice);
  options.push_back({"--joints", "\"q1 q2\"", "Joint values in the order of the legs [rad or m]", text.get(),
                     true, Words::numbers});
  return {"fk", "Direct kinematics: the pose of every assembly mode", options,
          [choice, text](const Surroundings&) {
            const auto mechanism = load_robot(*choice);
            const Manipulator& manipulator = *mechanism->manipulator();
            const JointVector q = parse_joints(manipulator, *text);
            return report_direct(*mechanism, q, direct(manipulator, q));
          }};
}

}  // namespace parallel_aspects::tools
