// SPDX-License-Identifier: BSD-3-Clause
#include "ask/cusp_path.h"

#include "ask/question_parts.h"
#include "aspects/tree/held_joint_example.h"
#include "model/message_text.h"
#include "motion/choose/plan_around_cusp.h"
#include "parallel_aspects/aspects/uniqueness.h"

#include <utility>

namespace parallel_aspects::ask {
namespace {

Problem wrong(ProblemKind kind, std::string fault, std::string remedy) {
  return {kind, "around_cusp", "{around_cusp} " + std::move(fault), std::move(remedy)};
}

/// Cusps are points in slices of SE2 alone, of one robot.
void check_slice(const Manipulator& robot, const std::optional<MapSlice>& slice, ProblemList& problems) {
  if (robot.task_space() != TaskSpace::SE2)
    return problems.push_back(wrong(ProblemKind::robot,
                                    "is of robots that move in SE2, and '" + given(robot.name()) +
                                        "' moves in " + std::string(name(robot.task_space())),
                                    "leave it out"));
  const std::string example = given(example_of_held_joint(robot));
  if (example.empty())
    return problems.push_back(
        wrong(ProblemKind::robot,
              "needs an actuated joint that can be held, and '" + given(robot.name()) + "' has none",
              "leave it out"));
  if (!slice || !slice->joint)
    return problems.push_back(wrong(ProblemKind::together,
                                    "needs a slice that holds an actuated joint, where cusps are points",
                                    "give {hold} with its value at the start, such as " + example));
  UniquenessOptions options;
  options.slice = slice;
  if (const std::string why = find_uniqueness_problem(robot, options); !why.empty())
    problems.push_back(told(why));
}

/// "; there are 6: 1 at 14.98 15.4 17.9; 2 at ...".
std::string list_of(const Manipulator& robot, const CuspList& list) {
  std::string text = "there are " + std::to_string(list.cusps.size());
  for (std::size_t k = 0; k < list.cusps.size(); ++k) {
    text += (k == 0 ? ": " : "; ") + std::to_string(k + 1) + " at";
    for (std::size_t j = 0; j < robot.leg_count(); ++j)
      text += " " + number_text(list.cusps[k].actuated[static_cast<Eigen::Index>(j)]);
  }
  return text;
}

}  // namespace

void check_cusp(const Manipulator& robot, const PlanQuestion& question, const std::optional<MapSlice>& slice,
                ProblemList& problems) {
  check_slice(robot, slice, problems);
  const EndQuestion& goal = question.goal;
  if (goal.pose || goal.mode || goal.joints || goal.aspect || goal.tracked)
    problems.push_back(wrong(ProblemKind::together, "ends at the actuated values of the start",
                             "leave out what says where the path ends"));
  const bool has_wish =
      question.prefer != PathPreference::quick && question.prefer != PathPreference::shortest;
  if (question.policy != PathPolicy::stay || has_wish)
    problems.push_back(wrong(ProblemKind::together, "stays in one aspect, on a clear path",
                             "leave out {policy} and {prefer}"));
}

void plan_around(Session& session, const PlanQuestion& question, PathEnd from, const Control& control,
                 PlanAnswer& answer, ProblemList& problems) {
  const Manipulator& robot = *session.robot();
  CuspList cusps = find_cusps(robot, *answer.slice->joint, control.begin("Looking for cusps."));
  const std::size_t cusp = question.around_cusp->value - 1;
  if (control.is_over()) return;
  if (cusp >= cusps.cusps.size())
    problems.push_back(wrong(ProblemKind::value,
                             "is " + std::to_string(cusp + 1) + ", but with " + to_string(*answer.slice) +
                                 " " + list_of(robot, cusps),
                             "give the number of one of these"));
  const FoundMap found = problems.empty() ? session.map(question.map, {}, control, problems) : FoundMap{};
  if (!found.map) return;
  place_in_aspect("start", *found.map, question.start, from, problems);
  if (!problems.empty()) return;
  const MapControl looking = control.begin("Looking for a path around the cusp.");
  const auto planner = std::make_shared<CuspPlanner>(found.map, std::move(cusps.cusps));
  answer.map = found.map;
  answer.loaded = found.loaded;
  answer.path = planner->plan(from, cusp, looking);
  answer.between = [planner](const Pose& a, const Pose& b, double t) { return planner->between(a, b, t); };
  answer.turns_around_cusps = planner->turns_around_cusps(answer.path);
  if (answer.path)
    answer.encoder_noise = planner->followed_noise(answer.path);
  else
    answer.other_start = planner->find_start(cusp, looking);
}

}  // namespace parallel_aspects::ask
