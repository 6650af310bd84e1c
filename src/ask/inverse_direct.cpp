// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/inverse_direct.h"

#include "model/message_text.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::ask {

std::string outside_text(const JointLimits& limits, double value) {
  return "outside its limits [" + number_text(limits.lower) + ", " + number_text(limits.upper) + "] by " +
         number_text(std::max(limits.lower - value, value - limits.upper));
}

std::string reason_of(const Manipulator& robot, const Pose& pose, const InverseSolution& solution) {
  const Leg& leg = robot.leg(solution.leg);
  const std::string who = "Leg '" + leg.name + "' ";
  if (solution.status == InverseStatus::out_of_reach)
    return who + "cannot reach " + to_string(robot.task_space(), pose) + ".";
  const double value = solution.q[static_cast<Eigen::Index>(solution.leg)];
  return who + "would need joint '" + leg.actuated_joint + "' at " + number_text(value) +
         (leg.actuated_by_angle() ? " rad, " : " m, ") + outside_text(leg.limits, value) + ".";
}

Outcome<InverseAnswer> answer(Session& session, const InverseQuestion& question, const Control& control) {
  if (!question.pose)
    return outcome_of({{ProblemKind::missing, "pose", "{pose} is required", "give the pose of the platform"}},
                      control, InverseAnswer());
  const Manipulator& robot = *session.robot();
  const Pose& pose = *question.pose;
  InverseAnswer result{robot.task_space(), pose, {}};
  for (InverseSolution& solution : inverse_in_all_modes(robot, pose)) {
    InverseInMode& found = result.solutions.emplace_back();
    if (!solution) found.reason = reason_of(robot, pose, solution);
    if (solution.status != InverseStatus::out_of_reach) {
      found.missed_margins = missed_margins(robot, pose, solution.q);
      found.indices = singularity_indices(robot, pose, solution.q);
    }
    found.solution = std::move(solution);
  }
  return outcome_of({}, control, std::move(result));
}

Outcome<DirectAnswer> answer(Session& session, const DirectQuestion& question, const Control& control) {
  if (!question.joints)
    return outcome_of(
        {{ProblemKind::missing, "joints", "{joints} is required", "give the values of the actuated joints"}},
        control, DirectAnswer());
  const Manipulator& robot = *session.robot();
  const JointVector& q = *question.joints;
  DirectResult found = direct(robot, q);
  DirectAnswer result{robot.task_space(), q, robot.within_limits(q), found.status, {}};
  for (AssemblyMode& each : found.solutions) {
    const auto mode = each.serially_singular ? std::nullopt : working_mode(robot, each.pose, q);
    const SingularityIndices indices = singularity_indices(robot, each.pose, q);
    result.assembly_modes.push_back({std::move(each), mode, indices});
  }
  return outcome_of({}, control, std::move(result));
}

}  // namespace parallel_aspects::ask
