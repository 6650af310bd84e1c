// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/choose.h"
#include "tools/arguments.h"
#include "tools/motion_report/plan_report.h"
#include "tools/paths/trajectory_file.h"
#include "tools/question_options.h"
#include "tools/subcommands.h"

#include <memory>
#include <string>
#include <utility>

namespace parallel_aspects::tools {
namespace {

struct ChooseArguments : QuestionArguments {
  std::string path;
};

int code_of(TrajectoryAnswer answer) {
  return answer == TrajectoryAnswer::safe     ? exit_code::ok
         : answer == TrajectoryAnswer::unsafe ? exit_code::proved_no
                                              : exit_code::not_proved;
}

Report report_of(const ChooseArguments& arguments, const Surroundings& surroundings) {
  const auto robot = robot_of(arguments);
  auto question = understood<ask::ChooseQuestion>(*robot, arguments.texts, arguments.flags);
  if (!arguments.path.empty()) question.path = read_pose_waypoints(robot->motions(), arguments.path);
  const ask::ChooseAnswer answer = asked(robot, question, surroundings);
  Report report = report_choice(*robot, answer);
  const bool counts_changes = answer.with_changes && answer.verdict() != TrajectoryAnswer::safe;
  report.exit_code = code_of(counts_changes ? answer.with_changes->answer : answer.verdict());
  return report;
}

}  // namespace

Subcommand choose_subcommand() {
  const auto arguments = std::make_shared<ChooseArguments>();
  return question_subcommand<ask::ChooseQuestion>(
      "choose", "List in which working modes a tool path or a region can be done, the best first", arguments,
      report_of, {path_option(arguments->path)}, {});
}

}  // namespace parallel_aspects::tools
