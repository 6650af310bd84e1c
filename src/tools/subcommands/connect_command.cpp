// SPDX-License-Identifier: BSD-3-Clause
#include "model/spherical_links.h"
#include "parallel_aspects/ask/connect.h"
#include "tools/arguments.h"
#include "tools/question_options.h"
#include "tools/report/answer_json.h"
#include "tools/report/basins_report.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"

#include <memory>
#include <string>

namespace parallel_aspects::tools {
namespace {

struct ConnectArguments {
  RobotChoice robot;
  QuestionTexts texts;
  ConstraintArguments constraints;
};

/// A distance that is proved.
std::string clearance_text(const Manipulator& robot, double lower) {
  const DistanceUnit unit(robot);
  return shown_bound(unit.displayed(lower), Side::below) + " " + unit.name();
}

std::string connection_path_text(const Manipulator& robot, const ask::ConnectionInMode& answer) {
  std::string text = "\npath in " + to_string(answer.mode) + ":\n";
  for (const Pose& pose : answer.comparison.path) text += "  " + to_string(robot.task_space(), pose) + '\n';
  if (answer.clearance)
    text += "  proved: no singularity is nearer to it than " +
            clearance_text(robot, answer.clearance->lower) + "\n";
  return text;
}

std::string connection_text(const Manipulator& robot, const ask::ConnectAnswer& answer) {
  const TaskSpace space = robot.task_space();
  TextTable table({"working mode", "same aspect", "why"});
  std::string below;
  for (const ask::ConnectionInMode& each : answer.answers) {
    table.add({to_string(each.mode), name(each.comparison.answer), each.comparison.message});
    if (each.comparison.path.size() > 2) below += connection_path_text(robot, each);
    if (each.bottleneck)
      below += "\nin " + to_string(each.mode) +
               (each.bottleneck->found.status == BottleneckStatus::found ? " " : ": ") +
               bottleneck_text(each.bottleneck->kind, each.bottleneck->found) + "\n";
  }
  return robot.name() + ", from " + to_string(space, answer.from) + " to " + to_string(space, answer.to) +
         "\n\n" + table.text() + below;
}

/// That the answers are of a slice, and what was done to the poses.
std::string slice_text(const ask::ConnectAnswer& answer) {
  if (!answer.slice) return "";
  const std::string moved =
      answer.moved_onto_slice.value_or(0.0) > 0.0
          ? "the poses are moved onto the slice, by at most " + shown(*answer.moved_onto_slice) + " m\n"
          : "";
  return "\nslice " + to_string(*answer.slice) +
         ": aspects of the slice, of which two may be joined outside of it\n" + moved;
}

Report report_of(const ConnectArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto robot = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  const ask::ConnectAnswer answer =
      asked(robot, understood<ask::ConnectQuestion>(*robot, arguments.texts), surroundings);
  Report report{answer_json(*robot, answer), connection_text(*robot, answer)};
  report.json["mechanism"] = robot->name();
  const Report constraints = report_constraints(*robot);
  report.json.update(constraints.json);
  report.text += '\n' + constraints.text + slice_text(answer);
  return report;
}

}  // namespace

Subcommand connect_subcommand() {
  const auto arguments = std::make_shared<ConnectArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  for (const Option& option : question_options<ask::ConnectQuestion>(arguments->texts))
    options.push_back(option);
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"connect", "Tell whether two poses lie in one aspect, with a certified path", options,
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); }};
}

}  // namespace parallel_aspects::tools
