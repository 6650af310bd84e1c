// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/held_joint_example.h"
#include "model/number_text.h"
#include "motion/choose/plan_around_cusp.h"
#include "motion/plan/end_aspects.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "parallel_aspects/motion/plan_path.h"
#include "tools/arguments.h"
#include "tools/computation.h"
#include "tools/held_range.h"
#include "tools/map_choice.h"
#include "tools/motion_report/plan_report.h"
#include "tools/numbers.h"
#include "tools/output_file.h"
#include "tools/paths/path_ends.h"
#include "tools/paths/path_timing.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {
namespace {

struct PlanArguments {
  RobotChoice robot;
  PathEndArguments from, to;
  std::string policy, prefer, around_cusp;
  MapChoice map;
  RoadmapArguments roadmap;
  ConstraintArguments constraints;
  TimingArguments timing;
};

/// What is asked, with every number understood.
struct PlanQuestion {
  PathEnd from, to;
  PathWish wish;
  std::optional<JointVector> acceleration;  // limits; nothing where paths cannot be timed
  std::optional<std::size_t> around_cusp;   // from 0
  std::optional<MapSlice> slice;
  double moved = 0.0;  // onto the slice, at most [m]
};

PathPolicy parse_policy(const std::string& text, Problems& problems) {
  for (const PathPolicy policy : {PathPolicy::stay, PathPolicy::serial, PathPolicy::any})
    if (text == name(policy)) return policy;
  if (!text.empty())
    problems.push_back(
        "--policy is '" + text +
        "'; give stay, to stay in one aspect, serial, to pass serial singularities, or any, to "
        "pass parallel ones too.");
  return PathPolicy::stay;
}

PathPreference parse_preference(const std::string& text, Problems& problems) {
  for (const PathPreference prefer :
       {PathPreference::shortest, PathPreference::clear, PathPreference::fast, PathPreference::quick})
    if (text == name(prefer)) return prefer;
  if (!text.empty()) problems.push_back("--prefer is '" + text + "'; give short, clear, fast or quick.");
  return PathPreference::quick;
}

constexpr unsigned most_cusps = 10000;

/// Cusps are points in slices of SE2 alone, of one robot, within limits of its actuated joints.
void check_slice_of_cusps(const PlanArguments& arguments, const Manipulator& robot, Problems& problems) {
  if (robot.task_space() != TaskSpace::SE2)
    return problems.push_back("--around-cusp is of robots that move in SE2, and '" + robot.name() +
                              "' moves in " + std::string(name(robot.task_space())) + "; leave it out.");
  const std::size_t known = problems.size();
  refuse_other_bounds(arguments.constraints, robot, problems);
  if (problems.size() > known) return;
  if (!arguments.map.slice.empty())
    parse_joint_slice("--hold", robot, arguments.map.slice, problems);
  else if (const std::string example = example_of_held_joint(robot); !example.empty())
    problems.push_back(
        "--around-cusp needs a slice that holds an actuated joint, where cusps are points; give --hold with "
        "its value at the start, such as " +
        example + ".");
  else
    problems.push_back("--around-cusp needs an actuated joint that can be held, and '" + robot.name() +
                       "' has none; leave it out.");
}

/// The number of a cusp, from 0, and what does not go with it.
std::size_t parse_cusp(const PlanArguments& arguments, const Manipulator& robot, Problems& problems) {
  check_slice_of_cusps(arguments, robot, problems);
  const auto& to = arguments.to;
  if (!to.pose.empty() || !to.mode.empty() || !to.joints.empty() || !to.aspect.empty())
    problems.emplace_back(
        "--around-cusp ends at the actuated values of the start; leave out what says where the path ends.");
  if (!arguments.policy.empty() || !arguments.prefer.empty())
    problems.emplace_back(
        "--around-cusp stays in one aspect, on a clear path; leave out --policy and "
        "--prefer.");
  const std::size_t number = parse_count("--around-cusp", arguments.around_cusp, most_cusps, problems, 1);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return number - 1;
}

PlanQuestion parse(const PlanArguments& arguments, const Manipulator& manipulator) {
  Problems problems;
  PlanQuestion question;
  question.from = parse_path_end("--from", manipulator, arguments.from, problems);
  if (arguments.around_cusp.empty())
    question.to = parse_path_end("--to", manipulator, arguments.to, problems);
  else
    question.around_cusp = parse_cusp(arguments, manipulator, problems);
  question.wish.policy = parse_policy(arguments.policy, problems);
  question.wish.prefer = parse_preference(arguments.prefer, problems);
  std::vector<NamedPose> poses;  // an aspect's lie in the slice
  if (arguments.from.aspect.empty()) poses.push_back({"--from", &question.from.pose});
  if (arguments.to.aspect.empty() && !question.around_cusp) poses.push_back({"--to", &question.to.pose});
  question.slice =
      parse_slice_with_ends("--hold", manipulator, arguments.map.slice, poses, question.moved, problems);
  const std::string needs_control = question.wish.prefer == PathPreference::fast ? "--prefer fast"
                                    : !arguments.timing.trajectory_file.empty()  ? "--trajectory"
                                                                                 : "";
  if (question.wish.policy == PathPolicy::any && !needs_control.empty())
    problems.push_back(needs_control +
                       " needs a platform that is under control all the way, and --policy any may pass det A "
                       "= 0; give --policy serial.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return question;
}

/// A path, and how the pose runs between two of its points.
struct Plan {
  PlannedPath path;
  PoseBetween between = pose_between;
  ChosenMap map{};                        // none over a roadmap
  std::vector<int> turns_around_cusps{};  // by cusp; empty where not asked for
  double followed_noise = 0.0;            // where that is asked for
};

/// With what tells how long a path takes, where that counts. The certifier outlives it.
PathWish wish_of(const PlanQuestion& question, const SegmentCertifier& certifier, const PoseBetween& between,
                 const MapControl& control) {
  PathWish wish = question.wish;
  if (wish.prefer == PathPreference::fast)
    wish.time = path_timer(certifier, between, *question.acceleration, control);
  return wish;
}

/// With six degrees of freedom there is no map but a roadmap.
Plan plan_over_roadmap(const std::shared_ptr<const Manipulator>& manipulator, const PlanArguments& arguments,
                       const PlanQuestion& question, const Surroundings& surroundings) {
  Problems problems;
  RoadmapOptions options = parse_roadmap(arguments.roadmap, problems);
  if (question.wish.policy == PathPolicy::any)
    problems.emplace_back(
        "--policy any needs a map, and in SE3 there is none; give --policy serial, or --hold.");
  const MapChoice& map = arguments.map;
  if (!map.resolution.empty() || !map.load_file.empty() || !map.save_file.empty())
    problems.emplace_back(
        "--resolution, --load and --save are for maps, and in SE3 there is none; leave them out.");
  if (!arguments.from.aspect.empty() || !arguments.to.aspect.empty())
    problems.emplace_back(
        "--from-aspect and --to-aspect are for maps, and in SE3 there is none; give poses.");
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  for (const std::optional<WorkingMode>& mode : {question.from.mode, question.to.mode})
    if (mode && std::find(options.modes.begin(), options.modes.end(), *mode) == options.modes.end())
      options.modes.push_back(*mode);
  if (auto none = excluded_end(SegmentCertifier(manipulator), question.from, question.to)) return {*none};
  const auto roadmap = compute_roadmap(manipulator, options, surroundings);
  const MapControl control = control_of(surroundings);
  PlannedPath path = plan_in_roadmap(*roadmap, question.from, question.to,
                                     wish_of(question, roadmap->certifier(), pose_between, control), control);
  if (is_cancelled(control)) throw Interrupted{};
  return {std::move(path)};
}

Plan plan_in_map(const std::shared_ptr<const Manipulator>& manipulator, const PlanArguments& arguments,
                 const PlanQuestion& question, const Surroundings& surroundings) {
  if (!arguments.roadmap.samples.empty() || !arguments.roadmap.seed.empty())
    throw InvalidDescription(
        {"--samples and --seed are for roadmaps, in SE3 without --hold; leave them out."});
  const SegmentCertifier certifier(manipulator);
  const bool has_aspect = !arguments.from.aspect.empty() || !arguments.to.aspect.empty();
  if (!has_aspect && arguments.map.save_file.empty())
    if (auto none = excluded_end(certifier, question.from, question.to)) return {*none};
  const ChosenMap chosen = choose_map(manipulator, arguments.map, question.slice, surroundings);
  const auto& map = chosen.map;
  Problems problems;
  PathEnd from = question.from, to = question.to;
  place_in_aspect("--from", *map, arguments.from, from, problems);
  place_in_aspect("--to", *map, arguments.to, to, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const auto planner = std::make_shared<PathPlanner>(map);
  const PoseBetween between = [planner](const Pose& a, const Pose& b, double t) {
    return planner->between(a, b, t);
  };
  const MapControl control = control_of(surroundings);
  PlannedPath path = planner->plan(from, to, wish_of(question, certifier, between, control), control);
  if (is_cancelled(control)) throw Interrupted{};
  return {std::move(path), between, chosen};
}

/// Where to begin in place of a start without a path, with digits that take it onto the slice again.
std::string other_start_text(const Manipulator& manipulator, const CuspStart& start,
                             const std::string& cusp) {
  if (start.aspect == 0) return "";
  const std::string text = " Cusp " + cusp + " belongs to component " + std::to_string(start.aspect);
  if (!start.point) return text + ", but from no pose beside it a path is found.";
  constexpr int digits = 10;
  const bool has_modes = working_modes(manipulator).size() > 1;
  std::string values;
  for (Eigen::Index j = 0; j < start.point->q.size(); ++j)
    values += (j == 0 ? "" : " ") + number_text(start.point->q[j], digits);
  return text + "; a start of that component with a path is --from \"" +
         pose_argument(manipulator.task_space(), start.point->pose, digits) + "\"" +
         (has_modes ? " --from-mode \"" + to_string(start.point->mode) + "\"" : "") +
         ", where the actuated values are \"" + values + "\".";
}

/// In one aspect of a slice, back to the actuated values of the start.
Plan plan_around_cusp(const std::shared_ptr<const Manipulator>& manipulator, const PlanArguments& arguments,
                      const PlanQuestion& question, const Surroundings& surroundings) {
  UniquenessOptions options;
  options.slice = question.slice;
  const std::string problem = find_uniqueness_problem(*manipulator, options);
  if (!problem.empty()) throw InvalidDescription({problem});
  const ChosenMap chosen = choose_map(manipulator, arguments.map, question.slice, surroundings);
  const MapControl control = control_of(surroundings);
  const CuspList cusps = find_cusps(*manipulator, *question.slice->joint, control);
  if (is_cancelled(control)) throw Interrupted{};
  if (*question.around_cusp >= cusps.cusps.size())
    throw InvalidDescription({"--around-cusp is " + arguments.around_cusp + ", but the slice has " +
                              counted(cusps.cusps.size(), "cusp") +
                              "; `aspects uniqueness` lists them with their numbers."});
  Problems problems;
  PathEnd from = question.from;
  place_in_aspect("--from", *chosen.map, arguments.from, from, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const auto planner = std::make_shared<CuspPlanner>(chosen.map, cusps.cusps);
  PlannedPath path = planner->plan(from, *question.around_cusp, control);
  if (!path)
    path.message += other_start_text(*manipulator, planner->find_start(*question.around_cusp, control),
                                     arguments.around_cusp);
  if (is_cancelled(control)) throw Interrupted{};
  std::vector<int> turns = planner->turns_around_cusps(path);
  const double noise = path ? planner->followed_noise(path) : 0.0;
  return {std::move(path),
          [planner](const Pose& a, const Pose& b, double t) { return planner->between(a, b, t); }, chosen,
          std::move(turns), noise};
}

/// Which actuated joints arrive whole turns from the values that were asked for; empty where none does.
std::string turned_text(const Manipulator& manipulator, const PathEnd& to, const PlannedPath& path) {
  if (!to.q || !path) return "";
  std::string text;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    const double value = path.points.back().q[static_cast<Eigen::Index>(j)],
                 asked = (*to.q)[static_cast<Eigen::Index>(j)];
    if (leg.actuated_by_angle() && std::abs(value - asked) > EIGEN_PI)
      text += " '" + leg.actuated_joint + "' arrives at " + shown(value) +
              ", whole turns from what --to-joints says.";
  }
  return text;
}

/// How far from where it was asked for a path begins or ends, and where it does.
std::string moved_text(const Manipulator& manipulator, const PlannedPath& path,
                       const PlanQuestion& question) {
  constexpr int pose_digits = 10;
  std::string text = question.around_cusp ? "the start is" : "the ends are";
  text += " moved onto the slice, by at most " + shown(question.moved) + " m";
  if (!path.points.empty())
    text += ": from \"" + pose_argument(manipulator.task_space(), path.points.front().pose, pose_digits) +
            "\" to \"" + pose_argument(manipulator.task_space(), path.points.back().pose, pose_digits) + "\"";
  return text + "\n";
}

/// How often the actuated values go around each cusp.
void add_cusps(const Plan& plan, const std::optional<std::size_t>& asked, Report& report) {
  report.json["around_cusp"] = asked ? nlohmann::json(*asked + 1) : nlohmann::json();
  report.json["turns_around_cusps"] = asked ? nlohmann::json(plan.turns_around_cusps) : nlohmann::json();
  const bool found = asked && plan.path;
  report.json["encoder_noise"] = found ? nlohmann::json(plan.followed_noise) : nlohmann::json();
  if (!found) return;
  report.text += "the actuated values go";
  std::string around;
  for (std::size_t k = 0; k < plan.turns_around_cusps.size(); ++k)
    if (const int turns = plan.turns_around_cusps[k]; turns != 0)
      around += (around.empty() ? "" : ",") + std::string(" around cusp ") + std::to_string(k + 1) + " " +
                (std::abs(turns) == 1 ? "once" : counted(static_cast<std::size_t>(std::abs(turns)), "time")) +
                (turns > 0 ? " counter-clockwise" : " clockwise");
  report.text += around + "\n" + noise_text(plan.followed_noise) + "\n";
}

int code_of(SameAspect answer) {
  switch (answer) {
    case SameAspect::yes:
      return exit_code::ok;
    case SameAspect::no:
      return exit_code::unsafe;
    case SameAspect::unknown:
      break;
  }
  return exit_code::unknown;
}

/// Adds the path in time, where the limits for that are known.
void add_timing(const std::shared_ptr<const Manipulator>& manipulator, const PlanArguments& arguments,
                const Plan& plan, const std::optional<JointVector>& acceleration,
                const Surroundings& surroundings, Report& report) {
  report.json["seconds"] = nullptr;
  report.json["trajectory_file"] = nullptr;
  if (!acceleration || !plan.path) return;
  const MapControl control = control_of(surroundings);
  const TimedPath timed =
      time_path(SegmentCertifier(manipulator), plan.path, plan.between, *acceleration, control);
  if (is_cancelled(control)) throw Interrupted{};
  report_timing(*manipulator, arguments.timing, timed, report);
}

/// A map may be loaded from the file that it is saved to.
void check_files(const PlanArguments& arguments, Problems& problems) {
  const NamedFile trajectory{"--trajectory", arguments.timing.trajectory_file};
  check_output_file("--save", arguments.map.save_file, problems);
  check_distinct_files({{"--save", arguments.map.save_file}, trajectory},
                       {{"--urdf", arguments.robot.urdf_file}, {"--config", arguments.robot.config_file}},
                       problems);
  check_distinct_files({trajectory}, {{"--load", arguments.map.load_file}}, problems);
}

Report report_of(const PlanArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto manipulator = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  PlanQuestion question = parse(arguments, *manipulator);
  Problems problems;
  check_files(arguments, problems);
  const std::string needed_by = question.wish.prefer == PathPreference::fast ? "--prefer fast" : "";
  question.acceleration = parse_timing(arguments.timing, needed_by, arguments.robot, *manipulator, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  const bool has_map = question.slice || manipulator->task_space() != TaskSpace::SE3;
  const auto plan_path = question.around_cusp ? plan_around_cusp : has_map ? plan_in_map : plan_over_roadmap;
  Plan plan = plan_path(manipulator, arguments, question, surroundings);
  plan.path.message += turned_text(*manipulator, question.to, plan.path);
  Report report = report_path(*manipulator, plan.path, question.wish, question.slice);
  report.exit_code = code_of(plan.path.answer);
  report.json["loaded"] = nullptr;
  add_cusps(plan, question.around_cusp, report);
  if (plan.map.map) report_source(arguments.map, plan.map, report);
  report.json["moved_onto_slice"] = question.slice ? nlohmann::json(question.moved) : nlohmann::json();
  if (question.moved > 0.0) report.text += moved_text(*manipulator, plan.path, question);
  add_timing(manipulator, arguments, plan, question.acceleration, surroundings, report);
  const std::string& file = arguments.timing.trajectory_file;
  if (!file.empty() && report.json["trajectory_file"].is_null())
    surroundings.messages << file << " is not written; what it may hold is older." << std::endl;
  return report;
}

}  // namespace

Subcommand plan_subcommand() {
  const auto arguments = std::make_shared<PlanArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  for (const Option& option : path_end_options("--from", arguments->from)) options.push_back(option);
  for (const Option& option : path_end_options("--to", arguments->to)) options.push_back(option);
  options.push_back({"--policy", "stay|serial|any",
                     "stay: in one aspect, the default. serial: legs may change their posture on the way. "
                     "any: through det A = 0 too, where control of the platform is lost; each such place is "
                     "listed",
                     &arguments->policy});
  options.push_back(
      {"--prefer", "short|clear|fast|quick",
       "Which of several paths. short: the shortest that is found. clear: the one with the largest "
       "least parallel index. fast: the one that takes the least time. quick: a short one that "
       "is found soonest, the default",
       &arguments->prefer});
  options.push_back(
      {"--around-cusp", "N",
       "In place of an end, with --hold: around this cusp of those that `uniqueness` lists, back to the "
       "actuated values of the start in another assembly mode of its aspect",
       &arguments->around_cusp});
  for (const Option& option : map_choice_options(arguments->map, "--hold")) options.push_back(option);
  options.push_back({"--samples", "N", "With six degrees of freedom: poses of the roadmap, by default 1000",
                     &arguments->roadmap.samples});
  options.push_back({"--seed", "N", "With six degrees of freedom: seed of its poses, by default 1",
                     &arguments->roadmap.seed});
  for (const Option& option : timing_options(arguments->timing)) options.push_back(option);
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"plan", "Plan a path that is proved, or prove that there is none", options,
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); }};
}

}  // namespace parallel_aspects::tools
