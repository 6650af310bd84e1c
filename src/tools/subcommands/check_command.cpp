// SPDX-License-Identifier: BSD-3-Clause
#include "model/number_text.h"
#include "model/pose_text.h"
#include "model/spherical_links.h"
#include "motion/check/check_text.h"
#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/motion/check_joint_trajectory.h"
#include "tools/arguments.h"
#include "tools/command_line.h"
#include "tools/computation.h"
#include "tools/drawing/result_charts.h"
#include "tools/motion_report/check_table.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/paths/trajectory_file.h"
#include "tools/report/answer_json.h"
#include "tools/report/bounds_report.h"
#include "tools/report/reports.h"
#include "tools/report/text_table.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

struct CheckArguments {
  RobotChoice robot;
  std::string path, mode, trajectory, start_pose, start_sign, policy;
  std::string csv_file, picture_file, distances;
  ConstraintArguments constraints;
};

/// What was answered, and from when on.
struct CheckedTrajectory {
  TrajectoryCheck check;
  double from = 0.0;  // time of the first waypoint [s]
};

json json_crossing(const Manipulator& manipulator, const TrajectoryCrossing& crossing) {
  return {{"kind", name(crossing.kind)},
          {"leg", crossing.leg ? json(manipulator.leg(*crossing.leg).name) : json()},
          {"after", crossing.after},
          {"before", crossing.before},
          {"working_mode", crossing.mode ? json(crossing.mode->signs()) : json()},
          {"det_a_sign", crossing.determinant_sign != 0 ? json(crossing.determinant_sign) : json()}};
}

json json_least(const SampledLeast& least) {
  return {{"value", json_number(least.value)}, {"time", json_number(least.time)}};
}

json json_speeds(const Manipulator& manipulator, const TrajectoryCheck& check) {
  json speeds = json::array();
  for (std::size_t j = 0; j < check.speeds.size(); ++j) {
    const double limit = manipulator.leg(j).limits.velocity;
    const FastestMotion& speed = check.speeds[j];
    speeds.push_back({{"joint", manipulator.leg(j).actuated_joint},
                      {"fastest", speed.value},
                      {"never_faster", json_number(speed.bound)},
                      {"time", speed.time},
                      {"limit", json_number(limit)},
                      {"exceeded", speed.value > limit    ? "yes"
                                   : speed.bound <= limit ? "no"
                                                          : "unknown"}});
  }
  return speeds;
}

json json_check(const Manipulator& manipulator, const TrajectoryCheck& check) {
  json serial = json_least(check.serial_index);
  serial["leg"] = manipulator.leg(check.serial_index.leg).name;
  json object = {{"mechanism", manipulator.name()},
                 {"task_space", std::string(name(manipulator.task_space()))},
                 {"answer", name(check.answer)},
                 {"proved", check.answer != TrajectoryAnswer::unknown},
                 {"reason", check.reason},
                 {"free_until", check.free_until},
                 {"first_violation", nullptr},
                 {"crossings", json::array()},
                 {"followed_until", check.followed_until},
                 {"not_followed", check.not_followed.empty() ? json() : json(check.not_followed)},
                 {"least_index", {{"parallel", json_least(check.parallel_index)}, {"serial", serial}}},
                 {"speeds", json_speeds(manipulator, check)}};
  if (check.violation) object["first_violation"] = JsonWriter(manipulator).json_of(*check.violation);
  for (const TrajectoryCrossing& crossing : check.crossings)
    object["crossings"].push_back(json_crossing(manipulator, crossing));
  return object;
}

/// What is infinite was not sampled, or is not limited.
std::string finite_or_dash(double value) { return std::isfinite(value) ? shown(value) : "-"; }

std::string values_text(const Manipulator& manipulator, const TrajectoryCheck& check) {
  TextTable table(
      {"up to " + number_text(check.free_until, 9) + " s", ">least or fastest", ">at [s]", ">limit"});
  table.add(
      {"parallel index", finite_or_dash(check.parallel_index.value), shown(check.parallel_index.time), "-"});
  table.add({"serial index, leg '" + manipulator.leg(check.serial_index.leg).name + "'",
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
    return exit_code::unsafe;
  const bool proved =
      check.answer == TrajectoryAnswer::safe && exceeded_speeds(manipulator, check, false).empty();
  return proved ? exit_code::ok : exit_code::unknown;
}

Report report_check(const Manipulator& manipulator, const CheckedTrajectory& checked) {
  const TrajectoryCheck& check = checked.check;
  Report report{json_check(manipulator, check), check_text(manipulator, check, checked.from),
                code_of(manipulator, check)};
  report.json["checked_from"] = checked.from;
  const Report constraints = report_constraints(manipulator);
  report.json.update(constraints.json);
  report.text += '\n' + constraints.text;
  return report;
}

TrajectoryCheckOptions options_of(const CheckArguments& arguments, const MapControl& control) {
  TrajectoryCheckOptions options;
  options.pass_serial = arguments.policy == "serial";
  options.control = control;
  options.keep_samples =
      !arguments.csv_file.empty() || !arguments.picture_file.empty() || !arguments.distances.empty();
  return options;
}

CheckedTrajectory check_path(const std::shared_ptr<const Manipulator>& manipulator,
                             const CheckArguments& arguments, const MapControl& control) {
  Problems problems;
  if (!arguments.start_pose.empty() || !arguments.start_sign.empty())
    throw InvalidDescription({"--start-pose and --start-sign are of --trajectory; leave them out."});
  if (arguments.mode.empty())
    throw UsageError(
        "--path needs the working mode of the poses; give --mode, one of those that `aspects choose " +
        manipulator->name() + " --path " + arguments.path + "` finds");
  if (!arguments.policy.empty())
    throw InvalidDescription({"--policy is of --trajectory, since poses end at B_jj = 0; leave it out."});
  const auto mode = parse_mode("--mode", *manipulator, arguments.mode, problems);
  if (!mode) throw InvalidDescription(std::move(problems));
  const auto waypoints = read_pose_waypoints(manipulator->task_space(), arguments.path);
  problems = problems_of(*manipulator, waypoints, *mode);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return {check_trajectory(SegmentCertifier(manipulator), waypoints, *mode, options_of(arguments, control)),
          waypoints.front().time};
}

TrajectoryStart parse_start(const Manipulator& manipulator, const CheckArguments& arguments) {
  Problems problems;
  TrajectoryStart start;
  if (!arguments.start_pose.empty())
    start.pose = parse_pose("--start-pose", manipulator.task_space(), arguments.start_pose, problems);
  if (!arguments.policy.empty() && arguments.policy != "stay" && arguments.policy != "serial")
    problems.push_back("--policy is '" + arguments.policy +
                       "'; give stay, to refuse every singularity, or serial, to let legs pass B_jj = 0.");
  if (!arguments.start_sign.empty() && arguments.start_sign != "+" && arguments.start_sign != "-")
    problems.push_back("--start-sign is '" + arguments.start_sign + "'; give + or -, the sign of det A.");
  if (start.pose && !arguments.start_sign.empty())
    problems.emplace_back("--start-pose and --start-sign both state the start; give one of the two.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  start.determinant_sign = arguments.start_sign.empty() ? 0 : arguments.start_sign == "+" ? 1 : -1;
  return start;
}

/// The options that state one of the starts each.
std::string start_options(const Manipulator& manipulator, const std::vector<PossibleStart>& starts) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, starts.size()); ++i) {
    const int sign = telling_sign(starts, i);
    text += (i == 0 ? " Give --start-pose \"" : ", or --start-pose \"") +
            pose_numbers(manipulator.task_space(), starts[i].pose) + "\"";
    if (sign != 0) text += std::string(" (the same as --start-sign ") + (sign > 0 ? "+" : "-") + ")";
  }
  if (starts.size() > most) text += ", or one of " + std::to_string(starts.size() - most) + " more";
  return text + (starts.empty() ? "" : ".");
}

CheckedTrajectory check_joints(const std::shared_ptr<const Manipulator>& manipulator,
                               const CheckArguments& arguments, const MapControl& control) {
  if (!arguments.mode.empty())
    throw InvalidDescription(
        {"--mode is of --path; the start of actuated joints tells theirs, leave it out."});
  const TrajectoryStart start = parse_start(*manipulator, arguments);
  const auto waypoints = read_joint_waypoints(*manipulator, arguments.trajectory);
  Problems problems = problems_of(*manipulator, waypoints, start);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return {check_trajectory(SegmentCertifier(manipulator), waypoints, start, options_of(arguments, control)),
          waypoints.front().time};
}

CheckedTrajectory check(const std::shared_ptr<const Manipulator>& manipulator,
                        const CheckArguments& arguments, const Surroundings& surroundings) {
  const ShownComputation shown(surroundings);
  if (arguments.path.empty() && arguments.trajectory.empty())
    throw UsageError(
        "--path or --trajectory is required; give the one, for poses, or the other, for actuated joints");
  if (!arguments.path.empty() && !arguments.trajectory.empty())
    throw InvalidDescription({"Give one of --path, for poses, and --trajectory, for actuated joints."});
  CheckedTrajectory result = arguments.path.empty() ? check_joints(manipulator, arguments, shown.control())
                                                    : check_path(manipulator, arguments, shown.control());
  shown.require_complete();
  if (result.check.refused)
    throw InvalidDescription(
        {result.check.reason + start_options(*manipulator, result.check.possible_starts)});
  return result;
}

void add_distances(const Manipulator& manipulator, const TrajectoryCheck& check,
                   const std::vector<SampleDistances>& distances, Report& report) {
  if (distances.empty()) return;
  const std::array<double, 3> least = least_distances(check, distances);
  report.text += "\nProved at every time up to " + number_text(check.free_until, 9) + " s: at least";
  for (std::size_t k = 0; k < least.size(); ++k) {
    report.json["least_distance"][distance_names[k]] = json_number(least[k]);
    report.text +=
        std::string(k == 0 ? " " : ", ") + distance_names[k] + " " + distance_text(manipulator, least[k]);
  }
  report.text += ".\n";
}

Report run(const CheckArguments& arguments, const Surroundings& surroundings) {
  Problems problems;
  check_output_file("--csv", arguments.csv_file, problems);
  check_output_file("--picture", arguments.picture_file, problems);
  const unsigned points =
      arguments.distances.empty() ? 0 : parse_count("--distances", arguments.distances, 10000, problems);
  const auto mechanism = load_robot(arguments.robot, std::move(problems));
  const auto manipulator = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  const CheckedTrajectory checked = check(manipulator, arguments, surroundings);
  const TrajectoryCheck& result = checked.check;
  Report report = report_check(*manipulator, checked);
  const std::vector<SampleDistances> distances = distances_on(manipulator, result, points);
  add_distances(*manipulator, result, distances, report);
  if (!arguments.csv_file.empty())
    write_output_file("Table", arguments.csv_file, check_csv(*manipulator, result, distances));
  if (!arguments.picture_file.empty())
    write_output_file("Picture", arguments.picture_file, draw_check(*manipulator, result, distances));
  return report;
}

}  // namespace

Subcommand check_subcommand() {
  const auto arguments = std::make_shared<CheckArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  options.push_back(path_option(arguments->path));
  options.push_back({"--mode", "\"(+,-)\"", "Working mode of the poses, as signs of B_jj", &arguments->mode,
                     false, Words::signs});
  options.push_back(
      {"--trajectory", "FILE",
       "Values of the actuated joints: a trajectory_msgs/JointTrajectory in YAML, as rostopic prints it; or "
       "CSV with a header of time and their names, NAME/velocity and NAME/acceleration where known",
       &arguments->trajectory, false, Words::one, FileUse::read});
  options.push_back(
      {"--start-pose", "\"x y\"",
       "About where the platform is at the start, where actuated joints have several assembly modes",
       &arguments->start_pose, false, Words::numbers});
  options.push_back({"--policy", "stay|serial",
                     "Of joints. stay: every singularity is a violation, the default. serial: legs may pass "
                     "B_jj = 0, as `plan` has them",
                     &arguments->policy});
  options.push_back({"--start-sign", "+", "Or the sign of det A there", &arguments->start_sign});
  options.push_back({"--csv", "FILE", "Write time, pose, joints and indices of every sample as CSV",
                     &arguments->csv_file, false, Words::one, FileUse::written});
  options.push_back({"--picture", "FILE", "Draw indices and distances over time as SVG",
                     &arguments->picture_file, false, Words::one, FileUse::written});
  options.push_back({"--distances", "N",
                     "Measure the distances to singularities and limits at so many times, for all three",
                     &arguments->distances});
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"check", "Tell whether a trajectory is safe at every time", options,
          [arguments](const Surroundings& surroundings) { return run(*arguments, surroundings); }};
}

}  // namespace parallel_aspects::tools
