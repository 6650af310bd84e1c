// SPDX-License-Identifier: BSD-3-Clause
#include "tools/paths/trajectory_yaml.h"

#include "urdf/description/nearest_name.h"
#include "urdf/description/yaml_values.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace parallel_aspects::tools {
namespace {

using Names = std::vector<std::string>;

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
      : manipulator_(manipulator), values_(file, problems), problems_(problems) {}

  std::vector<JointWaypoint> read(const YAML::Node& message) {
    if (!message.IsMap() || !message["joint_names"].IsSequence() || !message["points"].IsSequence()) {
      values_.problem("is no trajectory_msgs/JointTrajectory; it needs joint_names and points.");
      return {};
    }
    values_.check_keys(message, {"header", "joint_names", "points"}, "the message");
    for (const YAML::Node& name : message["joint_names"]) names_.push_back(name.as<std::string>());
    find_columns();
    std::vector<JointWaypoint> waypoints;
    if (!problems_.empty()) return waypoints;
    for (const YAML::Node& point : message["points"]) {
      waypoints.push_back(waypoint(point, "points[" + std::to_string(waypoints.size()) + "]"));
      if (!problems_.empty()) break;  // what is wrong with one point mostly is with all
    }
    return waypoints;
  }

 private:
  void find_columns() {
    std::vector<std::string> actuated;
    for (const Leg& leg : manipulator_.legs()) {
      actuated.push_back(leg.actuated_joint);
      const auto found = std::find(names_.begin(), names_.end(), leg.actuated_joint);
      columns_.push_back(static_cast<std::size_t>(found - names_.begin()));
      if (std::count(names_.begin(), names_.end(), leg.actuated_joint) != 1)
        values_.problem("does not have the joint '" + leg.actuated_joint +
                        "' once; name every actuated joint.");
    }
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (std::count(columns_.begin(), columns_.end(), i) == 0)
        values_.problem("has the unknown joint '" + names_[i] + "'" + suggestion(names_[i], actuated, {}));
  }

  JointWaypoint waypoint(const YAML::Node& point, const std::string& where) const {
    JointWaypoint result;
    // Of a key that is not understood, or that stands there twice, the robot would run another motion.
    values_.check_keys(point, {"positions", "velocities", "accelerations", "effort", "time_from_start"},
                       where);
    result.time = time(point["time_from_start"], where + ".time_from_start");
    result.q = vector(point["positions"], where + ".positions", true);
    result.velocity = vector(point["velocities"], where + ".velocities", false);
    result.acceleration = vector(point["accelerations"], where + ".accelerations", false);
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

  JointVector vector(const YAML::Node& node, const std::string& where, bool required) const {
    std::vector<double> numbers;
    const bool given = values_.numbers(node, where, numbers) && !numbers.empty();
    if (!given && !required) return {};
    JointVector result = JointVector::Zero(static_cast<Eigen::Index>(columns_.size()));
    if (numbers.size() != names_.size())
      values_.problem("has " + std::to_string(numbers.size()) + " numbers in " + where +
                      "; give one a joint.");
    else
      for (std::size_t j = 0; j < columns_.size(); ++j)
        result[static_cast<Eigen::Index>(j)] = numbers[columns_[j]];
    return result;
  }

  const Manipulator& manipulator_;
  YamlValues values_;
  Problems& problems_;
  Names names_;
  std::vector<std::size_t> columns_;  // of each leg
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
