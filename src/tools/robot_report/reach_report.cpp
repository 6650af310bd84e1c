// SPDX-License-Identifier: BSD-3-Clause
#include "tools/robot_report/reach_report.h"

#include "model/angles.h"
#include "model/message_text.h"
#include "tools/report/report.h"

#include <string>

namespace parallel_aspects::tools {

std::string home_text(const ask::RobotDescription& description) {
  const TaskSpace space = description.mechanism->manipulator()->task_space();
  const AssembledConfiguration& home = description.home;
  std::string named;
  const PoseCoordinates coordinates = pose_coordinates(space, home.pose).unaryExpr(&without_noise);
  for (Eigen::Index k = 0; k < coordinates.size(); ++k)
    named += (k == 0 ? "" : ", ") + coordinate_names(space)[static_cast<std::size_t>(k)] + ' ' +
             shown(coordinates[k]);
  const TaskVector q = home.q.unaryExpr(&without_noise);
  return "home pose: " + named + " (--pose \"" + pose_numbers(space, home.pose, description.home_digits) +
         "\"), at the joint values " + shown(q) + "\n";
}

namespace {

std::string range_text(const std::string& name, double lower, double upper) {
  return name + " from " + shown_briefly(lower) + " to " + shown_briefly(upper);
}

std::string positions_text(TaskSpace space, const ask::RobotReach& reach) {
  std::string text;
  for (std::size_t i = 0; i < reach.lower.size(); ++i)
    text += (text.empty() ? "" : ", ") +
            range_text(reach.lower[i].first, reach.lower[i].second, reach.upper[i].second);
  return text + " m, about" + (has_rotation(space) ? ", over all orientations" : "");
}

// Positions first, as people write poses.
std::string alone_text(TaskSpace space, const ask::RobotReach& reach) {
  const auto turns = static_cast<std::size_t>(rotational_degrees_of_freedom(space));
  std::string lengths, angles;
  for (std::size_t k = 0; k < reach.alone.size(); ++k) {
    const auto& [coordinate, range] = reach.alone[k];
    std::string& text = k < turns ? angles : lengths;
    const double unit = k < turns ? 180.0 / pi : 1.0;
    text += (text.empty() ? "" : ", ") + range_text(coordinate, unit * range.lower, unit * range.upper);
  }
  return "one coordinate alone, from " +
         (reach.is_from_home ? "the home pose" : to_string(space, *reach.from)) + ": " +
         (lengths.empty() ? "" : lengths + " m, ") + angles + " degrees, about\n";
}

}  // namespace

std::string reach_text(const ask::RobotDescription& description) {
  if (!description.reach)
    return "workspace: not bounded by the legs; limit the actuated joints, or give a workspace or a region\n";
  const ask::RobotReach& reach = *description.reach;
  const TaskSpace space = description.mechanism->manipulator()->task_space();
  const std::string share = "the legs reach " + std::to_string(reach.reached) + " of " +
                            std::to_string(reach.drawn) + " random poses";
  if (!reach.from) return "workspace: " + share + "\n";
  const std::string alone = has_rotation(space) ? alone_text(space, reach) : "";
  if (!has_translation(space)) return "workspace: " + share + "\n" + alone;
  return "workspace: " + positions_text(space, reach) + "; " + share + " where a flood from " +
         (reach.is_from_home ? "the home pose" : "one of them") + " has been\n" + alone;
}

}  // namespace parallel_aspects::tools
