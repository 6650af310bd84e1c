// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/inverse_direct.h"
#include "tools/question_options.h"
#include "tools/report/answer_json.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"

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

}  // namespace

Subcommand inverse_subcommand() {
  return question_subcommand<ask::InverseQuestion>(
      "ik", "Inverse kinematics: the joint values of every working mode", inverse_report);
}

}  // namespace parallel_aspects::tools
