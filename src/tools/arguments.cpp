// SPDX-License-Identifier: BSD-3-Clause
#include "tools/arguments.h"

#include "ask/question_parts.h"
#include "aspects/tree/held_joint_example.h"
#include "aspects/tree/rotation_slice.h"
#include "model/message_text.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "tools/numbers.h"
#include "tools/subcommands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace parallel_aspects::tools {

Pose parse_pose(const std::string& option, const Motions& motions, const std::string& text,
                Problems& problems) {
  const std::size_t known = problems.size();
  const std::vector<double> numbers = parse_numbers(option, text, coordinate_names(motions.space), problems);
  if (problems.size() > known) return {};
  const auto pose = pose_from_coordinates(
      motions, Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size())));
  if (!pose) problems.push_back(option + " has a quaternion of zero length; give a unit quaternion.");
  return pose.value_or(Pose{});
}

namespace {

/// The signs in the text; nothing where there is anything else of meaning in it.
std::optional<std::vector<int>> parse_signs(const std::string& text) {
  std::vector<int> signs;
  for (const char character : text) {
    if (character == '+' || character == '-')
      signs.push_back(character == '+' ? 1 : -1);
    else if (std::string(" ,()").find(character) == std::string::npos)
      return std::nullopt;
  }
  return signs;
}

/// A joint or coordinate with a value: that which has this name, or one that the robot has.
std::string example_of_held(const Manipulator& manipulator, const std::string& name) {
  const TaskSpace space = manipulator.task_space();
  const std::optional<std::size_t> leg = leg_of_joint(manipulator, name);
  const std::string of_joint = leg && space == TaskSpace::SE2 ? example_of_held_joint(manipulator, *leg) : "";
  if (!of_joint.empty()) return of_joint;
  const std::vector<std::string> names = space == TaskSpace::SO3 || space == TaskSpace::SE3
                                             ? std::vector<std::string>{"roll", "pitch", "yaw"}
                                             : coordinate_names(space);
  const bool is_one = std::find(names.begin(), names.end(), name) != names.end() ||
                      (space == TaskSpace::SE3 && (name == "x" || name == "y" || name == "z"));
  return "\"" + (is_one ? name : names.back()) + "=0.5\"";
}

}  // namespace

std::vector<WorkingMode> parse_modes(const std::string& option, const Manipulator& manipulator,
                                     const std::string& text, Problems& problems) {
  if (text.empty()) return {};
  const auto signs = parse_signs(text);
  const std::size_t legs = manipulator.leg_count();
  if (!signs || signs->empty() || signs->size() % legs != 0) {
    const WorkingMode example = WorkingMode::from_index(legs, 1);
    problems.push_back(option + " is '" + text + "'; give the signs of B_jj of each leg, such as \"" +
                       to_string(example) + "\", for each working mode.");
    return {};
  }
  std::vector<WorkingMode> modes;
  for (auto first = signs->begin(); first != signs->end(); first += static_cast<std::ptrdiff_t>(legs))
    modes.push_back(*WorkingMode::from_signs({first, first + static_cast<std::ptrdiff_t>(legs)}));
  return modes;
}

MapSlice parse_slice(const std::string& option, const Manipulator& manipulator, const std::string& text,
                     Problems& problems) {
  std::vector<HeldCoordinate> held;
  std::string axis;
  const std::size_t known = problems.size();
  for (const std::string& word : words_of_list(text)) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    if (equals == std::string::npos) {
      problems.push_back(option + " has '" + word + "'; give what is held with its value, such as " +
                         example_of_held(manipulator, name) + ".");
      continue;
    }
    if (name == "turn" && axis.empty()) {
      axis = word.substr(equals + 1);
      continue;
    }
    const auto value = parse_numbers(option, word.substr(equals + 1), {name}, problems);
    held.push_back({name, value.empty() ? 0.0 : value.front()});
  }
  if (problems.size() > known) return {};
  return axis.empty() ? make_slice(manipulator, held, problems)
                      : make_rotation_slice(manipulator.task_space(), held, axis, problems);
}

namespace {

// With the platform as the task frame is turned, where the robot comes there; it assembles at the pose
// itself.
Pose plain(const Manipulator& manipulator, const Pose& pose) {
  Pose upright = pose;
  upright.orientation.setIdentity();
  const auto solutions = inverse_in_all_modes(manipulator, upright);
  const bool is_reached = std::any_of(solutions.begin(), solutions.end(),
                                      [](const InverseSolution& each) { return static_cast<bool>(each); });
  return is_reached ? upright : pose;
}

// In few digits.
std::string held_text(const std::string& name, double value) {
  constexpr int digits = 2;
  constexpr double noise = 1e-9;
  return name + "=" + number_text(std::abs(value) < noise ? 0.0 : value, digits);
}

std::string text_of_section(TaskSpace space, const Pose& pose) {
  if (space == TaskSpace::SO3) return "torsion=0";
  return space == TaskSpace::SE2 ? held_text("phi", pose_coordinates(space, pose)[2])
                                 : held_text("z", pose.position.z());
}

// As in `make_slice`, Rz(yaw) Ry(pitch) Rx(roll).
std::string text_of_orientation(const Eigen::Quaterniond& orientation) {
  const Eigen::Matrix3d r = orientation.normalized().toRotationMatrix();
  return held_text("roll", std::atan2(r(2, 1), r(2, 2))) + " " +
         held_text("pitch", std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)))) + " " +
         held_text("yaw", std::atan2(r(1, 0), r(0, 0)));
}

}  // namespace

std::string example_of_section(const Manipulator& manipulator, const Pose& pose) {
  return "\"" + text_of_section(manipulator.task_space(), plain(manipulator, pose)) + "\"";
}

std::string example_of_plane(const Manipulator& manipulator, const Pose& pose) {
  const TaskSpace space = manipulator.task_space();
  if (space == TaskSpace::SO3) return "";
  const Pose held = plain(manipulator, pose);
  const std::string turns = space == TaskSpace::SE3 ? " " + text_of_orientation(held.orientation) : "";
  return "\"" + text_of_section(space, held) + turns + "\"";
}

std::optional<WorkingMode> parse_mode(const std::string& option, const Manipulator& manipulator,
                                      const std::string& text, Problems& problems) {
  const auto signs = parse_signs(text);
  if (signs && signs->size() == manipulator.leg_count()) return WorkingMode::from_signs(*signs);
  const WorkingMode example = WorkingMode::from_index(manipulator.leg_count(), 1);
  problems.push_back(option + " is '" + text + "'; give the sign of B_jj of each leg, such as \"" +
                     to_string(example) + "\".");
  return std::nullopt;
}

namespace {

/// The name and the numbers behind it, with colons between them; nothing, with a message, for another text.
std::optional<std::pair<std::string, std::vector<double>>> named_numbers(const std::string& option,
                                                                         const std::string& word,
                                                                         std::size_t count,
                                                                         const std::string& example,
                                                                         Problems& problems) {
  const std::size_t equals = word.find('=');
  const auto parts = split_at(':', equals == std::string::npos ? "" : word.substr(equals + 1));
  if (equals == std::string::npos || equals == 0 || parts.size() != count) {
    problems.push_back(option + " has '" + word + "'; give " + example + ".");
    return std::nullopt;
  }
  const std::size_t known = problems.size();
  std::vector<double> numbers;
  for (const std::string& part : parts)
    for (const double number : parse_numbers(option, part, {word.substr(0, equals)}, problems))
      numbers.push_back(number);
  if (problems.size() > known) {  // told already; what follows says no more of it
    numbers.resize(count);
    std::iota(numbers.begin(), numbers.end(), 0.0);
  }
  return std::pair{word.substr(0, equals), std::move(numbers)};
}

}  // namespace

std::vector<double> parse_ratio(const std::string& option, std::string text, Problems& problems) {
  std::replace(text.begin(), text.end(), ':', ' ');
  std::vector<double> numbers;
  for (const std::string& word : split_words(text))
    for (const double number : parse_numbers(option, word, {"number"}, problems)) numbers.push_back(number);
  return numbers;
}

std::vector<HeldCoordinate> parse_values(const std::string& option, const std::string& text,
                                         Problems& problems, const std::string& example) {
  std::vector<HeldCoordinate> values;
  for (const std::string& word : words_of_list(text))
    if (auto found = named_numbers(option, word, 1, "names with their values, such as " + example, problems))
      values.push_back({std::move(found->first), found->second[0]});
  return values;
}

std::vector<ask::NamedRange> parse_ranges(const std::string& option, const std::string& text,
                                          Problems& problems, const std::string& example) {
  std::vector<ask::NamedRange> ranges;
  for (const std::string& word : words_of_list(text))
    if (auto found = named_numbers(option, word, 2, example, problems))
      ranges.push_back({std::move(found->first), found->second[0], found->second[1]});
  return ranges;
}

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
  if (joint != text) read_range(option, robot, text, range, problems);
  return range;
}

HeldJoint parse_held_joint(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems) {
  const std::vector<std::string> words = words_of_list(text);
  const std::string word = words.empty() ? "" : words.front();
  const std::size_t equals = word.find('=');
  const std::string joint = word.substr(0, equals);
  if (equals == std::string::npos || words.size() != 1) {
    const auto named = leg_of_joint(robot, joint);
    const std::string example = named ? example_of_held_joint(robot, *named) : "";
    problems.push_back(option + " has '" + text + "'; give one actuated joint with its value, such as " +
                       (example.empty() ? example_of_held_joint(robot) : example) + ".");
    return {};
  }
  const auto leg = leg_of(option, robot, joint, problems);
  if (!leg) return {};
  const std::size_t known = problems.size();
  const auto value = parse_numbers(option, word.substr(equals + 1), {joint}, problems);
  if (problems.size() > known) return {};
  return {*leg, value.front(), robot.leg(*leg).actuated_by_angle()};
}

}  // namespace parallel_aspects::tools
