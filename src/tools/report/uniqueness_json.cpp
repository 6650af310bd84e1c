// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/uniqueness_json.h"

#include "parallel_aspects/kinematics/kinematics.h"
#include "tools/report/report.h"

#include <cstddef>
#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

json json_component(const AspectMap& map, const Aspect& aspect) {
  return {{"id", aspect.id},
          {"working_mode", aspect.mode.signs()},
          {"determinant_sign", aspect.determinant_sign},
          {"measure", aspect.measure},
          {"unit", map.unit()},
          {"deepest", json_pose(map.manipulator()->task_space(), aspect.deepest)},
          {"unresolved_with", aspect.unresolved_with}};
}

json json_node(const Manipulator& robot, const SolutionNode& node) {
  return {
      {"actuated", json_numbers(node.actuated)},
      {"poses", {json_pose(robot.task_space(), node.poses[0]), json_pose(robot.task_space(), node.poses[1])}},
      {"proved", true},
      {"accuracy", node.accuracy}};
}

/// Null where it is of all at once.
json json_mode(const WorkingMode& mode) { return mode.signs().empty() ? json() : json(mode.signs()); }

json json_region(const SolutionRegion& region, const std::string& unit) {
  return {{"working_mode", json_mode(region.mode)},
          {"solutions", region.solutions},
          {"measure", region.measure},
          {"measure_lower", region.measure_lower},
          {"measure_upper", region.measure_upper},
          {"unit", unit}};
}

json json_basic_component(const Manipulator& robot, const BasicComponent& component,
                          const std::string& unit) {
  json poses = json::array();
  for (const Pose& pose : component.solutions) poses.push_back(json_pose(robot.task_space(), pose));
  return {{"working_mode", json_mode(component.mode)}, {"actuated", json_numbers(component.inside)},
          {"solutions", component.solutions.size()},   {"poses", poses},
          {"components", component.aspects},           {"measure", component.measure},
          {"measure_lower", component.measure_lower},  {"unit", unit}};
}

/// Of the aspect of a region; empty where that is not known.
WorkingMode mode_of(const Uniqueness& uniqueness, const BasicRegion& region) {
  if (region.aspect == 0) return {};
  return uniqueness.map->aspects()[static_cast<std::size_t>(region.aspect - 1)].mode;
}

json json_basic_region(const Uniqueness& uniqueness, const BasicRegion& region) {
  const auto below = component_below(uniqueness, region);
  return {{"component", region.aspect},
          {"pose", json_pose(uniqueness.map->manipulator()->task_space(), region.pose)},
          {"over", region.over},
          {"basic_component", below ? json(*below) : json()},
          {"actuated", json_numbers(region.actuated)},
          {"unique", region.is_unique},
          {"measure_lower", region.measure_lower},
          {"unit", uniqueness.region_unit}};
}

json json_domain(const UniquenessDomain& domain, const std::string& unit) {
  json object = {{"component", domain.aspect}, {"whole_component", domain.whole_aspect}};
  if (domain.whole_aspect) return object;
  object["basic_regions"] = domain.basic_regions;
  object["measure_lower"] = domain.measure_lower;
  object["unit"] = unit;
  return object;
}

}  // namespace

bool has_modes(const Manipulator& robot) { return working_modes(robot).size() > 1; }

bool are_of_all_modes(const Uniqueness& uniqueness) {
  return has_modes(*uniqueness.map->manipulator()) && !uniqueness.by_mode;
}

std::optional<std::size_t> component_below(const Uniqueness& uniqueness, const BasicRegion& region) {
  if (are_of_all_modes(uniqueness)) return std::nullopt;
  return uniqueness.component_at(region.actuated, mode_of(uniqueness, region));
}

json json_cusp(const Manipulator& robot, const Cusp& cusp) {
  return {{"actuated", json_numbers(cusp.actuated)},
          {"working_mode", cusp.mode.signs()},
          {"pose", json_pose(robot.task_space(), cusp.pose)},
          {"proved", true},
          {"accuracy", cusp.accuracy},
          {"component", cusp.aspect}};
}

json json_numbers_of_solutions(const Manipulator& robot, const SolutionNumbers& numbers) {
  json object = {{"regions", json::array()},
                 {"measure_unknown", numbers.has_regions ? json(numbers.measure_unknown) : json()},
                 {"basic_components", json::array()}};
  for (const SolutionRegion& region : numbers.regions)
    object["regions"].push_back(json_region(region, numbers.region_unit));
  for (const BasicComponent& component : numbers.basic_components)
    object["basic_components"].push_back(json_basic_component(robot, component, numbers.region_unit));
  return object;
}

json json_uniqueness(const Uniqueness& uniqueness) {
  const AspectMap& map = *uniqueness.map;
  json object = {{"mechanism", map.manipulator()->name()},
                 {"task_space", std::string(name(map.manipulator()->task_space()))},
                 {"slice", json_slice(map.slice())},
                 {"at_most_one_solution_a_sign", uniqueness.at_most_one_a_sign},
                 {"components", json::array()},
                 {"cusps", json::array()},
                 {"cusps_complete", uniqueness.cusps_complete},
                 {"nodes", json::array()},
                 {"nodes_complete", uniqueness.nodes_complete},
                 {"basic_regions", json::array()},
                 {"uniqueness_domains_complete", uniqueness.domains_complete},
                 {"uniqueness_domains", json::array()}};
  for (const Aspect& aspect : map.aspects()) object["components"].push_back(json_component(map, aspect));
  for (const Cusp& cusp : uniqueness.cusps) object["cusps"].push_back(json_cusp(*map.manipulator(), cusp));
  for (const SolutionNode& node : uniqueness.nodes)
    object["nodes"].push_back(json_node(*map.manipulator(), node));
  object.update(json_numbers_of_solutions(*map.manipulator(), uniqueness));
  for (const BasicRegion& region : uniqueness.basic_regions)
    object["basic_regions"].push_back(json_basic_region(uniqueness, region));
  for (const UniquenessDomain& domain : uniqueness.domains)
    object["uniqueness_domains"].push_back(json_domain(domain, uniqueness.region_unit));
  return object;
}

}  // namespace parallel_aspects::tools
