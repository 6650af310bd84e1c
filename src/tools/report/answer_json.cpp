// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/answer_json.h"

#include "tools/report/basins_report.h"
#include "tools/report/report.h"

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

/// A roadmap does not number aspects.
json aspect_or_null(int id) { return id == 0 ? json() : json(id); }

}  // namespace

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
  json object;
  for (const ask::NamedRange& each : ranges) {
    object["lower"][each.name] = json_of(each.lower);
    object["upper"][each.name] = json_of(each.upper);
  }
  return object;
}

json JsonWriter::json_of(const MapSlice& slice) const { return json_slice(slice); }

json JsonWriter::json_of(const CuspStart& start) const {
  json object = {
      {"component", start.aspect}, {"pose", nullptr}, {"working_mode", nullptr}, {"actuated", nullptr}};
  if (start.point) object.update(json_of(*start.point));
  return object;
}

json JsonWriter::json_of(const Pose& pose) const { return json_pose(robot_.task_space(), pose); }

json JsonWriter::json_of(const ask::IndexBottleneck& bottleneck) const {
  return json_bottleneck(bottleneck.kind, bottleneck.found);
}

json JsonWriter::json_of(const PathPoint& point) const {
  return {
      {"pose", json_of(point.pose)}, {"working_mode", json_of(point.mode)}, {"actuated", json_of(point.q)}};
}

json JsonWriter::json_of(const PathCrossing& crossing) const {
  const bool serial = crossing.kind == Crossing::serial;
  return {{"after_point", crossing.point},
          {"before_point", crossing.behind},
          {"crossing", name(crossing.kind)},
          {"control_lost", !serial},
          {"leg", serial ? json(robot_.leg(crossing.leg).name) : json(nullptr)},
          {"from_aspect", aspect_or_null(crossing.from)},
          {"to_aspect", aspect_or_null(crossing.to)}};
}

json JsonWriter::json_of(const TimedPath& timed) const {
  return {{"message", timed.message},
          {"waypoints", timed.waypoints.size()},
          {"corners_rounded", timed.rounded},
          {"stops", timed.stops}};
}

}  // namespace parallel_aspects::tools
