// SPDX-License-Identifier: BSD-3-Clause
#include "tools/paths/path_ends.h"

#include "parallel_aspects/kinematics/direct.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/jacobians.h"
#include "tools/arguments.h"
#include "tools/command_line.h"
#include "tools/numbers.h"
#include "tools/report/report.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace parallel_aspects::tools {
namespace {

constexpr double largest_number = 1e12;  // [m or rad], as elsewhere: beyond it proofs do not reach

double distance(const Manipulator& manipulator, const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() +
         manipulator.characteristic_length() * a.orientation.angularDistance(b.orientation);
}

std::string listed(const Manipulator& manipulator, const JointVector& q,
                   const std::vector<AssemblyMode>& solutions) {
  std::string text;
  for (const AssemblyMode& each : solutions) {
    const auto mode = working_mode(manipulator, each.pose, q);
    text += (text.empty() ? "" : ", ") + to_string(manipulator.task_space(), each.pose) +
            (mode ? " in " + to_string(*mode) : "");
  }
  return text;
}

/// Of the assembly modes that belong to a working mode, and to the one that is asked for.
std::vector<AssemblyMode> candidates(const Manipulator& manipulator, const JointVector& q,
                                     const std::optional<WorkingMode>& wanted) {
  std::vector<AssemblyMode> result;
  for (const AssemblyMode& each : direct(manipulator, q).solutions) {
    const auto mode = each.serially_singular ? std::nullopt : working_mode(manipulator, each.pose, q);
    if (mode && (!wanted || *mode == *wanted)) result.push_back(each);
  }
  return result;
}

/// The end at this pose. Angles without limits keep the turn that they are given in; of one with limits there
/// is one turn in which the pose is reached.
PathEnd in_turn(const std::string& option, const Manipulator& manipulator, const JointVector& q,
                const Pose& pose, Problems& problems) {
  const std::optional<WorkingMode> mode = working_mode(manipulator, pose, q);
  const JointVector reached = inverse(manipulator, pose, mode.value()).q;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    const auto k = static_cast<Eigen::Index>(j);
    if (leg.actuated_by_angle() && leg.limits.limited() && std::abs(q[k] - reached[k]) > EIGEN_PI)
      problems.push_back(option + "-joints has " + shown(q[k]) + " for '" + leg.actuated_joint +
                         "', whose limits are " + shown(leg.limits.lower) + " to " + shown(leg.limits.upper) +
                         " rad; give " + shown(reached[k]) + ", where the leg is the same.");
  }
  return {pose, mode, q};
}

/// `near` is a pose that says which of several is meant.
PathEnd assembled(const std::string& option, const Manipulator& manipulator, const JointVector& q,
                  const PathEnd& end, bool near, Problems& problems) {
  std::vector<AssemblyMode> found = candidates(manipulator, q, end.mode);
  if (near)
    std::sort(found.begin(), found.end(), [&](const AssemblyMode& a, const AssemblyMode& b) {
      return distance(manipulator, a.pose, end.pose) < distance(manipulator, b.pose, end.pose);
    });
  if (found.empty())
    problems.push_back(option + "-joints assemble in no pose" +
                       (end.mode ? " in the working mode " + to_string(*end.mode) : "") +
                       "; `aspects fk` tells where values do.");
  else if (found.size() > 1 && !near)
    problems.push_back(option + "-joints assemble in several poses: " + listed(manipulator, q, found) +
                       "; say with " + option + " which one is meant.");
  else
    return in_turn(option, manipulator, q, found.front().pose, problems);
  return end;
}

void refuse_beyond(const std::string& option, double value, Problems& problems) {
  if (std::abs(value) > largest_number)
    problems.push_back(option + " has " + shown(value) + ", but numbers reach to " + shown(largest_number) +
                       " m or rad; give a smaller one.");
}

std::vector<std::string> actuated_joints(const Manipulator& manipulator) {
  std::vector<std::string> names;
  for (const Leg& leg : manipulator.legs()) names.push_back(leg.actuated_joint);
  return names;
}

}  // namespace

std::vector<Option> path_end_options(const std::string& option, PathEndArguments& arguments) {
  const bool start = option == "--from";
  return {
      {option, "\"x y\"",
       start ? "Where the path begins: a pose, quoted; lengths [m]" : "Where it ends, likewise",
       &arguments.pose},
      {option + "-mode", "\"(+,-)\"", "Working mode there, as signs of B_jj; by default any",
       &arguments.mode},
      {option + "-joints", "\"q1 q2\"",
       "In place of a pose: values of the actuated joints, in the order of the legs [rad or m]; of several "
       "assembly modes the one next to " +
           option,
       &arguments.joints},
      {option + "-aspect", "ID", "In place of a pose: the deepest one of this aspect of the map",
       &arguments.aspect}};
}

PathEnd parse_path_end(const std::string& option, const Manipulator& manipulator,
                       const PathEndArguments& arguments, Problems& problems) {
  const std::size_t known = problems.size();
  PathEnd end;
  if (!arguments.aspect.empty()) {
    if (!arguments.pose.empty() || !arguments.mode.empty() || !arguments.joints.empty())
      problems.push_back(option + "-aspect tells pose and working mode; leave out what else says where " +
                         (option == "--from" ? "the path begins." : "it ends."));
    return end;
  }
  if (arguments.pose.empty() && arguments.joints.empty())
    throw UsageError(option + " is required; give a pose, or " + option + "-joints, or " + option +
                     "-aspect");
  if (!arguments.mode.empty()) end.mode = parse_mode(option + "-mode", manipulator, arguments.mode, problems);
  if (!arguments.pose.empty())
    end.pose = parse_pose(option, manipulator.task_space(), arguments.pose, problems);
  std::vector<double> q;
  if (!arguments.joints.empty())
    q = parse_numbers(option + "-joints", arguments.joints, actuated_joints(manipulator), problems);
  for (const double value : q) refuse_beyond(option + "-joints", value, problems);
  for (int i = 0; i < 3; ++i) refuse_beyond(option, end.pose.position[i], problems);
  if (problems.size() > known || q.empty()) return end;
  return assembled(option, manipulator,
                   Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size())), end,
                   !arguments.pose.empty(), problems);
}

void place_in_aspect(const std::string& option, const AspectMap& map, const PathEndArguments& arguments,
                     PathEnd& end, Problems& problems) {
  if (arguments.aspect.empty()) return;
  char* rest = nullptr;
  const long id = std::strtol(arguments.aspect.c_str(), &rest, 10);
  if (*rest != '\0' || id < 1 || id > static_cast<long>(map.aspects().size())) {
    problems.push_back(option + "-aspect is '" + arguments.aspect + "'; the map has the aspects 1 to " +
                       std::to_string(map.aspects().size()) + ".");
    return;
  }
  const Aspect& aspect = map.aspects()[static_cast<std::size_t>(id - 1)];
  end = {aspect.deepest, aspect.mode};
}

}  // namespace parallel_aspects::tools
