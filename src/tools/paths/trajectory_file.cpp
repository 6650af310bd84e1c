// SPDX-License-Identifier: BSD-3-Clause
#include "tools/paths/trajectory_file.h"

#include "ask/question_parts.h"
#include "tools/numbers.h"
#include "tools/report/report.h"
#include "urdf/description/text_file.h"
#include "urdf/description/yaml_values.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <utility>

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

namespace {

using Names = std::vector<std::string>;

struct Table {
  Names names;
  std::vector<std::vector<double>> rows;
};

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r,") == std::string::npos; }

Names split(std::string line) {
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream stream(line);
  Names names;
  for (std::string word; stream >> word;) names.push_back(word == "t" ? "time" : word);
  return names;
}

/// The first cell with nothing in it that stands before one with something, counted from 1; 0 where there is
/// none. Left out, it would shift the columns behind it.
std::size_t empty_cell(const std::string& line) {
  std::istringstream cells(line.substr(0, line.find_last_not_of(" \t\r,") + 1));
  std::size_t column = 1;
  for (std::string cell; std::getline(cells, cell, ','); ++column)
    if (is_blank(cell)) return column;
  return 0;
}

std::ptrdiff_t place(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) - names.begin();
}

/// Numbers whose columns have names.
Table table_of(const std::string& file, const std::string& text, Problems& problems) {
  Table table;
  std::istringstream stream(text);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (is_blank(line)) continue;
    const std::string where = file + ", line " + std::to_string(number) + ",";
    if (const std::size_t column = empty_cell(line))
      problems.push_back(where + " has an empty cell in column " + std::to_string(column) + "; fill it.");
    if (table.names.empty())
      table.names = split(line);
    else if (empty_cell(line) == 0)
      table.rows.push_back(parse_numbers(where, line, table.names, problems));
  }
  if (table.rows.empty() && problems.empty())
    problems.push_back(file +
                       " has no waypoint; give a line with the names of the columns, and one for each "
                       "waypoint.");
  return table;
}

/// Throws `InvalidDescription` where it cannot be read.
std::string text_of(const std::string& file) {
  Problems problems;
  const std::optional<std::string> text = read_text_file(file, problems);
  if (!text) throw InvalidDescription(std::move(problems));
  const std::string byte_order_mark = "\xEF\xBB\xBF";  // of spreadsheets
  return text->rfind(byte_order_mark, 0) == 0 ? text->substr(byte_order_mark.size()) : *text;
}

/// A column each, once, and no other.
void require_columns(const std::string& file, const Names& given, const Names& needed, Problems& problems) {
  const std::string all = "; the columns are " + joined(needed, ",") + ".";
  for (const std::string& name : needed)
    if (std::count(given.begin(), given.end(), name) != 1)
      problems.push_back(file + " does not have the column '" + name + "' once" + all);
  for (const std::string& name : given)
    if (std::count(needed.begin(), needed.end(), name) == 0)
      problems.push_back(file + " has the unknown column '" + name + "'" + all);
}

/// The rows with their columns in the order of `needed`.
std::vector<std::vector<double>> read_columns(const std::string& file, const Table& table,
                                              const Names& needed, Problems problems) {
  if (!table.names.empty()) require_columns(file, table.names, needed, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  std::vector<std::vector<double>> rows;
  for (const std::vector<double>& row : table.rows) {
    rows.emplace_back();
    for (const std::string& name : needed)
      rows.back().push_back(row[static_cast<std::size_t>(place(table.names, name))]);
  }
  return rows;
}

/// From one waypoint to the next the platform turns the short way, so that a longer turn is not what would be
/// examined. Quaternions have no such ambiguity.
void require_short_turns(TaskSpace space, const std::string& file,
                         const std::vector<std::vector<double>>& rows, Problems& problems) {
  constexpr double half_turn = EIGEN_PI;
  const Names& names = coordinate_names(space);
  if (space != TaskSpace::SE2 && !has_hinges(space)) return;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    for (std::size_t k = space == TaskSpace::SE2 ? 2 : 0; k < names.size(); ++k)
      if (!(std::abs(rows[i + 1][k + 1] - rows[i][k + 1]) < half_turn))
        problems.push_back(file + ", waypoint " + std::to_string(i + 2) + ", turns " + names[k] +
                           " by half a turn or more, which would be taken the short way round; give "
                           "waypoints in between.");
}

}  // namespace

Option path_option(std::string& file) {
  return {
      "--path",
      "FILE",
      "CSV with poses of the platform: a header such as time,x,y and a line for each waypoint [s, m, rad]",
      &file,
      false,
      Words::one,
      FileUse::read};
}

std::vector<PoseWaypoint> read_pose_waypoints(const Motions& motions, const std::string& file) {
  const TaskSpace space = motions.space;
  Names needed{"time"};
  for (const std::string& name : coordinate_names(space)) needed.push_back(name);
  std::vector<PoseWaypoint> waypoints;
  Problems problems;
  const Table table = table_of(file, text_of(file), problems);
  const auto rows = read_columns(file, table, needed, problems);
  require_short_turns(space, file, rows, problems);
  for (const std::vector<double>& row : rows) {
    const auto pose = pose_from_coordinates(
        motions,
        Eigen::Map<const Eigen::VectorXd>(row.data() + 1, static_cast<Eigen::Index>(row.size() - 1)));
    if (!pose)
      problems.push_back(file + ", waypoint " + std::to_string(waypoints.size() + 1) +
                         ", has a quaternion of zero length; give a unit quaternion.");
    waypoints.push_back({row.front(), pose.value_or(Pose{})});
  }
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return waypoints;
}

namespace {

Names with_ending(const Names& joints, const std::string& ending) {
  Names names;
  for (const std::string& joint : joints) names.push_back(joint + ending);
  return names;
}

/// Those of the columns that belong to all joints, if any of them is there.
bool append_if_any(const Names& columns, const Names& given, Names& needed) {
  const bool any = std::any_of(columns.begin(), columns.end(), [&given](const std::string& column) {
    return std::count(given.begin(), given.end(), column) > 0;
  });
  if (any) needed.insert(needed.end(), columns.begin(), columns.end());
  return any;
}

/// The next numbers of a row, one a leg.
JointVector take(const std::vector<double>& row, std::size_t first, std::size_t legs) {
  return Eigen::Map<const Eigen::VectorXd>(row.data() + first, static_cast<Eigen::Index>(legs));
}

std::vector<JointWaypoint> waypoints_of_table(const Manipulator& manipulator, const std::string& file,
                                              const std::string& text) {
  Problems problems;
  const Table table = table_of(file, text, problems);
  const std::size_t legs = manipulator.leg_count();
  Names joints;
  for (const Leg& leg : manipulator.legs()) joints.push_back(leg.actuated_joint);
  Names needed{"time"};
  needed.insert(needed.end(), joints.begin(), joints.end());
  const bool accelerations = append_if_any(with_ending(joints, "/acceleration"), table.names, needed);
  const bool velocities = append_if_any(with_ending(joints, "/velocity"), table.names, needed);
  std::vector<JointWaypoint> waypoints;
  for (const std::vector<double>& row : read_columns(file, table, needed, problems)) {
    JointWaypoint waypoint{row.front(), take(row, 1, legs), {}, {}};
    if (accelerations) waypoint.acceleration = take(row, 1 + legs, legs);
    if (velocities) waypoint.velocity = take(row, 1 + (accelerations ? 2 : 1) * legs, legs);
    waypoints.push_back(waypoint);
  }
  return waypoints;
}

}  // namespace

std::vector<JointWaypoint> read_joint_waypoints(const Manipulator& manipulator, const std::string& file) {
  Problems problems;
  const std::string text = text_of(file);
  if (text.find("joint_names:") == std::string::npos) return waypoints_of_table(manipulator, file, text);
  const auto waypoints = waypoints_of_message(manipulator, file, text, problems);
  if (!problems.empty()) throw InvalidDescription(std::move(problems));
  return waypoints;
}

}  // namespace parallel_aspects::tools
