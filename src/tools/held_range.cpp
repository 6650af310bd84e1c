// SPDX-License-Identifier: BSD-3-Clause
#include "tools/held_range.h"

#include "tools/arguments.h"

namespace parallel_aspects::tools {

HeldRange parse_held_range(const std::string& option, const Manipulator& robot, const std::string& text,
                           Problems& problems) {
  const std::string joint = text.substr(0, text.find('='));
  HeldRange range;
  std::string joints;
  while (range.leg < robot.leg_count() && robot.leg(range.leg).actuated_joint != joint)
    joints += (joints.empty() ? "" : ", ") + robot.leg(range.leg++).actuated_joint;
  if (range.leg == robot.leg_count()) {
    problems.push_back(option + " names '" + joint + "'; give one of the actuated joints: " + joints + ".");
    return range;
  }
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

}  // namespace parallel_aspects::tools
