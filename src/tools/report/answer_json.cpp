// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/answer_json.h"

#include "tools/report/report.h"

namespace parallel_aspects::tools {
using nlohmann::json;

json JsonWriter::json_of(double value) const { return json_number(value); }

json JsonWriter::json_of(const TaskVector& values) const { return json_numbers(values); }

json JsonWriter::json_of(const TaskMatrix& matrix) const {
  json rows = json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push_back(json_numbers(matrix.row(i).transpose()));
  return rows;
}

json JsonWriter::json_of(const std::vector<HeldCoordinate>& values) const {
  json object = json::object();
  for (const HeldCoordinate& each : values) object[each.name] = json_of(each.value);
  return object;
}

json JsonWriter::json_of(const std::vector<ask::NamedRange>& ranges) const {
  json object = {{"lower", json::object()}, {"upper", json::object()}};
  for (const ask::NamedRange& each : ranges) {
    object["lower"][each.name] = json_of(each.lower);
    object["upper"][each.name] = json_of(each.upper);
  }
  return object;
}

json JsonWriter::json_of(const MapSlice& slice) const { return json_slice(slice); }

json JsonWriter::json_of(const Pose& pose) const { return json_pose(robot_->task_space(), pose); }

json JsonWriter::json_of(const TimedPath& timed) const {
  return {{"message", timed.message},
          {"waypoints", timed.waypoints.size()},
          {"corners_rounded", timed.rounded},
          {"stops", timed.stops}};
}

}  // namespace parallel_aspects::tools
