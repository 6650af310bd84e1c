// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/uniqueness_question.h"

#include "aspects/tree/held_joint_example.h"
#include "aspects/uniqueness/uniqueness_problem.h"
#include "motion/assembly_survey.h"

namespace parallel_aspects::ask {
namespace {

constexpr unsigned default_poses = 1000;

/// A problem for each field that is given and not one of `allowed`; its name goes where "{}" is.
void allow(const std::vector<std::string>& allowed, const UniquenessQuestion& question,
           const std::string& fault, const std::string& remedy, ProblemList& problems) {
  const auto named = [](std::string text, const std::string& field) {
    const std::size_t at = text.find("{}");
    return at == std::string::npos ? text : text.insert(at + 1, field);
  };
  const std::vector<std::pair<std::string, bool>> fields{
      {"slice", question.slice.has_value()},           {"cusps_over", question.cusps_over.has_value()},
      {"resolution", question.resolution.has_value()}, {"samples", question.roadmap.samples.has_value()},
      {"seed", question.roadmap.seed.has_value()},     {"poses", question.poses.has_value()}};
  for (const auto& [field, is_given] : fields)
    if (is_given && !contains(allowed, field))
      problems.push_back({ProblemKind::together, field, named(fault, field), named(remedy, field)});
}

void add_told(const std::string& sentence, ProblemList& problems) {
  if (!sentence.empty()) problems.push_back(told(sentence));
}

/// Where there is no theorem and there are no slices.
bool is_surveyed(const Manipulator& robot) {
  return !has_one_solution_a_sign(robot.task_space()) && robot.task_space() != TaskSpace::SE2;
}

/// In SO3 with a joint held.
bool lists_cusps(const Manipulator& robot, const UniquenessQuestion& question) {
  return robot.task_space() == TaskSpace::SO3 && question.slice;
}

UniquenessOptions options_of(const Manipulator& robot, const UniquenessQuestion& question,
                             ProblemList& problems) {
  UniquenessOptions options{{}, question.resolution, question.most_cells};
  if (!question.slice) return options;
  Problems wrong;
  const HeldJoint& held = *question.slice;
  options.slice = make_slice(robot, {{robot.leg(held.leg).actuated_joint, held.value}}, wrong);
  add_told(wrong, problems);
  return options;
}

void check_map(const Manipulator& robot, const UniquenessQuestion& question, ProblemList& problems) {
  const std::string space(name(robot.task_space())), example = given(example_of_held_joint(robot));
  const std::size_t known = problems.size();
  if (has_one_solution_a_sign(robot.task_space()))
    return allow({"resolution"}, question, "In " + space + " every aspect is a uniqueness domain as a whole",
                 "leave {} out", problems);
  if (!question.slice && has_elbows(robot) && !example.empty())
    return problems.push_back({ProblemKind::robot, "slice",
                               "In SE2 actuated values are examined in slices that hold an actuated joint",
                               "give {slice} " + example});
  const UniquenessOptions options = options_of(robot, question, problems);
  if (problems.size() == known) add_told(find_uniqueness_problem(robot, options), problems);
}

std::shared_ptr<const Uniqueness> of_map(Session& session, const UniquenessQuestion& question,
                                         const Control& control, ProblemList& problems) {
  const UniquenessOptions options = options_of(*session.robot(), question, problems);
  const bool is_known = session.known_map() && !options.slice && !options.resolution;
  const MapControl begun = control.begin("Looking for uniqueness domains.");
  const UniquenessResult result = is_known ? compute_uniqueness(session.known_map(), options, begun)
                                           : compute_uniqueness(session.robot(), options, begun);
  if (result.status == MapStatus::refused) problems.push_back(told(result.message));
  return result.uniqueness;
}

CuspsInSlice cusps_of(const Manipulator& robot, const HeldJoint& held, const Control& control) {
  const MapControl begun = control.begin("Looking for cusps.");
  return {robot.leg(held.leg).actuated_joint, held, find_cusps(robot, held, part_of(begun, 0.0, 0.4)),
          count_direct_solutions(robot, held, part_of(begun, 0.4, 1.0))};
}

SurveyOfRoadmap survey_of(Session& session, const UniquenessQuestion& question, const Control& control,
                          ProblemList& problems) {
  SurveyOfRoadmap result;
  result.roadmap = session.roadmap(question.roadmap.options({}), control, problems);
  if (!result.roadmap) return result;
  const unsigned poses = question.poses ? question.poses->value : default_poses;
  const auto survey =
      survey_assembly_modes(*result.roadmap, poses, control.begin("Looking at direct solutions."));
  if (survey) result.survey = *survey;
  return result;
}

}  // namespace

bool are_of_all_modes(const Uniqueness& uniqueness) {
  return working_modes(*uniqueness.map->manipulator()).size() > 1 && !uniqueness.by_mode;
}

std::optional<std::size_t> component_below(const Uniqueness& uniqueness, const BasicRegion& region) {
  if (are_of_all_modes(uniqueness)) return std::nullopt;
  const WorkingMode mode = region.aspect == 0
                               ? WorkingMode()
                               : uniqueness.map->aspects()[static_cast<std::size_t>(region.aspect - 1)].mode;
  return uniqueness.component_at(region.actuated, mode);
}

ProblemList problems_of(const Manipulator& robot, const UniquenessQuestion& question) {
  ProblemList problems;
  const std::string space(name(robot.task_space()));
  if (lists_cusps(robot, question)) {
    allow({"slice"}, question, "In SO3 {slice} lists cusps and numbers of direct solutions alone",
          "leave {} or it out", problems);
    add_told(find_cusps_problem(robot, *question.slice), problems);
  } else if (is_surveyed(robot)) {
    allow({"samples", "seed", "poses"}, question, "In " + space + " a roadmap is examined, which has no {}",
          "leave it out", problems);
    if (robot.tolerance() > 0.0)
      problems.push_back(told("Direct solutions are those of one robot, without tolerances."));
  } else {
    allow({"slice", "cusps_over", "resolution"}, question,
          "{} is of the roadmap of SO3 or SE3, and '" + given(robot.name()) + "' moves in " + space,
          "leave it out", problems);
    if (!question.cusps_over) {
      if (problems.empty()) check_map(robot, question, problems);
      return problems;
    }
    if (problems.empty())
      allow({"cusps_over"}, question, "{cusps_over} lists curves of cusps alone", "leave {} or it out",
            problems);
    add_told(find_held_range_problem(robot, *question.cusps_over), problems);
  }
  return problems;
}

Outcome<UniquenessAnswer> answer(Session& session, const UniquenessQuestion& question,
                                 const Control& control) {
  const Manipulator& robot = *session.robot();
  ProblemList problems = problems_of(robot, question);
  UniquenessAnswer result{robot.task_space(), {}};
  if (!problems.empty()) return outcome_of(std::move(problems), control, std::move(result));
  if (lists_cusps(robot, question)) {
    result.found = cusps_of(robot, *question.slice, control);
  } else if (is_surveyed(robot)) {
    result.found = survey_of(session, question, control, problems);
  } else if (question.cusps_over) {
    const Leg& leg = robot.leg(question.cusps_over->leg);
    result.found = CuspsOverJoint{
        leg.actuated_joint, leg.actuated_by_angle() ? "rad" : "m",
        find_cusp_curves(robot, *question.cusps_over, control.begin("Following curves of cusps."))};
  } else {
    result.found = of_map(session, question, control, problems);
  }
  return outcome_of(std::move(problems), control, std::move(result));
}

}  // namespace parallel_aspects::ask
