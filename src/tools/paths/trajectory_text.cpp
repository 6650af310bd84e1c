// SPDX-License-Identifier: BSD-3-Clause
#include "tools/paths/trajectory_text.h"

#include "model/message_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace parallel_aspects::tools {
namespace {

using Waypoints = std::vector<JointWaypoint>;

std::string exact(double value) { return number_text(value, exact_digits); }

std::string joined(const JointVector& values, const char* between) {
  std::string text;
  for (Eigen::Index j = 0; j < values.size(); ++j) text += (j == 0 ? "" : between) + exact(values[j]);
  return text;
}

bool have_velocities(const Waypoints& waypoints) {
  return std::all_of(waypoints.begin(), waypoints.end(),
                     [](const JointWaypoint& waypoint) { return waypoint.velocity.size() > 0; });
}

std::string yaml_of(const JointWaypoint& waypoint) {
  constexpr std::int64_t second = 1'000'000'000;
  const auto nanoseconds = static_cast<std::int64_t>(std::llround(waypoint.time * 1e9));
  return "  - positions: [" + joined(waypoint.q, ", ") + "]\n    velocities: [" +
         joined(waypoint.velocity, ", ") +
         "]\n    accelerations: []\n    effort: []\n    time_from_start:\n      secs: " +
         std::to_string(nanoseconds / second) + "\n      nsecs: " + std::to_string(nanoseconds % second) +
         "\n";
}

}  // namespace

std::string trajectory_csv(const Manipulator& manipulator, const Waypoints& waypoints) {
  const bool with_velocities = have_velocities(waypoints);
  std::string text = "time";
  for (const Leg& leg : manipulator.legs()) text += "," + leg.actuated_joint;
  if (with_velocities)
    for (const Leg& leg : manipulator.legs()) text += "," + leg.actuated_joint + "/velocity";
  text += '\n';
  for (const JointWaypoint& waypoint : waypoints) {
    text += exact(waypoint.time) + "," + joined(waypoint.q, ",");
    text += (with_velocities ? "," + joined(waypoint.velocity, ",") : "") + "\n";
  }
  return text;
}

std::string trajectory_yaml(const Manipulator& manipulator, const Waypoints& waypoints) {
  std::string text = "header:\n  seq: 0\n  stamp:\n    secs: 0\n    nsecs: 0\n  frame_id: ''\njoint_names:\n";
  for (const Leg& leg : manipulator.legs()) text += "  - " + leg.actuated_joint + "\n";
  text += "points:\n";
  for (const JointWaypoint& waypoint : waypoints) text += yaml_of(waypoint);
  return text;
}

}  // namespace parallel_aspects::tools
