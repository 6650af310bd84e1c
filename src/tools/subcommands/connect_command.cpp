// SPDX-License-Identifier: BSD-3-Clause
#include "model/spherical_links.h"
#include "parallel_aspects/ask/connect.h"
#include "tools/question_options.h"
#include "tools/report/basins_report.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"

#include <string>

namespace parallel_aspects::tools {
namespace {

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

Report connect_report(const Manipulator& robot, const ask::ConnectQuestion& /*question*/,
                      const ask::ConnectAnswer& answer) {
  Report report = constrained_report(robot, answer, connection_text(robot, answer) + '\n');
  report.text += slice_text(answer);
  return report;
}

std::string aspect_text(const ask::LocatedConfiguration& each) {
  if (each.component) return "component " + std::to_string(*each.component + 1);
  if (!each.location) return "-";
  return *each.location ? std::to_string(each.location->aspect) : name(each.location->status);
}

Report locate_report(const Manipulator& robot, const ask::LocateQuestion& question,
                     const ask::LocateAnswer& answer) {
  TextTable table({"pose", "working mode", "det A", "actuated joints", ">aspect", ""});
  for (const ask::LocatedConfiguration& each : answer.configurations)
    table.add({to_string(robot.task_space(), each.pose), each.mode ? to_string(*each.mode) : "B_jj = 0",
               shown_sign(each.determinant_sign), shown(each.q), aspect_text(each),
               each.within_limits ? each.missed_margins : "outside joint limits"});
  const std::string text = answer.reason.empty() ? table.text() : answer.reason + "\n";
  Report report = constrained_report(robot, answer, robot.name() + "\n\n" + text + '\n');
  report.text += source_text(question.map, answer.loaded.value_or(false));
  return report;
}

}  // namespace

Subcommand connect_subcommand() {
  return question_subcommand("connect", "Decide whether two poses lie in one aspect, with a certified path",
                             connect_report);
}

Subcommand locate_subcommand() {
  return question_subcommand("locate", "Find which aspects hold a pose, or values of the actuated joints",
                             locate_report);
}

}  // namespace parallel_aspects::tools
