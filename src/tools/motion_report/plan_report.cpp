// SPDX-License-Identifier: BSD-3-Clause
#include "tools/motion_report/plan_report.h"

#include "model/task_space_traits.h"
#include "tools/report/bounds_report.h"
#include "tools/report/slice_report.h"
#include "tools/report/text_table.h"

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

json json_point(const Manipulator& manipulator, const PathPoint& point) {
  return {{"pose", json_pose(manipulator.task_space(), point.pose)},
          {"working_mode", point.mode.signs()},
          {"actuated", json_numbers(point.q)}};
}

/// A roadmap does not number aspects.
json json_aspect(int id) { return id == 0 ? json() : json(id); }

json json_crossing(const Manipulator& manipulator, const PathCrossing& crossing) {
  const bool serial = crossing.kind == Crossing::serial;
  return {{"after_point", crossing.point},
          {"before_point", crossing.behind},
          {"crossing", name(crossing.kind)},
          {"control_lost", !serial},
          {"leg", serial ? json(manipulator.leg(crossing.leg).name) : json(nullptr)},
          {"from_aspect", json_aspect(crossing.from)},
          {"to_aspect", json_aspect(crossing.to)}};
}

/// What happens between a point and the one before.
std::string remark(const Manipulator& manipulator, const PlannedPath& path, std::size_t point) {
  for (const PathCrossing& crossing : path.crossings) {
    if (crossing.behind != point) continue;
    const std::string text = crossing.kind == Crossing::parallel
                                 ? "det A = 0, control of the platform is lost"
                                 : "leg '" + manipulator.leg(crossing.leg).name + "' changes its posture";
    return crossing.from == 0
               ? text
               : text + ", aspect " + std::to_string(crossing.from) + " to " + std::to_string(crossing.to);
  }
  return "";
}

std::string points_text(const Manipulator& manipulator, const PlannedPath& path) {
  TextTable table({">point", "pose", "working mode", "actuated joints", ""});
  for (std::size_t i = 0; i < path.points.size(); ++i)
    table.add({std::to_string(i), to_string(manipulator.task_space(), path.points[i].pose),
               to_string(path.points[i].mode), shown(path.points[i].q), remark(manipulator, path, i)});
  return table.text();
}

std::string length_text(const Manipulator& manipulator, const PlannedPath& path) {
  std::string text;
  if (traits(manipulator.task_space()).translations > 0) text = shown(path.length) + " m";
  if (traits(manipulator.task_space()).rotations > 0)
    text += (text.empty() ? "" : ", turning by ") + shown(path.turned) + " rad";
  return text;
}

/// How the pose runs there; what is proved is proved of this curve alone.
std::string between_points(const std::optional<MapSlice>& slice) {
  return slice && slice->joint ? "the direction of the held anchor from the base, and phi, run straight"
                               : "positions run straight; quaternions straight and normalised, the short way";
}

}  // namespace

Report report_path(const Manipulator& manipulator, const PlannedPath& path, const PathWish& wish,
                   const std::optional<MapSlice>& slice) {
  const bool has_path = path.answer == SameAspect::yes;
  json object = {{"mechanism", manipulator.name()},
                 {"policy", name(wish.policy)},
                 {"prefer", name(wish.prefer)},
                 {"answer", name(path.answer)},
                 {"proved", path.answer != SameAspect::unknown},
                 {"slice", json_slice(slice)},
                 {"between_points", between_points(slice)},
                 {"reason", path.message},
                 {"path", json::array()},
                 {"crossings", json::array()},
                 {"length", has_path ? json(path.length) : json()},
                 {"turned", has_path ? json(path.turned) : json()},
                 {"least_index", json_number(path.least_index)},
                 {"least_det_a", json_number(path.least_det_a)}};
  for (const PathPoint& point : path.points) object["path"].push_back(json_point(manipulator, point));
  for (const PathCrossing& crossing : path.crossings)
    object["crossings"].push_back(json_crossing(manipulator, crossing));
  std::string text = manipulator.name() + ", a path: " + name(path.answer) + "\n" + path.message + "\n";
  const std::string unit = determinant_unit(manipulator);
  if (has_path)
    text += counted(path.points.size(), "point") + ", " + counted(path.crossings.size(), "crossing") + ", " +
            length_text(manipulator, path) + "\nsmallest of 32 poses a segment: parallel index " +
            shown(path.least_index) + ", |det A| " + shown(path.least_det_a) +
            (unit.empty() ? unit : " " + unit) + "\nbetween points: " + between_points(slice) + "\n\n" +
            points_text(manipulator, path);
  const Report constraints = report_constraints(manipulator);
  object.update(constraints.json);
  return {object, text + '\n' + constraints.text};
}

}  // namespace parallel_aspects::tools
