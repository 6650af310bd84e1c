// SPDX-License-Identifier: BSD-3-Clause
#include "tools/robot_report/home_report.h"

#include "model/number_text.h"
#include "model/pose_text.h"
#include "parallel_aspects/kinematics/inverse.h"

#include <algorithm>
#include <optional>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

struct TypedHome {
  AssembledConfiguration configuration;  // of what is typed
  int digits = exact_digits;
};

// All joints inside their limits, in the working mode of `home` if that is possible.
std::optional<JointVector> solved_at(const Mechanism& mechanism, const Pose& pose, const JointVector& home) {
  std::optional<JointVector> best;
  Eigen::VectorXd positions(static_cast<Eigen::Index>(mechanism.joint_names().size()));
  for (const InverseSolution& solution : inverse_in_all_modes(*mechanism.manipulator(), pose)) {
    if (solution.status != InverseStatus::solved || !mechanism.complete(pose, solution.q, positions) ||
        mechanism.joint_outside_limits(positions))
      continue;
    if (!best || (solution.q - home).norm() < (*best - home).norm()) best = solution.q;
  }
  return best;
}

TypedHome typed_home(const Mechanism& mechanism) {
  const AssembledConfiguration home = mechanism.home();
  for (const int digits : {6, pose_digits, exact_digits}) {
    const auto pose = as_typed(mechanism.manipulator()->task_space(), home.pose, digits);
    if (!pose) continue;
    if (const auto q = solved_at(mechanism, *pose, home.q)) return {{*pose, *q}, digits};
  }
  return {home, exact_digits};
}

}  // namespace

Report report_home(const Mechanism& mechanism) {
  const TaskSpace space = mechanism.manipulator()->task_space();
  const TypedHome home = typed_home(mechanism);
  std::string named;
  const PoseCoordinates coordinates =
      pose_coordinates(space, home.configuration.pose).unaryExpr(&without_noise);
  for (Eigen::Index k = 0; k < coordinates.size(); ++k)
    named += (k == 0 ? "" : ", ") + coordinate_names(space)[static_cast<std::size_t>(k)] + ' ' +
             shown(coordinates[k]);
  const TaskVector q = home.configuration.q.unaryExpr(&without_noise);
  const json object = {{"pose", json_pose(space, home.configuration.pose)},
                       {"joints", json_numbers(home.configuration.q)}};
  return {object, "home pose: " + named + " (--pose \"" +
                      pose_numbers(space, home.configuration.pose, home.digits) +
                      "\"), at the joint values " + shown(q) + "\n"};
}

}  // namespace parallel_aspects::tools
