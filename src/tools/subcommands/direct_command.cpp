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

Subcommand direct_subcommand() {
  return question_subcommand<ask::DirectQuestion>("fk", "Direct kinematics: the pose of every assembly mode",
                                                  direct_report);
}

}  // namespace parallel_aspects::tools
