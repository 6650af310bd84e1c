// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/held_joint_example.h"
#include "aspects/uniqueness/uniqueness_problem.h"
#include "motion/assembly_survey.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/drawing/uniqueness_drawing.h"
#include "tools/motion_report/assembly_report.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/report/uniqueness_report.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

constexpr unsigned default_poses = 1000, most_poses = 1000000;

struct UniquenessArguments {
  RobotChoice robot;
  std::string slice, cusps_over, resolution, picture, mode, poses;  // empty where not given
  RoadmapArguments roadmap;
  ConstraintArguments constraints;
};

/// Options by name, with what was given.
using GivenOptions = std::vector<std::pair<std::string, std::string>>;

/// A problem for each that was given: its name between the two texts.
void refuse(const GivenOptions& options, const std::string& before, const std::string& after,
            Problems& problems) {
  for (const auto& [option, text] : options)
    if (!text.empty()) problems.push_back(before + option + after);
}

/// Of the roadmap alone.
GivenOptions roadmap_options_of(const UniquenessArguments& arguments) {
  return {{"--samples", arguments.roadmap.samples},
          {"--seed", arguments.roadmap.seed},
          {"--poses", arguments.poses}};
}

Report report_of_curves(const UniquenessArguments& arguments, const Manipulator& robot, Problems problems,
                        const Surroundings& surroundings) {
  refuse({{"--slice", arguments.slice}, {"--resolution", arguments.resolution}, {"--mode", arguments.mode}},
         "--cusps-over lists curves of cusps alone; leave ", " or it out.", problems);
  if (robot.task_space() == TaskSpace::SE2) refuse_other_bounds(arguments.constraints, robot, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const HeldRange range = parse_held_range("--cusps-over", robot, arguments.cusps_over, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const ShownComputation shown(surroundings);
  const CuspCurves found = find_cusp_curves(robot, range, shown.control());
  shown.require_complete();
  if (!arguments.picture.empty()) write_picture_file(arguments.picture, draw_cusp_curves(robot, found));
  return report_cusp_curves(robot, found);
}

/// Where there is no theorem and there are no slices.
bool is_surveyed(const Manipulator& robot) {
  return !has_one_solution_a_sign(robot.task_space()) && robot.task_space() != TaskSpace::SE2;
}

/// In SO3 with a joint held.
Report report_of_cusps(const UniquenessArguments& arguments, const Manipulator& robot, Problems problems,
                       const Surroundings& surroundings) {
  const std::string before = "In SO3 --slice lists cusps and numbers of direct solutions alone; leave ",
                    after = " or it out.";
  refuse({{"--cusps-over", arguments.cusps_over},
          {"--resolution", arguments.resolution},
          {"--picture", arguments.picture},
          {"--mode", arguments.mode}},
         before, after, problems);
  refuse(roadmap_options_of(arguments), before, after, problems);
  refuse_other_bounds(arguments.constraints, robot, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const HeldJoint held = parse_held_joint("--slice", robot, arguments.slice, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const ShownComputation shown(surroundings);
  const CuspList found = find_cusps(robot, held, part_of(shown.control(), 0.0, 0.4));
  const SolutionNumbers numbers = count_direct_solutions(robot, held, part_of(shown.control(), 0.4, 1.0));
  shown.require_complete();
  return report_cusps(robot, held, found, numbers);
}

Report report_of_survey(const UniquenessArguments& arguments, const std::shared_ptr<const Manipulator>& robot,
                        Problems problems, const Surroundings& surroundings) {
  refuse({{"--slice", arguments.slice},
          {"--cusps-over", arguments.cusps_over},
          {"--resolution", arguments.resolution},
          {"--picture", arguments.picture},
          {"--mode", arguments.mode}},
         "In " + std::string(name(robot->task_space())) + " a roadmap is looked at, which has no ",
         "; leave it out.", problems);
  const RoadmapOptions options = parse_roadmap(arguments.roadmap, problems);
  const unsigned poses = arguments.poses.empty()
                             ? default_poses
                             : parse_count("--poses", arguments.poses, most_poses, problems, 1);
  refuse_tolerance(arguments.constraints, *robot, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const ShownComputation shown(surroundings);
  const auto roadmap = compute_roadmap(robot, options, part_of(shown.control(), 0.0, 0.5));
  const auto survey = survey_assembly_modes(*roadmap, poses, part_of(shown.control(), 0.5, 1.0));
  if (!survey) throw Interrupted{};
  return report_assembly_survey(*roadmap, *survey);
}

/// Limits that the robot has and that were left out, though struts or slides need some.
void refuse_all_poses(const UniquenessArguments& arguments, const Manipulator& described,
                      const Manipulator& robot, Problems& problems) {
  const std::size_t limits = index_of(ConstraintKind::actuated_limits);
  if (!described.constraint_kinds()[limits] || robot.constraint_kinds()[limits]) return;
  if (!has_lengths_without_limit(robot)) return;
  const std::string option = arguments.constraints.without.empty() ? "--constraint" : "--no-constraint";
  problems.push_back("All poses of '" + robot.name() + "' are looked at within limits of its joints, and " +
                     option + " takes these out; keep actuated_limits, or give --slice " +
                     example_of_held_joint(described) + ".");
}

/// The slice of SE2, or none of another task space or of all poses.
std::optional<MapSlice> slice_of(const UniquenessArguments& arguments, const Manipulator& described,
                                 const Manipulator& robot, Problems& problems) {
  if (has_one_solution_a_sign(robot.task_space())) {
    if (!arguments.slice.empty())
      problems.push_back("In " + std::string(name(robot.task_space())) +
                         " every aspect is a uniqueness domain as a whole; leave --slice out.");
    return std::nullopt;
  }
  refuse_other_bounds(arguments.constraints, robot, problems);
  if (!problems.empty()) return std::nullopt;
  if (!arguments.slice.empty()) return parse_joint_slice("--slice", robot, arguments.slice, problems);
  const std::string example = example_of_held_joint(robot);
  if (!has_elbows(robot))
    refuse_all_poses(arguments, described, robot, problems);
  else if (!example.empty())
    problems.push_back(
        "In SE2 actuated values are looked at in slices that hold an actuated joint; give "
        "--slice " +
        example + ".");
  return std::nullopt;
}

/// That of the poses of the picture; nothing where none was given.
std::optional<WorkingMode> drawn_mode(const UniquenessArguments& arguments, const Manipulator& robot,
                                      Problems& problems) {
  if (arguments.mode.empty()) return std::nullopt;
  if (arguments.picture.empty())
    problems.emplace_back("--mode chooses the working mode of --picture; give that too, or leave it out.");
  const auto mode = parse_mode("--mode", robot, arguments.mode, problems);
  const std::vector<WorkingMode> modes = working_modes(robot);
  if (!mode || std::find(modes.begin(), modes.end(), *mode) != modes.end()) return mode;
  problems.push_back(
      "--mode is '" + arguments.mode + "', which '" + robot.name() +
      "' does not have: B_jj of a strut has one sign. `aspects describe` lists its working modes.");
  return std::nullopt;
}

Report report_of(const UniquenessArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto described = mechanism->mapped_manipulator();
  const auto manipulator = choose_constraints(described, arguments.constraints);
  Problems problems;
  check_picture_file("--picture", arguments.picture, problems);
  if (manipulator->task_space() == TaskSpace::SO3 && !arguments.slice.empty())
    return report_of_cusps(arguments, *manipulator, std::move(problems), surroundings);
  if (is_surveyed(*manipulator))
    return report_of_survey(arguments, manipulator, std::move(problems), surroundings);
  refuse(roadmap_options_of(arguments), "",
         " is of the roadmap of SO3 or SE3, and '" + manipulator->name() + "' moves in " +
             std::string(name(manipulator->task_space())) + "; leave it out.",
         problems);
  if (!arguments.cusps_over.empty())
    return report_of_curves(arguments, *manipulator, std::move(problems), surroundings);
  UniquenessOptions options;
  options.slice = slice_of(arguments, *described, *manipulator, problems);
  if (!arguments.resolution.empty())
    options.resolution = parse_positive("--resolution", arguments.resolution, problems);
  const bool has_numbers = manipulator->task_space() == TaskSpace::SE2 && !has_elbows(*manipulator);
  if (!arguments.picture.empty() && !(has_numbers && !arguments.slice.empty()))
    problems.push_back("--picture shows numbers of direct solutions in slices of SE2; " +
                       (has_numbers ? "give one with --slice, or leave it out."
                                    : "of '" + manipulator->name() +
                                          "' there are none. Leave it out, `plot` draws its aspects."));
  const auto mode = drawn_mode(arguments, *manipulator, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const auto result = completed(surroundings, [&](const MapControl& control) {
    return compute_uniqueness(manipulator, options, control);
  });
  if (!arguments.picture.empty())
    write_picture_file(arguments.picture, draw_uniqueness(*result.uniqueness, mode));
  return report_uniqueness(*result.uniqueness);
}

}  // namespace

Subcommand uniqueness_subcommand() {
  const auto arguments = std::make_shared<UniquenessArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  options.push_back({"--slice", "\"strut_1_joint=15\"",
                     "In SE2 and SO3: the actuated joint that is held, with its value [m or rad], in SO3 for "
                     "cusps and numbers of solutions; "
                     "without it, in SE2, all poses, where struts and slides have limits",
                     &arguments->slice, false, Words::assignments});
  options.push_back(
      {"--cusps-over", "\"strut_1_joint=10:32\"",
       "In SE2: the curves that cusps form while this actuated joint is held at each value of the "
       "range [m or rad] in turn, by default within its limits; they alone are listed",
       &arguments->cusps_over});
  options.push_back({"--resolution", "R",
                     "Longest edge of an undecided leaf of the map of aspects [m or rad]; by default what "
                     "suits the robot",
                     &arguments->resolution});
  options.push_back({"--picture", "FILE",
                     "Draw the poses of the slice and its actuated values, with singular curves, cusps and "
                     "numbers of solutions, or the curves of cusps, as SVG or PNG",
                     &arguments->picture, false, Words::one, FileUse::written});
  options.push_back({"--mode", "\"(-,-,-)\"",
                     "Working mode of the poses of the picture, as signs of B_jj; by default that with the "
                     "largest components",
                     &arguments->mode, false, Words::signs});
  options.push_back({"--samples", "N", "In SO3 and SE3: poses of the certified roadmap, by default 1000",
                     &arguments->roadmap.samples});
  options.push_back(
      {"--seed", "N", "In SO3 and SE3: seed of its poses, by default 1", &arguments->roadmap.seed});
  options.push_back({"--poses", "N",
                     "In SO3 and SE3: configurations of the roadmap whose direct solutions are looked at, by "
                     "default 1000; some milliseconds each",
                     &arguments->poses});
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"uniqueness",
          "Tell which poses of an aspect have the same actuated values, and where direct solutions meet",
          options,
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); }};
}

}  // namespace parallel_aspects::tools
