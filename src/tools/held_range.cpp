// SPDX-License-Identifier: BSD-3-Clause
#include "tools/held_range.h"

#include "aspects/tree/held_joint_example.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "tools/numbers.h"

#include <optional>
#include <vector>

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

/// The range after "=" in `text`; a problem where there is none.
void read_range(const std::string& option, const Manipulator& robot, const std::string& text,
                HeldRange& range, Problems& problems) {
  const std::vector<std::string> ends = split_at(':', text.substr(text.find('=') + 1));
  if (ends.size() != 2 || ends[0].empty() || ends[1].empty() || words_of_list(text).size() != 1) {
    problems.push_back(option + " has '" + text + "'; give the ends of a range, such as " +
                       example_of_held_range(robot, range.leg) + ".");
    return;
  }
  const auto values = parse_numbers(option, ends[0] + " " + ends[1], {"lower", "upper"}, problems);
  range.lower = values[0];
  range.upper = values[1];
}

/// The joint that is held, and where; nothing, with a problem, where `text` is no actuated joint with a
/// value.
std::optional<HeldJoint> read_held_joint(const std::string& option, const Manipulator& robot,
                                         const std::string& text, Problems& problems) {
  const std::vector<std::string> words = words_of_list(text);
  const std::string word = words.empty() ? "" : words.front();
  const std::size_t equals = word.find('=');
  const std::string joint = word.substr(0, equals);
  if (equals == std::string::npos || words.size() != 1) {
    const auto named = leg_of_joint(robot, joint);
    const std::string example = named ? example_of_held_joint(robot, *named) : "";
    problems.push_back(option + " has '" + text + "'; give one actuated joint with its value, such as " +
                       (example.empty() ? example_of_held_joint(robot) : example) + ".");
    return std::nullopt;
  }
  const auto leg = leg_of(option, robot, joint, problems);
  if (!leg) return std::nullopt;
  const std::size_t known = problems.size();
  const auto value = parse_numbers(option, word.substr(equals + 1), {joint}, problems);
  if (problems.size() > known) return std::nullopt;
  return HeldJoint{*leg, value.front(), robot.leg(*leg).actuated_by_angle()};
}

}  // namespace

HeldRange parse_held_range(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems) {
  HeldRange range;
  if (robot.task_space() != TaskSpace::SE2) {
    problems.push_back(find_held_range_problem(robot, range));
    return range;
  }
  const std::string joint = text.substr(0, text.find('='));
  const auto leg = leg_of(option, robot, joint, problems);
  if (!leg) return range;
  range.leg = *leg;
  const JointLimits& limits = robot.leg(range.leg).limits;
  range.lower = limits.lower;
  range.upper = limits.upper;
  const std::size_t known = problems.size();
  if (joint != text) read_range(option, robot, text, range, problems);
  const std::string problem = problems.size() > known ? "" : find_held_range_problem(robot, range);
  if (!problem.empty()) problems.push_back(problem);
  return range;
}

HeldJoint parse_held_joint(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems) {
  const auto held = read_held_joint(option, robot, text, problems);
  if (!held) return {};
  const std::string problem = find_cusps_problem(robot, *held);
  if (!problem.empty()) problems.push_back(problem);
  return *held;
}

MapSlice parse_joint_slice(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems) {
  const auto held = read_held_joint(option, robot, text, problems);
  return held ? make_slice(robot, {{robot.leg(held->leg).actuated_joint, held->value}}, problems)
              : MapSlice{};
}

}  // namespace parallel_aspects::tools
