// SPDX-License-Identifier: BSD-3-Clause
#include "model/spherical_links.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/distance/distance_map.h"
#include "parallel_aspects/singularity/margins.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/map_choice.h"
#include "tools/numbers.h"
#include "tools/report/reports.h"
#include "tools/report/text_table.h"
#include "tools/subcommands.h"
#include "urdf/description/command_options.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

constexpr unsigned max_boxes = 10'000'000;

struct DistanceArguments {
  RobotChoice robot;
  std::string pose, mode, tolerance, boxes;
  MapChoice map;
  bool asks_map() const { return !map.load_file.empty() || !map.resolution.empty(); }
};

/// What is asked, with every number understood.
struct DistanceQuestion {
  Pose pose;
  std::vector<WorkingMode> modes;
  DistanceOptions options;
};

DistanceQuestion parse(const DistanceArguments& arguments, const Manipulator& manipulator) {
  Problems problems;
  DistanceQuestion question;
  question.pose = parse_pose("--pose", manipulator.task_space(), arguments.pose, problems);
  question.modes = working_modes(manipulator);
  if (!arguments.mode.empty())
    if (const auto mode = parse_mode("--mode", manipulator, arguments.mode, problems))
      question.modes = {*mode};
  if (!arguments.tolerance.empty())
    question.options.tolerance = parse_positive("--tolerance", arguments.tolerance, problems);
  if (!arguments.boxes.empty())
    question.options.max_boxes =
        static_cast<int>(parse_count("--boxes", arguments.boxes, max_boxes, problems, 1));
  if (arguments.asks_map() && manipulator.task_space() == TaskSpace::SE3)
    problems.push_back(
        "With six degrees of freedom there is no map of all poses that distances could ask; leave out --map "
        "and --resolution.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return question;
}

/// Which boundary a distance is to.
enum class Boundary { parallel, serial, actuated_limit };

bool has_leg(Boundary boundary, const BoundaryDistance& distance) {
  const bool touching_limit =
      distance.status == DistanceStatus::touching && boundary == Boundary::actuated_limit;
  return boundary != Boundary::parallel && (std::isfinite(distance.upper) || touching_limit);
}

json json_distance(const Manipulator& manipulator, Boundary boundary, const BoundaryDistance& distance) {
  json object = {{"status", name(distance.status)},
                 {"lower", json_number(distance.lower)},
                 {"upper", json_number(distance.upper)},
                 {"upper_proved", distance.upper_proved},
                 {"boxes", distance.boxes}};
  if (has_leg(boundary, distance)) object["leg"] = manipulator.leg(distance.leg).name;
  if (!std::isfinite(distance.upper)) return object;
  if (boundary == Boundary::actuated_limit) object["limit"] = name(distance.end);
  object["witness"] = json_pose(manipulator.task_space(), distance.witness);
  object["witness_joints"] = json_numbers(distance.witness_q);
  object["direction"] = json_numbers(distance.direction);
  object["joint_displacement"] = json_numbers(distance.joint_displacement);
  return object;
}

bool has_joints(const BoundaryDistances& distances) {
  return distances.status == ConfigurationStatus::measured ||
         distances.status == ConfigurationStatus::outside_limits;
}

/// What the configuration lacks of the margins; empty where it keeps them.
std::string missed_margins(const Manipulator& manipulator, const Pose& pose, const ModeDistances& answer) {
  return has_joints(answer.distances)
             ? parallel_aspects::missed_margins(manipulator, pose, answer.distances.q)
             : "";
}

json json_mode(const Manipulator& manipulator, const Pose& pose, const ModeDistances& answer) {
  const BoundaryDistances& distances = answer.distances;
  json object = {{"working_mode", answer.mode.signs()}, {"status", name(distances.status)}};
  if (!has_joints(distances)) return object;
  const std::string missed = missed_margins(manipulator, pose, answer);
  object["missed_margins"] = missed.empty() ? json() : json(missed);
  object["joints"] = json_numbers(distances.q);
  object["parallel"] = json_distance(manipulator, Boundary::parallel, distances.parallel);
  object["serial"] = json_distance(manipulator, Boundary::serial, distances.serial);
  object["actuated_limit"] = json_distance(manipulator, Boundary::actuated_limit, distances.actuated_limit);
  return object;
}

std::string boundary_text(const Manipulator& manipulator, Boundary boundary,
                          const BoundaryDistance& distance) {
  if (boundary == Boundary::parallel) return "parallel singularity";
  const std::string text = boundary == Boundary::serial ? "serial singularity" : "actuated joint limit";
  return has_leg(boundary, distance) ? text + ", " + manipulator.leg(distance.leg).name : text;
}

/// [m], or the angle at the center where all anchors are on the unit sphere.
std::string length_text(const Manipulator& manipulator, double length) {
  return moves_on_unit_sphere(manipulator) ? shown_angle(angle_of_chord(length)) : shown(length);
}

void add_row(const Manipulator& manipulator, const ModeDistances& answer, Boundary boundary,
             const BoundaryDistance& distance, TextTable& table) {
  const bool found = std::isfinite(distance.upper);
  table.add({to_string(answer.mode), boundary_text(manipulator, boundary, distance),
             distance.status == DistanceStatus::absent ? "none" : length_text(manipulator, distance.lower),
             found ? length_text(manipulator, distance.upper) + (distance.upper_proved ? "" : " (not proved)")
                   : "-",
             name(distance.status), found ? to_string(manipulator.task_space(), distance.witness) : "-",
             found ? shown(distance.joint_displacement) : "-"});
}

std::string distances_text(const Manipulator& manipulator, const Pose& pose,
                           const std::vector<ModeDistances>& answers) {
  const bool on_sphere = moves_on_unit_sphere(manipulator);
  const std::string unit = on_sphere ? "" : " [m]";
  TextTable table({"working mode", "to the nearest", ">proved at least" + unit, ">at most" + unit, "status",
                   "at", "actuated joints move by [rad or m]"});
  std::string missed;
  for (const ModeDistances& answer : answers) {
    const BoundaryDistances& distances = answer.distances;
    if (const std::string text = missed_margins(manipulator, pose, answer); !text.empty())
      missed += "in " + to_string(answer.mode) + " " + text + "\n";
    if (!has_joints(distances)) {
      table.add({to_string(answer.mode), "-", "-", "-", name(distances.status), "-", "-"});
      continue;
    }
    add_row(manipulator, answer, Boundary::parallel, distances.parallel, table);
    add_row(manipulator, answer, Boundary::serial, distances.serial, table);
    add_row(manipulator, answer, Boundary::actuated_limit, distances.actuated_limit, table);
  }
  return manipulator.name() + " at " + to_string(manipulator.task_space(), pose) +
         ", root mean square displacement of the anchors" +
         (on_sphere ? ", as the angle of that chord at the center" : "") + "\n\n" + table.text() + missed;
}

std::vector<ModeDistances> measured(const std::shared_ptr<const Manipulator>& manipulator,
                                    const DistanceQuestion& question, const ask::FoundMap& chosen,
                                    const Surroundings& surroundings) {
  BoundaryDistanceMeter meter(manipulator, question.options);
  if (chosen.map) {
    meter.use(std::make_shared<const DistanceMap>(chosen.map, control_of(surroundings)));
    if (is_cancelled(control_of(surroundings))) throw Interrupted{};
  }
  std::vector<ModeDistances> answers;
  for (const WorkingMode& mode : question.modes)
    answers.push_back({mode, meter.measure(question.pose, mode)});
  return answers;
}

// What to type for tighter bounds, in the words that named the robot; empty where they are tight or no map
// helps.
std::string hint_of_map(const RobotChoice& robot, const Manipulator& manipulator,
                        const std::vector<ModeDistances>& answers) {
  const bool is_loose = std::any_of(answers.begin(), answers.end(), [](const ModeDistances& answer) {
    const DistanceStatus status = answer.distances.parallel.status;
    return has_joints(answer.distances) &&
           (status == DistanceStatus::loose || status == DistanceStatus::no_witness);
  });
  if (!is_loose || manipulator.task_space() == TaskSpace::SE3) return "";
  const std::string words = !robot.name().empty()
                                ? shell_word(robot.name())
                                : shell_word(robot.urdf_file()) + " " + shell_word(robot.config_file()),
                    file = shell_word(manipulator.name() + ".map");
  return "With a map, as the node has one, the bounds to parallel singularities are tighter: write it with "
         "`aspects map " +
         words + " --save " + file + "`, and add --map " + file + " here.\n";
}

Report answer(const DistanceArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto& manipulator = mechanism->manipulator();
  const DistanceQuestion question = parse(arguments, *manipulator);
  ask::FoundMap chosen;
  if (arguments.asks_map()) chosen = choose_map(manipulator, arguments.map, std::nullopt, surroundings);
  const std::vector<ModeDistances> answers = measured(manipulator, question, chosen, surroundings);
  Report report = report_distances(*manipulator, question.pose, answers);
  if (chosen.map)
    report_source(arguments.map, chosen, report);
  else
    report.text += hint_of_map(arguments.robot, *manipulator, answers);
  return report;
}

}  // namespace

Report report_distances(const Manipulator& manipulator, const Pose& pose,
                        const std::vector<ModeDistances>& answers) {
  json object = {{"mechanism", manipulator.name()},
                 {"task_space", std::string(name(manipulator.task_space()))},
                 {"pose", json_pose(manipulator.task_space(), pose)},
                 {"answers", json::array()}};
  for (const ModeDistances& answer : answers)
    object["answers"].push_back(json_mode(manipulator, pose, answer));
  return {object, distances_text(manipulator, pose, answers)};
}

Subcommand distance_subcommand() {
  const auto arguments = std::make_shared<DistanceArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  options.push_back(
      {"--pose", "\"x y\"", "The pose of the platform; lengths [m]", &arguments->pose, true, Words::numbers});
  options.push_back({"--mode", "\"(+,-)\"", "Working mode, as signs of B_jj; by default every one",
                     &arguments->mode, false, Words::signs});
  options.push_back({"--tolerance", "T", "Relative gap between the bounds that is aimed at, by default 0.01",
                     &arguments->tolerance});
  options.push_back({"--boxes", "N", "Boxes that one search may evaluate, by default 400; more are tighter",
                     &arguments->boxes});
  options.push_back({"--map", "FILE",
                     "Ask this map, too, for tighter bounds: as `aspects map --save` wrote it",
                     &arguments->map.load_file});
  options.push_back({"--resolution", "R", "Of that map [m or rad], or of one that is computed, without --map",
                     &arguments->map.resolution});
  return {"distance", "Bound the distance to the nearest singularities and limits", options,
          [arguments](const Surroundings& surroundings) { return answer(*arguments, surroundings); }};
}

}  // namespace parallel_aspects::tools
