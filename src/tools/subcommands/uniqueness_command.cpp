// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/tree/held_joint_example.h"
#include "aspects/uniqueness/uniqueness_problem.h"
#include "parallel_aspects/ask/uniqueness_question.h"
#include "tools/arguments.h"
#include "tools/drawing/uniqueness_drawing.h"
#include "tools/output_file.h"
#include "tools/question_options.h"
#include "tools/report/answer_json.h"
#include "tools/report/constraints_report.h"
#include "tools/report/uniqueness_report.h"

#include <algorithm>
#include <memory>
#include <variant>

namespace parallel_aspects::tools {
namespace {

struct UniquenessArguments : QuestionArguments {
  std::string picture, mode;  // empty where not given
};

/// Constraints that the answer would not be within, and limits that were left out though struts or slides
/// need some.
ask::ProblemList problems_of_bounds(const ask::ConstraintChoice& chosen, const Manipulator& described,
                                    const Manipulator& robot, const ask::UniquenessQuestion& question) {
  ask::ProblemList problems;
  const TaskSpace space = robot.task_space();
  if (space == TaskSpace::SE2 || (space == TaskSpace::SO3 && question.slice))
    refuse_other_bounds(chosen, robot, problems);
  else if (!has_one_solution_a_sign(space))
    refuse_tolerance(chosen, robot, problems);
  const std::size_t limits = index_of(ConstraintKind::actuated_limits);
  const bool left_out = described.constraint_kinds()[limits] && !robot.constraint_kinds()[limits];
  if (!problems.empty() || space != TaskSpace::SE2 || question.slice || question.cusps_over || !left_out ||
      has_elbows(robot) || !has_lengths_without_limit(robot))
    return problems;
  const std::string field = chosen.without.empty() ? "{constraint}" : "{no_constraint}";
  problems.push_back(
      {ask::ProblemKind::together, "slice",
       "All poses of '" + ask::given(robot.name()) + "' are examined within limits of its joints, and " +
           field + " takes these out",
       "keep actuated_limits, or give {slice} " + ask::given(example_of_held_joint(described))});
  return problems;
}

/// The working mode of the poses of the picture; nothing where none was given.
std::optional<WorkingMode> check_picture(const UniquenessArguments& arguments, const Manipulator& robot,
                                         const ask::UniquenessQuestion& question, Problems& problems) {
  const bool has_numbers = robot.task_space() == TaskSpace::SE2 && !has_elbows(robot);
  if (!arguments.picture.empty() && !question.cusps_over && !(has_numbers && question.slice))
    problems.push_back(
        "--picture shows numbers of direct solutions in slices of SE2; " +
        (has_numbers ? "give one with --slice, or leave it out."
                     : "of '" + robot.name() + "' there are none. Leave it out, `plot` draws its aspects."));
  if (arguments.mode.empty()) return std::nullopt;
  if (question.cusps_over || arguments.picture.empty())
    problems.emplace_back(
        "--mode chooses the working mode of a slice's --picture; " +
        std::string(question.cusps_over ? "leave it out." : "give that too, or leave it out."));
  const auto mode = parse_mode("--mode", robot, arguments.mode, problems);
  const std::vector<WorkingMode> modes = working_modes(robot);
  if (!mode || std::find(modes.begin(), modes.end(), *mode) != modes.end()) return mode;
  problems.push_back(
      "--mode is '" + arguments.mode + "', which '" + robot.name() +
      "' does not have: B_jj of a strut has one sign. `aspects describe` lists its working modes.");
  return std::nullopt;
}

void throw_any(const Problems& problems) {
  if (!problems.empty()) throw InvalidDescription(problems);
}

Report report_of(const UniquenessArguments& arguments, const Surroundings& surroundings) {
  const auto mechanism = load_robot(arguments.robot);
  const auto described = mechanism->mapped_manipulator();
  const auto robot = choose_constraints(described, arguments.constraints);
  Problems problems;
  check_picture_file("--picture", arguments.picture, problems);
  const auto question = read_question<ask::UniquenessQuestion>(*robot, arguments.texts, problems);
  throw_any(problems);
  const auto bounds =
      problems_of_bounds(constraint_choice(*robot, arguments.constraints), *described, *robot, question);
  if (!bounds.empty()) refuse(bounds);
  const auto mode = check_picture(arguments, *robot, question, problems);
  for (const std::string& each : texts_of(problems_of(*robot, question), option_name))
    problems.push_back(each);
  throw_any(problems);
  const ask::UniquenessAnswer answer = asked(robot, question, surroundings);
  if (const auto* curves = std::get_if<ask::CuspsOverJoint>(&answer.found);
      curves != nullptr && !arguments.picture.empty())
    write_picture_file(arguments.picture, draw_cusp_curves(*robot, curves->found));
  else if (!arguments.picture.empty())
    write_picture_file(arguments.picture, draw_uniqueness(*std::get<0>(answer.found), mode));
  Report report = report_constraints(*robot);
  report.json.update(answer_json(*robot, answer));
  report.json["mechanism"] = robot->name();
  const auto text_of = [&robot](const auto& found) { return uniqueness_text(*robot, found); };
  report.text = std::visit(text_of, answer.found) + '\n' + report.text;
  return report;
}

}  // namespace

Subcommand uniqueness_subcommand() {
  const auto arguments = std::make_shared<UniquenessArguments>();
  return question_subcommand<ask::UniquenessQuestion>(
      "uniqueness",
      "Find which poses of an aspect have the same actuated values, and where direct solutions meet",
      arguments, report_of, {},
      {{"--picture", "FILE",
        "Draw the poses of the slice and its actuated values, with singular curves, cusps and numbers of "
        "solutions, or the curves of cusps, as SVG or PNG",
        &arguments->picture, false, Words::one, FileUse::written},
       {"--mode", "\"(-,-,-)\"",
        "Working mode of the poses of the picture, as signs of B_jj; by default that with the largest "
        "components",
        &arguments->mode, false, Words::signs}});
}

}  // namespace parallel_aspects::tools
