// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/choose_working_mode.h"
#include "tools/arguments.h"
#include "tools/command_line.h"
#include "tools/computation.h"
#include "tools/motion_report/choice_report.h"
#include "tools/paths/trajectory_file.h"
#include "tools/subcommands.h"

#include <optional>
#include <utility>

namespace parallel_aspects::tools {
namespace {

struct ChooseArguments {
  RobotChoice robot;
  std::string path, preference, region, slice;
  bool changes = false;
  ConstraintArguments constraints;
};

Preference parse_preference(const std::string& text) {
  if (text.empty()) return Preference::clear;
  const auto preference = preference_named(text);
  if (!preference) throw InvalidDescription({"--prefer is '" + text + "'; give clear, travel or fast."});
  return *preference;
}

int code_of(TrajectoryAnswer answer) {
  return answer == TrajectoryAnswer::safe     ? exit_code::ok
         : answer == TrajectoryAnswer::unsafe ? exit_code::unsafe
                                              : exit_code::unknown;
}

/// Maps of one or two degrees of freedom are quick; aspects of others are distinguished by the sign of det A
/// alone.
std::shared_ptr<const AspectMap> cheap_map(const std::shared_ptr<const Manipulator>& manipulator,
                                           const Surroundings& surroundings) {
  if (degrees_of_freedom(manipulator->task_space()) > 2) return nullptr;
  const MapResult result = compute_aspect_map(manipulator, {}, control_of(surroundings));
  if (result.status == MapStatus::cancelled) throw Interrupted{};
  return result.map;
}

Report choose_for_path(const std::shared_ptr<const Manipulator>& manipulator,
                       const ChooseArguments& arguments, const Surroundings& surroundings) {
  PathChoiceOptions options;
  options.preference = parse_preference(arguments.preference);
  const auto waypoints = read_pose_waypoints(manipulator->task_space(), arguments.path);
  Problems problems = problems_of(*manipulator, waypoints, options.preference);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const auto map = cheap_map(manipulator, surroundings);
  options.map = map.get();
  const ShownComputation shown(surroundings);
  options.control = shown.control();
  const SegmentCertifier certifier(manipulator);
  const PathChoice choice = choose_working_mode(certifier, waypoints, options);
  shown.require_complete();
  Report report = report_path_choice(*manipulator, choice, options.preference);
  report.exit_code = code_of(choice.answer);
  if (!arguments.changes) return report;
  const ChangingPath changed = choose_posture_changes(certifier, waypoints, shown.control());
  shown.require_complete();
  add_changes(*manipulator, changed, report);
  if (choice.answer != TrajectoryAnswer::safe) report.exit_code = code_of(changed.answer);
  return report;
}

Report choose_for_region(const std::shared_ptr<const Manipulator>& manipulator,
                         const ChooseArguments& arguments, const Surroundings& surroundings) {
  if (!arguments.preference.empty())
    throw InvalidDescription({"--prefer is of --path; leave it out with --region."});
  if (arguments.changes) throw InvalidDescription({"--changes is of --path; leave it out with --region."});
  Problems problems;
  RegionQuestion question;
  if (!arguments.slice.empty())
    question.slice = parse_slice("--slice", *manipulator, arguments.slice, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const auto names =
      question.slice ? coordinate_names(*question.slice) : coordinate_names(manipulator->task_space());
  if (names.size() <= max_map_dimension)
    question.region = parse_region("--region", names, arguments.region, problems);
  if (problems.empty()) problems = problems_of(*manipulator, question);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  RegionChoiceOptions options;
  options.control = control_of(surroundings);
  const RegionChoice choice = choose_working_mode(manipulator, question, options);
  Report report = report_region_choice(*manipulator, question, choice);
  report.exit_code = code_of(choice.answer);
  return report;
}

Report choose(const std::shared_ptr<const Manipulator>& manipulator, const ChooseArguments& arguments,
              const Surroundings& surroundings) {
  if (arguments.path.empty() && arguments.region.empty())
    throw UsageError(
        "--path or --region is required; give the one, for a tool path, or the other, for a box of poses");
  if (!arguments.path.empty() && !arguments.region.empty())
    throw InvalidDescription({"Give one of --path, for a tool path, and --region, for a box of poses."});
  if (!arguments.region.empty()) return choose_for_region(manipulator, arguments, surroundings);
  if (!arguments.slice.empty())
    throw InvalidDescription({"--slice is of --region; leave it out with --path."});
  return choose_for_path(manipulator, arguments, surroundings);
}

}  // namespace

Subcommand choose_subcommand() {
  const auto arguments = std::make_shared<ChooseArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  options.push_back(path_option(arguments->path));
  options.push_back({"--region", "\"x=-1:1 y=-1:1\"",
                     "A box of poses: a lower and an upper end of each coordinate [m, rad]",
                     &arguments->region, false, Words::assignments});
  options.push_back({"--slice", "\"roll=0 pitch=0 yaw=0\"",
                     "Pose coordinates that are held in the region [m or rad]", &arguments->slice, false,
                     Words::assignments});
  options.push_back({"--prefer", "clear",
                     "Which working mode is best: clear, the farthest from singularities, which is the "
                     "default; travel, the least travel of actuated joints; or fast",
                     &arguments->preference});
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"choose",
          "Tell in which working modes a tool path or a region can be done, the best first",
          options,
          [arguments](const Surroundings& surroundings) {
            const auto mechanism = load_robot(arguments->robot);
            const auto manipulator =
                choose_constraints(mechanism->mapped_manipulator(), arguments->constraints);
            return choose(manipulator, *arguments, surroundings);
          },
          {{"--changes", "Let the robot change its posture at serial singularities beside the path",
            &arguments->changes}}};
}

}  // namespace parallel_aspects::tools
