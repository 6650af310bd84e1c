// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/plan_path.h"
#include "tools/arguments.h"
#include "tools/map_choice.h"
#include "tools/report/plan_report.h"
#include "tools/subcommands.h"

#include <memory>
#include <utility>

namespace parallel_aspects::tools {
namespace {

struct PlanArguments {
  RobotChoice robot;
  std::string from, to, from_mode, to_mode, policy;
  MapChoice map;
  RoadmapArguments roadmap;
  ConstraintArguments constraints;
};

/// What is asked, with every number understood.
struct Question {
  PathEnd from, to;
  PathPolicy policy = PathPolicy::stay;
};

PathPolicy parse_policy(const std::string& text, Problems& problems) {
  if (text == "serial") return PathPolicy::serial;
  if (!text.empty() && text != "stay")
    problems.push_back("--policy is '" + text +
                       "'; give stay, to stay in one aspect, or serial, to pass serial "
                       "singularities.");
  return PathPolicy::stay;
}

PathEnd parse_end(const std::string& option, const Manipulator& manipulator, const std::string& pose,
                  const std::string& mode, Problems& problems) {
  PathEnd end;
  end.pose = parse_pose(option, manipulator.task_space(), pose, problems);
  if (!mode.empty()) end.mode = parse_mode(option + "-mode", manipulator, mode, problems);
  return end;
}

Question parse(const PlanArguments& arguments, const Manipulator& manipulator) {
  Problems problems;
  const Question question{parse_end("--from", manipulator, arguments.from, arguments.from_mode, problems),
                          parse_end("--to", manipulator, arguments.to, arguments.to_mode, problems),
                          parse_policy(arguments.policy, problems)};
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return question;
}

Report report_of(const PlanArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto manipulator = choose_constraints(mechanism->mapped_manipulator(), arguments.constraints);
  const Question question = parse(arguments, *manipulator);
  PathPlanner planner(choose_map(manipulator, arguments.map, surroundings));
  MapControl control;
  control.cancelled = surroundings.interrupted;
  const PlannedPath path = planner.plan(question.from, question.to, question.policy, control);
  if (is_cancelled(control)) throw Interrupted{};
  return report_path(*manipulator, path, question.policy);
}

}  // namespace

Subcommand plan_subcommand() {
  const auto arguments = std::make_shared<PlanArguments>();
  std::vector<Option> options = robot_options(arguments->robot);
  options.push_back(
      {"--from", "\"x y\"", "Where the path begins: a pose, quoted; lengths [m]", &arguments->from, true});
  options.push_back({"--to", "\"x y\"", "Where it ends", &arguments->to, true});
  options.push_back({"--from-mode", "\"(+,-)\"",
                     "Working mode at the start, as signs of B_jj; by default any", &arguments->from_mode});
  options.push_back(
      {"--to-mode", "\"(+,-)\"", "Working mode at the goal; by default any", &arguments->to_mode});
  options.push_back({"--policy", "stay|serial",
                     "stay: in one aspect, the default. serial: legs may change their posture on the way",
                     &arguments->policy});
  for (const Option& option : map_choice_options(arguments->map)) options.push_back(option);
  for (const Option& option : constraint_options(arguments->constraints)) options.push_back(option);
  return {"plan", "Plan a path that is proved, or prove that there is none", options,
          [arguments](const Surroundings& surroundings) { return report_of(*arguments, surroundings); }};
}

}  // namespace parallel_aspects::tools
