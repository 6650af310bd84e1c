// SPDX-License-Identifier: BSD-3-Clause
#include "tools/held_range.h"

#include "parallel_aspects/aspects/held_joint.h"
#include "tools/arguments.h"
#include "tools/numbers.h"

#include <optional>

namespace parallel_aspects::tools {

namespace {

/// The leg whose actuated joint has this name; else a problem.
std::optional<std::size_t> leg_of(const std::string& option, const Manipulator& robot,
                                  const std::string& joint, Problems& problems) {
  if (const auto leg = leg_of_joint(robot, joint)) return leg;
  std::string joints;
  for (const Leg& leg : robot.legs()) joints += (joints.empty() ? "" : ", ") + leg.actuated_joint;
  problems.push_back(option + " names '" + joint + "'; give one of the actuated joints: " + joints + ".");
  return std::nullopt;
}

}  // namespace

HeldRange parse_held_range(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems) {
  const std::string joint = text.substr(0, text.find('='));
  HeldRange range;
  const auto leg = leg_of(option, robot, joint, problems);
  if (!leg) return range;
  range.leg = *leg;
  const JointLimits& limits = robot.leg(range.leg).limits;
  range.lower = limits.lower;
  range.upper = limits.upper;
  const std::size_t known = problems.size();
  if (joint != text) {
    const Box box = parse_region(option, {joint}, text, problems);
    range.lower = box.lower[0];
    range.upper = box.upper[0];
  }
  const std::string problem = problems.size() > known ? "" : find_held_range_problem(robot, range);
  if (!problem.empty()) problems.push_back(problem);
  return range;
}

HeldJoint parse_held_joint(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || words_of_list(text).size() != 1) {
    problems.push_back(option + " has '" + text + "'; give one actuated joint with its value, such as \"" +
                       robot.leg(0).actuated_joint + "=0.3\".");
    return {};
  }
  const std::string joint = text.substr(0, equals);
  const auto leg = leg_of(option, robot, joint, problems);
  if (!leg) return {};
  HeldJoint held{*leg, 0.0, robot.leg(*leg).actuated_by_angle()};
  const auto value = parse_numbers(option, text.substr(equals + 1), {joint}, problems);
  if (value.empty()) return held;
  held.value = value.front();
  const std::string problem = find_cusps_problem(robot, held);
  if (!problem.empty()) problems.push_back(problem);
  return held;
}

}  // namespace parallel_aspects::tools
