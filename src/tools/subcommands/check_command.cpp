// SPDX-License-Identifier: BSD-3-Clause
#include "model/message_text.h"
#include "model/spherical_links.h"
#include "motion/check/check_text.h"
#include "parallel_aspects/ask/check.h"
#include "tools/arguments.h"
#include "tools/drawing/result_charts.h"
#include "tools/motion_report/check_table.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/paths/trajectory_file.h"
#include "tools/question_options.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"
#include "tools/report/reports.h"
#include "tools/subcommands.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

struct CheckArguments : QuestionArguments {
  std::string path, trajectory, csv_file, picture_file;
};

/// What is infinite was not sampled, or is not limited.
std::string finite_or_dash(double value) { return std::isfinite(value) ? shown(value) : "-"; }

std::string values_text(const Manipulator& manipulator, const TrajectoryCheck& check) {
  TextTable table(
      {"up to " + number_text(check.free_until, 9) + " s", ">least or fastest", ">at [s]", ">limit"});
  table.add(
      {"parallel index", finite_or_dash(check.parallel_index.value), shown(check.parallel_index.time), "-"});
  table.add({"serial index, leg '" + manipulator.leg(check.serial_index.leg.value_or(0)).name + "'",
             finite_or_dash(check.serial_index.value), shown(check.serial_index.time), "-"});
  for (std::size_t j = 0; j < check.speeds.size(); ++j) {
    const Leg& leg = manipulator.leg(j);
    table.add({"speed of '" + leg.actuated_joint + "' [" + joint_unit(leg) + "/s]",
               finite_or_dash(check.speeds[j].bound), shown(check.speeds[j].time),
               finite_or_dash(leg.limits.velocity)});
  }
  return table.text();
}

std::string crossings_text(const Manipulator& manipulator, const TrajectoryCheck& check) {
  if (check.crossings.empty()) return "";
  TextTable table({"crossing of", ">after [s]", ">before [s]", "goes on in", "det A"});
  for (const TrajectoryCrossing& crossing : check.crossings) {
    const auto [after, before] = bracket_text(crossing.after, crossing.before);
    table.add({crossing.leg ? "B_jj = 0 of '" + manipulator.leg(*crossing.leg).name + "'" : "det A = 0",
               after, before, crossing.mode ? to_string(*crossing.mode) : "-",
               crossing.determinant_sign > 0   ? "+"
               : crossing.determinant_sign < 0 ? "-"
                                               : "?"});
  }
  return '\n' + table.text() + check.not_followed + (check.not_followed.empty() ? "" : "\n");
}

/// A controller leads the robot to a first waypoint that is later than its start, along no known way.
std::string from_text(double from) {
  return from > 0.0 ? "From " + number_text(from, 9) +
                          " s on: how the robot gets to the first waypoint is not checked.\n"
                    : "";
}

std::string check_text(const Manipulator& manipulator, const TrajectoryCheck& check, double from) {
  const std::string fast = exceeded_speeds(manipulator, check, true),
                    perhaps_fast = exceeded_speeds(manipulator, check, false);
  const bool is_safe = check.answer == TrajectoryAnswer::safe;
  const std::string but = !is_safe || (fast.empty() && perhaps_fast.empty()) ? ""
                          : fast.empty()                                     ? ", if it is slow enough"
                                                                             : ", but too fast";
  std::string text = manipulator.name() + ", safe: " + name(check.answer) + but + "\n" + check.reason + "\n" +
                     from_text(from);
  if (!fast.empty()) text += "Too fast: joint " + fast + ".\n";
  if (!perhaps_fast.empty()) text += "Not proved to be slow enough: joint " + perhaps_fast + ".\n";
  return text + crossings_text(manipulator, check) + '\n' + values_text(manipulator, check);
}

/// Velocity limits count as well.
int code_of(const Manipulator& manipulator, const TrajectoryCheck& check) {
  if (check.answer == TrajectoryAnswer::unsafe || !exceeded_speeds(manipulator, check, true).empty())
    return exit_code::proved_no;
  const bool proved =
      check.answer == TrajectoryAnswer::safe && exceeded_speeds(manipulator, check, false).empty();
  return proved ? exit_code::ok : exit_code::not_proved;
}

std::string distances_text(const Manipulator& manipulator, const ask::CheckAnswer& answer) {
  const auto least = answer.least_distance();
  if (!least) return "";
  std::string text =
      "\nProved at every time up to " + number_text(answer.check.free_until, 9) + " s: at least";
  for (std::size_t k = 0; k < least->size(); ++k)
    text += (k == 0 ? " " : ", ") + (*least)[k].first + " " + distance_text(manipulator, (*least)[k].second);
  return text + ".\n";
}

ask::CheckQuestion read(const CheckArguments& arguments, const Manipulator& robot) {
  auto question = understood<ask::CheckQuestion>(robot, arguments.texts);
  question.keep_samples = !arguments.csv_file.empty() || !arguments.picture_file.empty();
  if (!arguments.path.empty()) question.path.emplace();
  if (!arguments.trajectory.empty()) question.trajectory.emplace();
  if (!is_whole(question)) return question;  // is refused unread
  if (question.path)
    question.path = read_pose_waypoints(robot.motions(), arguments.path);
  else
    question.trajectory = read_joint_waypoints(robot, arguments.trajectory);
  return question;
}

Report run(const CheckArguments& arguments, const Surroundings& surroundings) {
  Problems problems;
  check_output_file("--csv", arguments.csv_file, problems);
  check_output_file("--picture", arguments.picture_file, problems);
  const auto robot = robot_of(arguments, std::move(problems));
  const ask::CheckAnswer answer = asked(robot, read(arguments, *robot), surroundings);
  const TrajectoryCheck& check = answer.check;
  Report report = constrained_report(*robot, answer, check_text(*robot, check, answer.from) + '\n');
  report.text += distances_text(*robot, answer);
  report.exit_code = code_of(*robot, check);
  if (!arguments.csv_file.empty())
    write_output_file("Table", arguments.csv_file, check_csv(*robot, check, answer.distances));
  if (!arguments.picture_file.empty())
    write_output_file("Picture", arguments.picture_file, draw_check(*robot, check, answer.distances));
  return report;
}

}  // namespace

Subcommand check_subcommand() {
  const auto arguments = std::make_shared<CheckArguments>();
  return question_subcommand<ask::CheckQuestion>(
      "check", "Decide whether a trajectory is safe at every time", arguments, run,
      {path_option(arguments->path),
       {"--trajectory", "FILE",
        "Values of the actuated joints: a trajectory_msgs/JointTrajectory in YAML, as rostopic prints it; or "
        "CSV with a header of time and their names, NAME/velocity and NAME/acceleration where known",
        &arguments->trajectory, false, Words::one, FileUse::read}},
      {{"--csv", "FILE", "Write time, pose, joints and indices of every sample as CSV", &arguments->csv_file,
        false, Words::one, FileUse::written},
       {"--picture", "FILE", "Draw indices and distances over time as SVG", &arguments->picture_file, false,
        Words::one, FileUse::written}});
}

}  // namespace parallel_aspects::tools
