// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/plan.h"
#include "tools/arguments.h"
#include "tools/motion_report/plan_report.h"
#include "tools/output_file.h"
#include "tools/paths/trajectory_text.h"
#include "tools/question_options.h"
#include "tools/report/constraints_report.h"
#include "tools/subcommands.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

struct PlanArguments : QuestionArguments {
  std::string trajectory_file;
};

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

void check_trajectory_file(const std::string& file, Problems& problems) {
  if (!file.empty() && !ends_with(file, ".csv") && !ends_with(file, ".yaml"))
    problems.push_back("--trajectory names '" + file + "'; give a file that ends in .csv or .yaml.");
  check_output_file("--trajectory", file, problems);
}

ask::PlanQuestion read(const PlanArguments& arguments, const Manipulator& robot) {
  Problems problems;
  ask::ProblemList bounds;
  if (!arguments.texts.at("around_cusp").empty() && robot.task_space() == TaskSpace::SE2)
    refuse_other_bounds(constraint_choice(robot, arguments.constraints), robot, bounds);
  if (!bounds.empty()) refuse(bounds);
  auto question = read_question<ask::PlanQuestion>(robot, arguments.texts, problems);
  check_trajectory_file(arguments.trajectory_file, problems);
  if (!arguments.trajectory_file.empty()) question.timed_for = "{trajectory}";
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return question;
}

int code_of(SameAspect answer) {
  switch (answer) {
    case SameAspect::yes:
      return exit_code::ok;
    case SameAspect::no:
      return exit_code::proved_no;
    case SameAspect::unknown:
      break;
  }
  return exit_code::not_proved;
}

/// Writes the path in time, where that is asked for: unknown where there is none then.
void write_trajectory(const PlanArguments& arguments, const Manipulator& robot, const ask::PlanAnswer& answer,
                      const Surroundings& surroundings, Report& report) {
  const std::string& file = arguments.trajectory_file;
  report.json["trajectory_file"] = nullptr;
  if (file.empty()) return;
  if (answer.timed && *answer.timed) {
    const auto& waypoints = answer.timed->waypoints;
    report.json["trajectory_file"] = file;
    return write_output_file(
        "Trajectory", file,
        ends_with(file, ".csv") ? trajectory_csv(robot, waypoints) : trajectory_yaml(robot, waypoints));
  }
  if (answer.timed) report.exit_code = exit_code::not_proved;
  surroundings.messages << file << " is not written; what it may hold is older." << std::endl;
}

Report report_of(const PlanArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto robot = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  const ask::PlanQuestion question = read(arguments, *robot);
  ask::Session session(robot);
  const std::string file = arguments.robot.config_file();
  session.set_acceleration({mechanism->acceleration(), "write motion.acceleration into " +
                                                           (file.empty() ? "the robot's YAML" : file) +
                                                           ", or give {acceleration}"});
  const ask::PlanAnswer answer =
      required(ask::answer(session, question, ShownAnswering(surroundings).control()));
  Report report = constrained_report(*robot, answer, plan_text(*robot, answer) + '\n');
  report.exit_code = code_of(answer.path.answer);
  report.json["reason"] = reason_text(*robot, answer);
  report.text += turns_text(answer);
  if (answer.map) report.text += source_text(question.map, answer.loaded);
  report.text += text_after(*robot, answer);
  write_trajectory(arguments, *robot, answer, surroundings, report);
  return report;
}

}  // namespace

Subcommand plan_subcommand() {
  const auto arguments = std::make_shared<PlanArguments>();
  return question_subcommand<ask::PlanQuestion>(
      "plan", "Plan a path that is proved, or prove that there is none", arguments, report_of, {},
      {{"--trajectory", "FILE",
        "Write the path in time, as fast as the limits of the joints allow: a .csv, or a .yaml that rostopic "
        "publishes. `check --trajectory` reads both",
        &arguments->trajectory_file, false, Words::one, FileUse::written}});
}

}  // namespace parallel_aspects::tools
