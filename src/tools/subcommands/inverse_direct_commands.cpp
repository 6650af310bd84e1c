// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/inverse_direct.h"
#include "tools/question_options.h"
#include "tools/report/answer_json.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

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

// A solution may ask of a passive joint what its limits forbid.
std::string status_text(const Mechanism& mechanism, const ask::InverseInMode& found,
                        const Eigen::VectorXd& positions) {
  const auto joint = mechanism.joint_outside_limits(positions);
  if (!joint) return found.missed_margins.empty() ? name(found.solution.status) : found.missed_margins;
  const double value = positions[static_cast<Eigen::Index>(*joint)];
  return "passive joint '" + mechanism.joint_names()[*joint] + "' at " + shown(value) + ", " +
         ask::outside_text(mechanism.joint_limits()[*joint], value);
}

TextTable table_for(const Manipulator& manipulator) {
  std::string joints;
  for (const Leg& leg : manipulator.legs())
    joints += (joints.empty() ? "" : ", ") + leg.actuated_joint + " [" + joint_unit(leg) + "]";
  return TextTable(
      {"working mode", joints, ">" + determinant_heading(manipulator), ">smallest singular value", "status"});
}

Report inverse_report(const Mechanism& mechanism, const ask::InverseAnswer& answer) {
  const Manipulator& manipulator = *mechanism.manipulator();
  json object = answer_json(manipulator, answer);
  object.update(json_joints(manipulator));
  TextTable table = table_for(manipulator);
  for (std::size_t i = 0; i < answer.solutions.size(); ++i) {
    const ask::InverseInMode& found = answer.solutions[i];
    const std::string mode = to_string(found.solution.mode);
    Eigen::VectorXd positions;
    if (found.indices) {
      positions = completed(mechanism, answer.pose, found.solution.q);
      object["solutions"][i]["joint_positions"] = json_joint_positions(mechanism, positions);
      object["solutions"][i]["joint_outside_limits"] = json_joint_outside_limits(mechanism, positions);
    }
    if (found.solution)
      table.add({mode, shown(found.solution.q), shown(found.indices->determinant),
                 shown(found.indices->smallest_singular_value), status_text(mechanism, found, positions)});
    else
      table.add({mode, "-", "-", "-", found.reason});
  }
  return {std::move(object), manipulator.name() + " at " + to_string(manipulator.task_space(), answer.pose) +
                                 "\n\n" + table.text()};
}

// Those at a serial singularity are counted too, and distinguished.
std::string count_text(const std::vector<ask::DirectSolution>& solutions) {
  const auto serial = std::count_if(solutions.begin(), solutions.end(), [](const ask::DirectSolution& each) {
    return each.assembly.serially_singular;
  });
  const std::string text = counted(solutions.size(), "assembly mode");
  return serial == 0 ? text : text + ", " + std::to_string(serial) + " of them at a serial singularity";
}

std::string summary(const ask::DirectAnswer& answer) {
  switch (answer.status) {
    case DirectStatus::solved:
      return count_text(answer.assembly_modes);
    case DirectStatus::continuum:
      return "the platform can move with the actuated joints locked, so there is no list of assembly modes";
    case DirectStatus::unsolved:
      break;
  }
  return "not solved; the list of assembly modes may be incomplete";
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

Report direct_report(const Mechanism& mechanism, const ask::DirectAnswer& answer) {
  const Manipulator& manipulator = *mechanism.manipulator();
  json object = answer_json(manipulator, answer);
  object.update(json_joints(manipulator));
  std::string text =
      manipulator.name() + " at " + joints_text(manipulator, answer.joints) + ": " + summary(answer) + "\n";
  if (!answer.within_limits) text += "note: a joint value is outside its joint limits\n";
  if (answer.assembly_modes.empty()) return {std::move(object), text};
  TextTable table({"pose", "working mode", ">" + determinant_heading(manipulator), ">smallest singular value",
                   "near singular"});
  for (const ask::DirectSolution& each : answer.assembly_modes)
    table.add({to_string(manipulator.task_space(), each.assembly.pose),
               each.mode ? to_string(*each.mode) : "B_jj = 0", shown(each.assembly.determinant),
               shown(each.indices.smallest_singular_value), each.assembly.near_singular ? "yes" : "no"});
  return {std::move(object), text + '\n' + table.text()};
}

}  // namespace

Subcommand inverse_subcommand() {
  return question_subcommand<ask::InverseQuestion>(
      "ik", "Inverse kinematics: the joint values of every working mode", inverse_report);
}

Subcommand direct_subcommand() {
  return question_subcommand<ask::DirectQuestion>("fk", "Direct kinematics: the pose of every assembly mode",
                                                  direct_report);
}

}  // namespace parallel_aspects::tools
