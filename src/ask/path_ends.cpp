// SPDX-License-Identifier: BSD-3-Clause
#include "ask/path_ends.h"

#include "model/number_text.h"
#include "parallel_aspects/kinematics/direct.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/jacobians.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace parallel_aspects::ask {
namespace {

constexpr double largest_number = 1e12;  // [m or rad], as elsewhere: beyond it proofs do not reach

double distance(const Manipulator& robot, const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() +
         robot.characteristic_length() * a.orientation.angularDistance(b.orientation);
}

std::string listed(const Manipulator& robot, const JointVector& q,
                   const std::vector<AssemblyMode>& solutions) {
  std::string text;
  for (const AssemblyMode& each : solutions) {
    const auto mode = working_mode(robot, each.pose, q);
    text += (text.empty() ? "" : ", ") + to_string(robot.task_space(), each.pose) +
            (mode ? " in " + to_string(*mode) : "");
  }
  return text;
}

/// Of the assembly modes that belong to a working mode, and to the one that is asked for.
std::vector<AssemblyMode> candidates(const Manipulator& robot, const JointVector& q,
                                     const std::optional<WorkingMode>& wanted) {
  std::vector<AssemblyMode> result;
  for (const AssemblyMode& each : direct(robot, q).solutions) {
    const auto mode = each.serially_singular ? std::nullopt : working_mode(robot, each.pose, q);
    if (mode && (!wanted || *mode == *wanted)) result.push_back(each);
  }
  return result;
}

/// The end at this pose. Angles without limits keep the turn that they are given in; of one with limits there
/// is one turn in which the pose is reached.
PathEnd in_turn(const std::string& field, const Manipulator& robot, const JointVector& q, const Pose& pose,
                ProblemList& problems) {
  const std::optional<WorkingMode> mode = working_mode(robot, pose, q);
  const JointVector reached = inverse(robot, pose, mode.value()).q;
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const Leg& leg = robot.leg(j);
    const auto k = static_cast<Eigen::Index>(j);
    if (leg.actuated_by_angle() && leg.limits.limited() && std::abs(q[k] - reached[k]) > EIGEN_PI)
      problems.push_back({ProblemKind::value, field,
                          "{" + field + "} has " + number_text(q[k]) + " for '" + given(leg.actuated_joint) +
                              "', whose limits are " + number_text(leg.limits.lower) + " to " +
                              number_text(leg.limits.upper) + " rad",
                          "give " + number_text(reached[k]) + ", where the leg is the same"});
  }
  return {pose, mode, q};
}

/// Where the joints assemble: next to the pose, if one is given.
PathEnd assembled(const std::string& name, const Manipulator& robot, const EndQuestion& question,
                  ProblemList& problems) {
  const JointVector& q = *question.joints;
  const std::string field = name + "_joints";
  std::vector<AssemblyMode> found = candidates(robot, q, question.mode);
  if (question.pose)
    std::sort(found.begin(), found.end(), [&](const AssemblyMode& a, const AssemblyMode& b) {
      return distance(robot, a.pose, *question.pose) < distance(robot, b.pose, *question.pose);
    });
  if (found.empty())
    problems.push_back({ProblemKind::value, field,
                        "{" + field + "} assemble in no pose" +
                            (question.mode ? " in the working mode " + to_string(*question.mode) : ""),
                        "direct solutions tell where values do"});
  else if (found.size() > 1 && !question.pose)
    problems.push_back({ProblemKind::value, field,
                        "{" + field + "} assemble in several poses: " + listed(robot, q, found),
                        "say with {" + name + "} which one is meant"});
  else
    return in_turn(field, robot, q, found.front().pose, problems);
  return {};
}

void refuse_beyond(const std::string& field, double value, ProblemList& problems) {
  if (!(std::abs(value) <= largest_number))
    problems.push_back({ProblemKind::value, field,
                        "{" + field + "} has " + number_text(value) + ", but numbers reach to " +
                            number_text(largest_number) + " m or rad",
                        "give a smaller one"});
}

void refuse_beyond(const std::string& name, const EndQuestion& question, ProblemList& problems) {
  if (question.joints)
    for (Eigen::Index j = 0; j < question.joints->size(); ++j)
      refuse_beyond(name + "_joints", (*question.joints)[j], problems);
  if (question.pose)
    for (int i = 0; i < 3; ++i) refuse_beyond(name, question.pose->position[i], problems);
}

}  // namespace

PathEnd path_end(const std::string& field, const Manipulator& robot, const EndQuestion& question,
                 ProblemList& problems) {
  const std::size_t known = problems.size();
  if (question.tracked) return *question.tracked;
  if (question.aspect && (question.pose || question.mode || question.joints))
    problems.push_back({ProblemKind::together, field + "_aspect",
                        "{" + field + "_aspect} tells pose and working mode",
                        "leave out {" + field + "}, {" + field + "_mode} and {" + field + "_joints}"});
  if (question.aspect) return {};
  if (!question.pose && !question.joints)
    problems.push_back({ProblemKind::missing, field, "{" + field + "} is required",
                        "give a pose, or {" + field + "_joints}, or {" + field + "_aspect}"});
  refuse_beyond(field, question, problems);
  if (problems.size() > known) return {};
  if (question.joints) return assembled(field, robot, question, problems);
  return {*question.pose, question.mode, {}};
}

void place_in_aspect(const std::string& field, const AspectMap& map, const EndQuestion& question,
                     PathEnd& end, ProblemList& problems) {
  if (!question.aspect) return;
  const std::size_t count = map.aspects().size();
  const unsigned id = question.aspect->value;
  if (id > count) {
    const std::string name = field + "_aspect";
    problems.push_back(
        {ProblemKind::value, name, "{" + name + "} is " + std::to_string(id),
         count == 0 ? "the map has no aspect" : "the map has the aspects 1 to " + std::to_string(count)});
    return;
  }
  const Aspect& aspect = map.aspects()[id - 1];
  end = {aspect.deepest, aspect.mode, {}};
}

}  // namespace parallel_aspects::ask
