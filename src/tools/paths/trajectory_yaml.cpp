// SPDX-License-Identifier: BSD-3-Clause
#include "tools/paths/trajectory_yaml.h"

#include "parallel_aspects/ask/check.h"
#include "urdf/description/yaml_values.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstddef>

namespace parallel_aspects::tools {
namespace {

/// The one message of a text; messages end with a line of three dashes.
YAML::Node only_message(const std::string& file, const std::string& text, Problems& problems) {
  std::vector<YAML::Node> messages;
  for (const YAML::Node& message : YAML::LoadAll(text))
    if (!message.IsNull()) messages.push_back(message);
  if (messages.size() > 1)
    problems.push_back(file + " holds " + std::to_string(messages.size()) +
                       " messages, and each is a trajectory of its own; give a file with one.");
  return messages.empty() ? YAML::Node() : messages.front();
}

/// Reads one message.
class MessageReader {
 public:
  MessageReader(const Manipulator& manipulator, const std::string& file, Problems& problems)
      : manipulator_(manipulator), file_(file), values_(file, problems), problems_(problems) {}

  std::vector<JointWaypoint> read(const YAML::Node& message) {
    if (!message.IsMap() || !message["joint_names"].IsSequence() || !message["points"].IsSequence()) {
      values_.problem("is no trajectory_msgs/JointTrajectory; it needs joint_names and points.");
      return {};
    }
    values_.check_keys(message, {"header", "joint_names", "points"}, "the message");
    const ask::JointColumns columns(manipulator_, message["joint_names"].as<std::vector<std::string>>(),
                                    file_, problems_);
    std::vector<JointWaypoint> waypoints;
    if (!problems_.empty()) return waypoints;
    for (const YAML::Node& point : message["points"]) {
      waypoints.push_back(waypoint(columns, point, "points[" + std::to_string(waypoints.size()) + "]"));
      if (!problems_.empty()) break;  // what is wrong with one point mostly is with all
    }
    return waypoints;
  }

 private:
  JointWaypoint waypoint(const ask::JointColumns& columns, const YAML::Node& point,
                         const std::string& where) const {
    JointWaypoint result;
    // Of a key that is not understood, or that stands there twice, the robot would run another motion.
    values_.check_keys(point, {"positions", "velocities", "accelerations", "effort", "time_from_start"},
                       where);
    result.time = time(point["time_from_start"], where + ".time_from_start");
    result.q = vector(columns, point["positions"], where + ".positions");
    result.velocity = vector(columns, point["velocities"], where + ".velocities");
    result.acceleration = vector(columns, point["accelerations"], where + ".accelerations");
    return result;
  }

  double time(const YAML::Node& node, const std::string& where) const {
    if (!node.IsDefined() || !node.IsMap()) {
      values_.problem("has no " + where + " with secs and nsecs; give it.");
      return 0.0;
    }
    values_.check_keys(node, {"secs", "nsecs"}, where);
    double seconds = 0.0, nanoseconds = 0.0;
    if (values_.number(node["secs"], where + ".secs", seconds) && std::trunc(seconds) != seconds)
      values_.problem("has a " + where + ".secs that is not a whole number; write the rest as nsecs.");
    if (values_.number(node["nsecs"], where + ".nsecs", nanoseconds) &&
        !(nanoseconds >= 0.0 && nanoseconds < 1e9 && std::trunc(nanoseconds) == nanoseconds))
      values_.problem("has a " + where + ".nsecs that is not a whole number from 0 to 999999999; give one.");
    return seconds + 1e-9 * nanoseconds;
  }

  JointVector vector(const ask::JointColumns& columns, const YAML::Node& node,
                     const std::string& where) const {
    std::vector<double> numbers;
    values_.numbers(node, where, numbers);
    return columns.ordered(numbers, where, problems_);
  }

  const Manipulator& manipulator_;
  const std::string& file_;
  YamlValues values_;
  Problems& problems_;
};

}  // namespace

std::vector<JointWaypoint> waypoints_of_message(const Manipulator& manipulator, const std::string& file,
                                                const std::string& text, Problems& problems) {
  try {
    return MessageReader(manipulator, file, problems).read(only_message(file, text, problems));
  } catch (const YAML::Exception& error) {
    problems.push_back(file + " is not the YAML of a message: " + error.what() + ".");
    return {};
  }
}

}  // namespace parallel_aspects::tools
