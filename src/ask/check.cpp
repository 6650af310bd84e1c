// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/check.h"

#include "model/message_text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace parallel_aspects::ask {
namespace {

void need_of_path(const CheckQuestion& question, ProblemList& problems) {
  if (question.start_pose || question.start_sign)
    problems.push_back({ProblemKind::together, "start_pose",
                        "{start_pose} and {start_sign} are of {trajectory}; leave them out.", ""});
  else if (question.policy)
    problems.push_back({ProblemKind::together, "policy",
                        "{policy} is of {trajectory}, since poses end at B_jj = 0; leave it out.", ""});
  else if (!question.mode)
    problems.push_back({ProblemKind::missing, "mode", "{path} needs the working mode of the poses",
                        "give {mode}, one of those that `choose` finds for it"});
}

void need_of_trajectory(const CheckQuestion& question, ProblemList& problems) {
  if (question.mode)
    problems.push_back(
        {ProblemKind::together, "mode",
         "{mode} is of {path}; the start of the actuated joints determines theirs; leave it out.", ""});
  else if (question.start_pose && question.start_sign)
    problems.push_back({ProblemKind::together, "start_pose",
                        "{start_pose} and {start_sign} both state the start", "give one of the two"});
}

void need(const CheckQuestion& question, ProblemList& problems) {
  if (!question.path && !question.trajectory)
    problems.push_back({ProblemKind::missing, "path", "{path} or {trajectory} is required",
                        "give the one, for poses, or the other, for actuated joints"});
  else if (question.path && question.trajectory)
    problems.push_back({ProblemKind::together, "path",
                        "Give one of {path}, for poses, and {trajectory}, for actuated joints.", ""});
  else
    question.path ? need_of_path(question, problems) : need_of_trajectory(question, problems);
}

/// The fields that state one of the starts each.
Problem refusal(const Manipulator& robot, const TrajectoryCheck& check) {
  constexpr std::size_t most = 8;
  const std::vector<PossibleStart>& starts = check.possible_starts;
  std::string text = given(check.reason);
  for (std::size_t i = 0; i < std::min(most, starts.size()); ++i) {
    const int sign = telling_sign(starts, i);
    text += (i == 0 ? " Give {start_pose} \"" : ", or {start_pose} \"") +
            pose_numbers(robot.task_space(), starts[i].pose) + "\"";
    if (sign != 0) text += std::string(" (the same as {start_sign ") + (sign > 0 ? "+" : "-") + "})";
  }
  if (starts.size() > most) text += ", or one of " + std::to_string(starts.size() - most) + " more";
  return {ProblemKind::value, "start_pose", text + (starts.empty() ? "" : "."), ""};
}

TrajectoryStart start_of(const CheckQuestion& question) {
  return {question.start_pose, value_of(question.start_sign)};
}

/// With the problems of its waypoints.
TrajectoryCheck checked(const Session& session, const CheckQuestion& question, const Control& control,
                        ProblemList& problems) {
  const TrajectoryStart start = start_of(question);
  add_told(question.path ? problems_of(*session.robot(), *question.path, *question.mode)
                         : problems_of(*session.robot(), *question.trajectory, start),
           problems);
  if (!problems.empty()) return {};
  TrajectoryCheckOptions options;
  options.pass_serial = question.policy == CheckPolicy::serial;
  options.keep_samples = question.keep_samples || question.distances;
  options.control = control.begin("Following the trajectory.");
  return question.path ? check_trajectory(*session.certifier(), *question.path, *question.mode, options)
                       : check_trajectory(*session.certifier(), *question.trajectory, start, options);
}

}  // namespace

bool is_whole(const CheckQuestion& question) {
  ProblemList problems;
  need(question, problems);
  return problems.empty();
}

std::optional<NamedValues> CheckAnswer::least_distance() const {
  if (distances.empty()) return std::nullopt;
  const std::array<double, 3> least = least_distances(check, distances);
  return NamedValues{
      {"parallel_distance", least[0]}, {"serial_distance", least[1]}, {"limit_distance", least[2]}};
}

Outcome<CheckAnswer> answer(Session& session, const CheckQuestion& question, const Control& control) {
  const Manipulator& robot = *session.robot();
  CheckAnswer answer;
  ProblemList problems;
  need(question, problems);
  if (problems.empty()) answer.check = checked(session, question, control, problems);
  if (answer.check.refused && !control.is_over()) problems.push_back(refusal(robot, answer.check));
  if (!problems.empty() || control.is_over()) return outcome_of(std::move(problems), control, CheckAnswer{});
  answer.task_space = robot.task_space();
  answer.from = question.path ? question.path->front().time : question.trajectory->front().time;
  for (std::size_t j = 0; j < answer.check.speeds.size(); ++j)
    answer.speeds.push_back(
        {robot.leg(j).actuated_joint, answer.check.speeds[j], robot.leg(j).limits.velocity});
  if (question.distances)
    answer.distances = distances_on(session.robot(), answer.check, question.distances->value);
  return outcome_of({}, control, std::move(answer));
}

}  // namespace parallel_aspects::ask
