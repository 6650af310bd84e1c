// SPDX-License-Identifier: BSD-3-Clause
#include "tools/paths/path_timing.h"

#include "tools/command.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/paths/trajectory_text.h"
#include "tools/report/text_table.h"

#include <algorithm>
#include <cstddef>

namespace parallel_aspects::tools {
namespace {

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

JointVector parse_acceleration(const std::string& text, const Manipulator& manipulator, Problems& problems) {
  std::vector<std::string> names;
  for (const Leg& leg : manipulator.legs()) names.push_back(leg.actuated_joint);
  const std::size_t known = problems.size();
  const std::vector<double> values = parse_numbers("--acceleration", text, names, problems);
  if (problems.size() == known && *std::min_element(values.begin(), values.end()) <= 0.0)
    problems.push_back("--acceleration is '" + text + "'; give positive numbers.");
  if (problems.size() > known) return {};  // there may be more of them than a vector of joints holds
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

std::vector<Option> timing_options(TimingArguments& arguments) {
  return {{"--trajectory", "FILE",
           "Write the path in time, as fast as the limits of the joints allow: a .csv, or a .yaml that "
           "rostopic publishes. `check --trajectory` reads both",
           &arguments.trajectory_file},
          {"--acceleration", "\"10 10\"",
           "Acceleration limits of the actuated joints [rad/s^2 or m/s^2]; by default those of "
           "motion.acceleration in the YAML",
           &arguments.acceleration}};
}

std::optional<JointVector> parse_timing(const TimingArguments& arguments, const std::string& needed_by,
                                        const RobotChoice& robot, const Manipulator& manipulator,
                                        Problems& problems) {
  const std::string& file = arguments.trajectory_file;
  const std::size_t known = problems.size();
  if (!file.empty() && !ends_with(file, ".csv") && !ends_with(file, ".yaml"))
    problems.push_back("--trajectory names '" + file + "'; give a file that ends in .csv or .yaml.");
  check_output_file("--trajectory", file, problems);
  const MotionSection section = load_motion_section(robot, manipulator.leg_count(), problems);
  const JointVector acceleration = arguments.acceleration.empty()
                                       ? section.config.acceleration
                                       : parse_acceleration(arguments.acceleration, manipulator, problems);
  if (problems.size() > known) return std::nullopt;
  Problems missing = problems_of(manipulator, acceleration);
  if (missing.empty()) return acceleration;
  if (acceleration.size() == 0)
    missing = {(needed_by.empty() ? "--trajectory" : needed_by) +
               " needs acceleration limits; write motion.acceleration into " + section.file +
               ", or give --acceleration."};
  if (!file.empty() || !arguments.acceleration.empty() || !needed_by.empty())
    problems.insert(problems.end(), missing.begin(), missing.end());
  return std::nullopt;
}

void report_timing(const Manipulator& manipulator, const TimingArguments& arguments, const TimedPath& timed,
                   Report& report) {
  report.json["seconds"] = timed ? nlohmann::json(timed.seconds) : nlohmann::json();
  report.json["trajectory"] = {{"message", timed.message},
                               {"waypoints", timed.waypoints.size()},
                               {"corners_rounded", timed.rounded},
                               {"stops", timed.stops}};
  report.text += "\nin time: " + (timed ? shown(timed.seconds) + " s. " : "no. ") + timed.message + '\n';
  const std::string& file = arguments.trajectory_file;
  if (file.empty()) return;
  if (!timed) report.exit_code = exit_code::unknown;
  if (!timed) return;
  report.json["trajectory_file"] = file;
  write_output_file("Trajectory", file,
                    ends_with(file, ".csv") ? trajectory_csv(manipulator, timed.waypoints)
                                            : trajectory_yaml(manipulator, timed.waypoints));
}

}  // namespace parallel_aspects::tools
