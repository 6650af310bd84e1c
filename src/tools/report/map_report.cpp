// SPDX-License-Identifier: BSD-3-Clause
#include "model/coefficients.h"
#include "tools/report/bounds_report.h"
#include "tools/report/reports.h"
#include "tools/report/text_table.h"

#include <utility>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

json json_aspect(const AspectMap& map, const Aspect& aspect) {
  return {{"id", aspect.id},
          {"working_mode", aspect.mode.signs()},
          {"det_a_sign", aspect.determinant_sign},
          {"measure", json_number(aspect.measure)},
          {"measure_lower", json_number(aspect.measure_lower)},
          {"measure_upper", json_number(aspect.measure_upper)},
          {"unit", map.unit()},
          {"inside_leaves", aspect.inside_leaves},
          {"bounding_box", json_box(map.coordinates(), aspect.bounds)},
          {"deepest_pose", json_pose(map.manipulator()->task_space(), aspect.deepest)},
          {"clearance", json_number(aspect.deepest_clearance)},
          {"unresolved_with", aspect.unresolved_with}};
}

/// What is held and what is free; null where all poses are mapped.
json json_slice(const AspectMap& map) {
  if (!map.slice()) return nullptr;
  json held = json::object();
  for (const HeldCoordinate& each : map.slice()->held_coordinates) held[each.name] = json_number(each.value);
  const bool freely = map.slice()->rotation == MapSlice::Rotation::freely;
  json axis = nullptr;
  if (map.slice()->rotation == MapSlice::Rotation::about_axis)
    axis = {map.slice()->axis.x(), map.slice()->axis.y(), map.slice()->axis.z()};
  return {{"held", held},
          {"axis", axis},
          {"free", freely ? std::vector<std::string>{"roll", "pitch", "yaw"} : map.coordinates()}};
}

/// Null where the map was loaded.
json json_symmetry(const AspectMap& map) {
  if (!map.symmetry_use()) return nullptr;
  return {{"motions", map.symmetry_use()->motions}, {"computed_modes", map.symmetry_use()->computed_modes}};
}

json json_map(const AspectMap& map) {
  const TaskSpace space = map.manipulator()->task_space();
  json object = {{"mechanism", map.manipulator()->name()},
                 {"task_space", std::string(name(space))},
                 {"slice", json_slice(map)},
                 {"region", json_box(map.coordinates(), map.region())},
                 {"resolution", json_number(map.resolution())},
                 {"seconds", json_number(map.seconds())},
                 {"symmetry", json_symmetry(map)},
                 {"unit", map.unit()},
                 {"working_modes", json::array()},
                 {"aspects", json::array()},
                 {"proved_count", map.proved_count()},
                 {"count_at_most", map.count_at_most() ? json(*map.count_at_most()) : json()},
                 {"indeterminate_leaves", map.indeterminate_leaves()},
                 {"inside_components", map.aspects().size()},
                 {"unresolved", map.unresolved()},
                 {"measure_undecided", json_number(map.measure_undecided())}};
  for (const WorkingMode& mode : map.working_modes()) object["working_modes"].push_back(mode.signs());
  for (const Aspect& aspect : map.aspects()) object["aspects"].push_back(json_aspect(map, aspect));
  return object;
}

std::string pose_text(TaskSpace space, const Pose& pose) {
  std::string text;
  const PoseCoordinates coordinates = pose_coordinates(space, pose);
  for (const double coordinate : coefficients_of(coordinates))
    text += (text.empty() ? "(" : ", ") + shown_briefly(coordinate);
  return text + ")";
}

std::string bounds_text(const Box& box) {
  std::string text;
  for (std::size_t i = 0; i < box.dimension; ++i)
    text += (i == 0 ? "" : " x ") + std::string("[") + shown_briefly(box.lower[i]) + ", " +
            shown_briefly(box.upper[i]) + "]";
  return text;
}

std::string aspect_table(const AspectMap& map) {
  TextTable table({">id", "working mode", "det A", ">measure [" + map.unit() + "]", ">at least", ">at most",
                   ">leaves", "bounds", "deepest pose", ">clearance"});
  for (const Aspect& aspect : map.aspects())
    table.add({std::to_string(aspect.id), to_string(aspect.mode), shown_sign(aspect.determinant_sign),
               shown(aspect.measure), shown(aspect.measure_lower), shown(aspect.measure_upper),
               std::to_string(aspect.inside_leaves), bounds_text(aspect.bounds),
               pose_text(map.manipulator()->task_space(), aspect.deepest),
               shown_briefly(aspect.deepest_clearance)});
  return table.text();
}

std::string unresolved_text(const std::vector<std::pair<int, int>>& pairs) {
  if (pairs.empty()) return "none; all are proved separate";
  std::string text;
  for (const auto& pair : pairs)
    text += (text.empty() ? "" : ", ") + std::to_string(pair.first) + " with " + std::to_string(pair.second);
  return text;
}

/// What is proved of aspects that are not listed.
std::string completeness_text(const AspectMap& map) {
  const auto most = map.count_at_most();
  if (!most) return "";
  return *most == map.proved_count() ? ", proved to be all" : ", " + std::to_string(*most) + " at most";
}

/// Which symmetries were used, and what for.
std::string symmetry_text(const AspectMap& map) {
  if (!map.symmetry_use() || map.symmetry_use()->motions.empty()) return "";
  std::string text;
  for (const std::string& motion : map.symmetry_use()->motions) text += (text.empty() ? " " : "; ") + motion;
  return "symmetry" + text + ": components of " +
         counted(map.symmetry_use()->computed_modes, "working mode") + " computed\n";
}

std::string map_text(const AspectMap& map) {
  const TaskSpace space = map.manipulator()->task_space();
  std::string text = map.manipulator()->name() + ": " + counted(map.aspects().size(), "aspect") + " in " +
                     counted(map.working_modes().size(), "working mode") + ", " +
                     std::to_string(map.proved_count()) + " proved distinct" + completeness_text(map) + "\n";
  if (map.slice())
    text += "slice " + to_string(*map.slice()) +
            ": aspects of the slice, of which two may be joined outside of it\n";
  text += "task space " + std::string(name(space)) + ", region " + bounds_text(map.region()) +
          ", resolution " + shown(map.resolution()) + ", " + shown(map.seconds()) + " s\n" +
          symmetry_text(map) + "\n";
  text += aspect_table(map);
  text += "\npairs that could be one aspect: " + unresolved_text(map.unresolved()) + "\n";
  text += "undecided, over all working modes: " + shown(map.measure_undecided()) + " " + map.unit() + "\n";
  return text;
}

}  // namespace

Report report_map(const AspectMap& map, bool loaded) {
  Report report{json_map(map), map_text(map)};
  const Report bounds = report_bounds(map);
  report.json.update(bounds.json);
  report.text += bounds.text;
  report.json["loaded"] = loaded;
  return report;
}

}  // namespace parallel_aspects::tools
