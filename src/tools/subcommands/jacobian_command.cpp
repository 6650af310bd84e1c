// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/jacobian.h"
#include "tools/question_options.h"
#include "tools/report/answer_json.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"

#include <algorithm>

namespace parallel_aspects::tools {
namespace {

// More are listed without their matrices.
constexpr std::size_t most_with_matrices = 4;

std::vector<std::string> with_units(const std::vector<std::string>& names,
                                    const std::vector<std::string>& units, const std::string& before = "") {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < names.size(); ++i) result.push_back(before + names[i] + " [" + units[i] + "]");
  return result;
}

std::string matrix_text(const std::string& title, const TaskMatrix& matrix,
                        const std::vector<std::string>& rows, const std::vector<std::string>& columns) {
  std::vector<std::string> titles{title};
  titles.insert(titles.end(), columns.begin(), columns.end());
  TextTable table(titles);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    std::vector<std::string> cells{rows[static_cast<std::size_t>(i)]};
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) cells.push_back(shown(matrix(i, j)));
    table.add(std::move(cells));
  }
  return table.text();
}

std::string mode_text(const ask::JacobianAt& at) { return at.mode ? to_string(*at.mode) : "B_jj = 0"; }

std::string matrices_text(TaskSpace space, const ask::JacobianAnswer& answer, const ask::JacobianAt& at) {
  if (!at.a) return "";
  std::string text = '\n' + mode_text(at) + " at " + to_string(space, at.pose) + '\n';
  if (!at.reason.empty()) text += at.reason + '\n';
  if (at.jacobian)
    text += '\n' + matrix_text("twist", *at.jacobian, with_units(answer.twist, answer.twist_units),
                               with_units(answer.joints, answer.rate_units, ">"));
  if (at.force_transmission)
    text +=
        '\n' + matrix_text("wrench", *at.force_transmission, with_units(answer.wrench, answer.wrench_units),
                           with_units(answer.joints, answer.effort_units, ">"));
  return text;
}

std::string status_text(const ask::JacobianAt& at) {
  if (at.status == ask::JacobianStatus::regular)
    return at.within_limits ? name(at.status) : "regular, outside joint limits";
  return at.status == ask::JacobianStatus::out_of_reach ? at.reason : name(at.status);
}

std::string table_text(const Manipulator& robot, const ask::JacobianAnswer& answer) {
  TextTable table({"pose", "working mode", "actuated joints", ">condition number", "status"});
  for (const ask::JacobianAt& at : answer.configurations)
    table.add({to_string(robot.task_space(), at.pose), mode_text(at), at.q.size() > 0 ? shown(at.q) : "-",
               at.condition_number ? shown(*at.condition_number) : "-", status_text(at)});
  return table.text();
}

std::string heading(const Manipulator& robot, const ask::JacobianAnswer& answer) {
  const std::string text =
      robot.name() +
      (has_hinges(robot.task_space())
           ? ": rates of the passive joints that are the pose by those of the actuated joints, moments about "
             "them by efforts of the actuated joints\n"
           : ": twist of the platform by rates of the actuated joints, wrench by their efforts; about "
             "the operational point, along the axes of the task frame\n");
  if (answer.direct_status.value_or(DirectStatus::solved) == DirectStatus::solved) return text;
  return text + "the direct problem is not solved (" + name(*answer.direct_status) +
         "): `aspects fk` says why\n";
}

Report jacobian_report(const Mechanism& mechanism, const ask::JacobianAnswer& answer) {
  const Manipulator& robot = *mechanism.manipulator();
  Report report{answer_json(robot, answer), heading(robot, answer)};
  report.json["mechanism"] = robot.name();
  if (answer.configurations.empty()) {
    report.text += "no such configuration\n";
    return report;
  }
  report.text += '\n' + table_text(robot, answer);
  if (answer.configurations.size() > most_with_matrices) {
    report.text += "\n--mode chooses one whose matrices are shown; --json has all\n";
    return report;
  }
  for (const ask::JacobianAt& at : answer.configurations)
    report.text += matrices_text(robot.task_space(), answer, at);
  return report;
}

}  // namespace

Subcommand jacobian_subcommand() {
  return question_subcommand<ask::JacobianQuestion>(
      "jacobian", "Twists of the platform by rates of the actuated joints, and wrenches by their efforts",
      jacobian_report);
}

}  // namespace parallel_aspects::tools
