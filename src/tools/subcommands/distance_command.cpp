// SPDX-License-Identifier: BSD-3-Clause
#include "model/spherical_links.h"
#include "parallel_aspects/ask/distance.h"
#include "tools/question_options.h"
#include "tools/report/answer_json.h"
#include "tools/report/report.h"
#include "tools/subcommands.h"
#include "urdf/description/messages.h"

#include <algorithm>
#include <memory>

namespace parallel_aspects::tools {
namespace {

struct DistanceArguments {
  RobotChoice robot;
  QuestionTexts texts;
};

/// [m], or an angle.
std::string length_text(const Manipulator& manipulator, double length) {
  const DistanceUnit unit(manipulator);
  return unit.is_angle() ? shown_angle(unit.displayed(length)) : shown(length);
}

std::string lower_text(const Manipulator& manipulator, const BoundaryDistance& distance) {
  if (distance.status == DistanceStatus::absent) return "none";
  return distance.status == DistanceStatus::unavailable ? "-" : length_text(manipulator, distance.lower);
}

void add_row(const Manipulator& manipulator, const WorkingMode& mode, const std::string& boundary,
             const ask::DistanceTo& answer, TextTable& table) {
  const BoundaryDistance& distance = answer.distance;
  const bool found = answer.has_witness();
  table.add({to_string(mode), boundary + (answer.leg ? ", " + manipulator.leg(answer.leg->index).name : ""),
             lower_text(manipulator, distance),
             found ? length_text(manipulator, distance.upper) + (distance.upper_proved ? "" : " (not proved)")
                   : "-",
             name(distance.status), found ? to_string(manipulator.task_space(), distance.witness) : "-",
             found ? shown(distance.joint_displacement) : "-"});
}

std::string distances_text(const Manipulator& manipulator, const ask::DistanceAnswer& answer) {
  const bool on_sphere = DistanceUnit(manipulator).is_angle();
  const std::string unit = on_sphere ? "" : " [m]";
  TextTable table({"working mode", "to the nearest", ">proved at least" + unit, ">at most" + unit, "status",
                   "at", "actuated joints move by [rad or m]"});
  std::string missed;
  for (const ask::DistancesInMode& each : answer.answers) {
    if (!each.missed_margins.empty())
      missed += "in " + to_string(each.mode) + " " + each.missed_margins + "\n";
    if (!each.is_reached()) {
      table.add({to_string(each.mode), "-", "-", "-", name(each.distances.status), "-", "-"});
      continue;
    }
    add_row(manipulator, each.mode, "parallel singularity", each.parallel(), table);
    add_row(manipulator, each.mode, "serial singularity", each.serial(), table);
    add_row(manipulator, each.mode, "actuated joint limit", each.actuated_limit(), table);
  }
  return manipulator.name() + " at " + to_string(manipulator.task_space(), answer.pose) +
         ", root mean square displacement of the anchors" +
         (on_sphere ? ", as the angle of that chord at the center" : "") + "\n\n" + table.text() + missed;
}

// What to type for tighter bounds, in the words that named the robot; empty where they are tight or no map
// helps.
std::string hint_of_map(const RobotChoice& robot, const Manipulator& manipulator,
                        const std::vector<ask::DistancesInMode>& answers) {
  const bool is_loose = std::any_of(answers.begin(), answers.end(), [](const ask::DistancesInMode& answer) {
    const DistanceStatus status = answer.distances.parallel.status;
    return status == DistanceStatus::loose || status == DistanceStatus::no_witness;
  });
  if (!is_loose || manipulator.task_space() == TaskSpace::SE3 || has_hinges(manipulator.task_space()))
    return "";
  const std::string words = !robot.name().empty()
                                ? shell_word(robot.name())
                                : shell_word(robot.urdf_file()) + " " + shell_word(robot.config_file()),
                    file = shell_word(manipulator.name() + ".map");
  return "With a map, as the node has one, the bounds to parallel singularities are tighter: write it with "
         "`aspects map " +
         words + " --save " + file + "`, and add --map " + file + " here.\n";
}

// Margins are looked at, but not as boundaries.
std::string left_out_text(const Manipulator& manipulator) {
  std::string names;
  for (const ConstraintKind kind : all_constraint_kinds)
    if (kind != ConstraintKind::actuated_limits && kind != ConstraintKind::margins &&
        manipulator.constraint_kinds()[index_of(kind)])
      names += (names.empty() ? "" : ", ") + std::string(name(kind));
  return names.empty() ? "" : "No distances are measured to boundaries by " + names + ".\n";
}

Report report_of(const DistanceArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto& robot = mechanism->manipulator();
  const auto question = understood<ask::DistanceQuestion>(*robot, arguments.texts);
  const ask::DistanceAnswer answer = asked(robot, question, surroundings);
  Report report{answer_json(*robot, answer), distances_text(*robot, answer)};
  report.json["mechanism"] = robot->name();
  report.text += left_out_text(*robot);
  report.text += answer.loaded ? source_text(question.map, *answer.loaded)
                               : hint_of_map(arguments.robot, *robot, answer.answers);
  return report;
}

}  // namespace

Subcommand distance_subcommand() {
  const auto arguments = std::make_shared<DistanceArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  for (const Option& option : question_options<ask::DistanceQuestion>(arguments->texts))
    options.push_back(option);
  return {"distance", "Bound the distance to the nearest singularities and limits", options,
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); }};
}

}  // namespace parallel_aspects::tools
