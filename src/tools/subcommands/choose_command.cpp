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

struct ChooseArguments {
  RobotChoice robot;
  std::string path;
  QuestionTexts texts;
  QuestionFlags flags;
  ConstraintArguments constraints;
};

int code_of(TrajectoryAnswer answer) {
  return answer == TrajectoryAnswer::safe     ? exit_code::ok
         : answer == TrajectoryAnswer::unsafe ? exit_code::unsafe
                                              : exit_code::unknown;
}

Report report_of(const ChooseArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto robot = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  auto question = understood<ask::ChooseQuestion>(*robot, arguments.texts, arguments.flags);
  if (!arguments.path.empty()) question.path = read_pose_waypoints(robot->task_space(), arguments.path);
  const ask::ChooseAnswer answer = asked(robot, question, surroundings);
  Report report = report_choice(*robot, answer);
  const bool counts_changes = answer.with_changes && answer.verdict() != TrajectoryAnswer::safe;
  report.exit_code = code_of(counts_changes ? answer.with_changes->answer : answer.verdict());
  return report;
}

}  // namespace

Subcommand choose_subcommand() {
  const auto arguments = std::make_shared<ChooseArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  options.push_back(path_option(arguments->path));
  for (const Option& option : question_options<ask::ChooseQuestion>(arguments->texts))
    options.push_back(option);
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"choose", "Tell in which working modes a tool path or a region can be done, the best first",
          options,
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); },
          question_flags<ask::ChooseQuestion>(arguments->flags)};
}

}  // namespace parallel_aspects::tools
