// SPDX-License-Identifier: BSD-3-Clause
#include "tools/motion_report/choice_report.h"

#include "tools/report/answer_json.h"
#include "tools/report/bounds_report.h"
#include "tools/report/text_table.h"

#include <string>

namespace parallel_aspects::tools {
namespace {

std::string shown_determinant_sign(int sign) { return sign == 0 ? "" : shown_sign(sign); }

void add_row(const ModeOnPath& mode, TextTable& table) {
  const bool safe = mode.clearance.has_value();
  table.add({to_string(mode.mode), name(mode.check.answer), shown_determinant_sign(mode.determinant_sign),
             mode.aspect > 0 ? std::to_string(mode.aspect) : "-",
             safe ? shown_bound(mode.clearance->lower, Side::below) : "-",
             safe ? shown_briefly(mode.clearance->time) : "-",
             safe ? shown_briefly(mode.total_travel()) : "-", safe ? shown_briefly(mode.least_time) : "-",
             safe ? "" : mode.check.reason});
}

std::string change_text(const Manipulator& manipulator, const PostureChange& change) {
  const TaskSpace space = manipulator.task_space();
  return "at " + shown(change.time) + " s from " + to_string(change.from) + " to " + to_string(change.to) +
         ": leave the path at " + to_string(space, change.pose) + ", go straight to " +
         to_string(space, change.singular) + ", where B_jj = 0 of leg '" + manipulator.leg(change.leg).name +
         "', and back; " + shown_briefly(change.detour) + " m\n";
}

std::string poses_text(TaskSpace space, const std::vector<Pose>& poses) {
  std::string text;
  for (const Pose& pose : poses) text += (text.empty() ? " (" : "; ") + to_string(space, pose);
  return text.empty() ? "" : text + ")";
}

void add_row(TaskSpace space, const ModeInRegion& mode, TextTable& table) {
  const bool safe = mode.answer == TrajectoryAnswer::safe;
  table.add({to_string(mode.mode), name(mode.answer), shown_determinant_sign(mode.determinant_sign),
             safe ? shown_bound(mode.least_index.lower, Side::below) : "-",
             safe ? "" : mode.reason + poses_text(space, mode.witnesses)});
}

std::string modes_text(const Manipulator& robot, const ask::ChooseAnswer& answer) {
  if (answer.box) {
    TextTable table({"working mode", "in one aspect", "det A", ">index at least", "why not"});
    for (const ModeInRegion& mode : answer.region.modes) add_row(robot.task_space(), mode, table);
    return table.text();
  }
  TextTable table({"working mode", "all of it", "det A", ">aspect", ">clear by [m]", ">near at [s]",
                   ">travel [" + joint_unit(robot.leg(0)) + "]", ">time [s]", "why not"});
  for (const ModeOnPath& mode : answer.path.modes) add_row(mode, table);
  return table.text();
}

std::string pair_apart_text(TaskSpace space, const ask::ChooseAnswer& answer) {
  const auto apart = answer.apart();
  return apart ? "joined in no working mode: " + to_string(space, apart->front()) + " and " +
                     to_string(space, apart->back()) + "\n"
               : "";
}

std::string changes_text(const Manipulator& robot, const ChangingPath& path) {
  std::string text =
      "\nwith changes of posture: " + std::string(name(path.answer)) + "\n" + path.reason + "\n";
  for (const PathPiece& piece : path.pieces)
    text +=
        "from " + shown(piece.start) + " s to " + shown(piece.end) + " s in " + to_string(piece.mode) + "\n";
  for (const PostureChange& change : path.changes) text += change_text(robot, change);
  return text;
}

}  // namespace

Report report_choice(const Manipulator& robot, const ask::ChooseAnswer& answer) {
  Report report{answer_json(robot, answer), ""};
  report.json["mechanism"] = robot.name();
  const Report constraints = report_constraints(robot);
  report.json.update(constraints.json);
  report.text = robot.name() + (answer.box ? ", t-connected: " : ", can be done: ") + name(answer.verdict()) +
                "\n" + answer.reason() + "\n" + pair_apart_text(robot.task_space(), answer) + "\n" +
                modes_text(robot, answer) + "\n" + constraints.text;
  if (answer.with_changes) report.text += changes_text(robot, *answer.with_changes);
  return report;
}

}  // namespace parallel_aspects::tools
