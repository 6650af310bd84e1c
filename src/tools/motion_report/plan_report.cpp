// SPDX-License-Identifier: BSD-3-Clause
#include "tools/motion_report/plan_report.h"

#include "model/message_text.h"
#include "model/task_space_traits.h"
#include "motion/choose/plan_around_cusp.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"

#include <cstdlib>
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
  Report report = constrained_report(robot, answer,
                                     robot.name() + (answer.box ? ", t-connected: " : ", can be done: ") +
                                         name(answer.verdict()) + "\n" + answer.reason() + "\n" +
                                         pair_apart_text(robot.task_space(), answer) + "\n" +
                                         modes_text(robot, answer) + "\n");
  if (answer.with_changes) report.text += changes_text(robot, *answer.with_changes);
  return report;
}

namespace {

/// What happens between a point and the one before.
std::string remark(const Manipulator& manipulator, const PlannedPath& path, std::size_t point) {
  for (const PathCrossing& crossing : path.crossings) {
    if (crossing.behind != point) continue;
    const std::string text = crossing.kind == Crossing::parallel
                                 ? "det A = 0, control of the platform is lost"
                                 : "leg '" + manipulator.leg(crossing.leg).name + "' changes its posture";
    return crossing.from == 0
               ? text
               : text + ", aspect " + std::to_string(crossing.from) + " to " + std::to_string(crossing.to);
  }
  return "";
}

std::string points_text(const Manipulator& manipulator, const PlannedPath& path) {
  TextTable table({">point", "pose", "working mode", "actuated joints", ""});
  for (std::size_t i = 0; i < path.points.size(); ++i)
    table.add({std::to_string(i), to_string(manipulator.task_space(), path.points[i].pose),
               to_string(path.points[i].mode), shown(path.points[i].q), remark(manipulator, path, i)});
  return table.text();
}

std::string length_text(const Manipulator& manipulator, const PlannedPath& path) {
  std::string text;
  if (traits(manipulator.task_space()).translations > 0) text = shown(path.length) + " m";
  if (traits(manipulator.task_space()).rotations > 0)
    text += (text.empty() ? "" : ", turning by ") + shown(path.turned) + " rad";
  return text;
}

/// Where to begin in place of a start without a path around a cusp, with digits that take it onto the slice
/// again.
std::string other_start_text(const Manipulator& robot, const ask::PlanAnswer& answer) {
  const CuspStart& start = answer.other_start;
  if (start.aspect == 0) return "";
  const std::string text = " Cusp " + std::to_string(answer.around_cusp->value) + " belongs to component " +
                           std::to_string(start.aspect);
  if (!start.point) return text + ", but from no pose beside it a path is found.";
  const bool has_modes = working_modes(robot).size() > 1;
  std::string values;
  for (Eigen::Index j = 0; j < start.point->q.size(); ++j)
    values += (j == 0 ? "" : " ") + number_text(start.point->q[j], pose_digits);
  return text + "; a start of that component with a path is --from \"" +
         pose_numbers(robot.task_space(), start.point->pose, pose_digits) + "\"" +
         (has_modes ? " --from-mode \"" + to_string(start.point->mode) + "\"" : "") +
         ", where the actuated values are \"" + values + "\".";
}

/// How far from where it was asked for a path begins or ends, and where it does.
std::string moved_text(const Manipulator& robot, const ask::PlanAnswer& answer) {
  if (answer.moved_onto_slice.value_or(0.0) == 0.0) return "";
  const auto& points = answer.path.points;
  const auto quoted = [&robot](const PathPoint& point) {
    return "\"" + pose_numbers(robot.task_space(), point.pose, pose_digits) + "\"";
  };
  return std::string(answer.around_cusp ? "the start is" : "the ends are") +
         " moved onto the slice, by at most " + shown(*answer.moved_onto_slice) + " m" +
         (points.empty() ? "" : ": from " + quoted(points.front()) + " to " + quoted(points.back())) + "\n";
}

}  // namespace

std::string reason_text(const Manipulator& robot, const ask::PlanAnswer& answer) {
  std::string text = answer.path.message + other_start_text(robot, answer);
  for (const std::string& each : answer.remarks) text += " " + ask::with_names(each, option_name);
  return text;
}

std::string turns_text(const ask::PlanAnswer& answer) {
  if (!answer.turns_around_cusps || !answer.path) return "";
  std::string around;
  for (std::size_t k = 0; k < answer.turns_around_cusps->size(); ++k)
    if (const int turns = (*answer.turns_around_cusps)[k]; turns != 0)
      around += (around.empty() ? "" : ",") + std::string(" around cusp ") + std::to_string(k + 1) + " " +
                (std::abs(turns) == 1 ? "once" : counted(static_cast<std::size_t>(std::abs(turns)), "time")) +
                (turns > 0 ? " counter-clockwise" : " clockwise");
  return "the actuated values go" + around + "\n" + noise_text(answer.encoder_noise.value_or(0.0)) + "\n";
}

std::string plan_text(const Manipulator& robot, const ask::PlanAnswer& answer) {
  const PlannedPath& path = answer.path;
  const std::string start =
      robot.name() + ", a path: " + name(path.answer) + "\n" + reason_text(robot, answer) + "\n";
  if (!path) return start;
  const std::string unit = determinant_unit(robot);
  return start + counted(path.points.size(), "point") + ", " + counted(path.crossings.size(), "crossing") +
         ", " + length_text(robot, path) + "\nsmallest of 32 poses a segment: parallel index " +
         shown(path.least_index) + ", |det A| " + shown(path.least_det_a) +
         (unit.empty() ? unit : " " + unit) + "\nbetween points: " + ask::between_points(answer) + "\n\n" +
         points_text(robot, path);
}

std::string text_after(const Manipulator& robot, const ask::PlanAnswer& answer) {
  const std::string text = moved_text(robot, answer);
  if (!answer.timed) return text;
  const TimedPath& timed = *answer.timed;
  return text + "\nin time: " + (timed ? shown(timed.seconds) + " s. " : "no. ") + timed.message + '\n';
}

}  // namespace parallel_aspects::tools
