// SPDX-License-Identifier: BSD-3-Clause
#include "tools/report/bounds_report.h"
#include "tools/report/plan_report.h"
#include "tools/report/text_table.h"

#include <algorithm>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

std::string ids(const std::vector<int>& aspects) {
  std::string text;
  for (const int aspect : aspects) text += (text.empty() ? "" : " ") + std::to_string(aspect);
  return text;
}

std::string through(const AspectMap& map, const Neighbours& gate) {
  return gate.crossing == Crossing::serial ? "B_jj = 0 of " + map.manipulator()->leg(gate.leg).name
                                           : "det A = 0";
}

json json_aspect(const Aspect& aspect, const AspectGraph& graph) {
  return {{"id", aspect.id},
          {"working_mode", aspect.mode.signs()},
          {"determinant_sign", aspect.determinant_sign},
          {"measure", aspect.measure},
          {"set", graph.set_of(aspect.id) + 1}};
}

json json_gate_crossing(TaskSpace space, const GateCrossing& crossing) {
  json object = {{"pose", json_pose(space, crossing.pose)},
                 {"index", json_number(crossing.index)},
                 {"segment", json::array()}};
  for (const Pose& pose : crossing.segment) object["segment"].push_back(json_pose(space, pose));
  return object;
}

json json_gate(const AspectMap& map, const Neighbours& gate) {
  const Manipulator& robot = *map.manipulator();
  json object = {{"aspects", {gate.first, gate.second}},
                 {"crossing", name(gate.crossing)},
                 {"leg", gate.crossing == Crossing::serial ? json(robot.leg(gate.leg).name) : json(nullptr)},
                 {"proved", gate.proved},
                 {"pose", json_pose(robot.task_space(), gate.pose)},
                 {"crossings", json::array()}};
  for (const GateCrossing& crossing : gate.crossings)
    object["crossings"].push_back(json_gate_crossing(robot.task_space(), crossing));
  return object;
}

json json_set(const AspectMap& map, const AspectGraph& graph, std::size_t index) {
  const AspectSet& set = graph.sets[index];
  json not_proved_apart = json::array();
  for (std::size_t i = 0; i < graph.sets.size(); ++i)
    if (i != index && graph.set_group[i] == graph.set_group[index]) not_proved_apart.push_back(i + 1);
  return {{"set", index + 1},
          {"aspects", set.aspects},
          {"determinant_sign", set.determinant_sign},
          {"workspace_lower", set.workspace_lower},
          {"unit", map.unit()},
          {"not_proved_apart_from", not_proved_apart}};
}

std::string sets_text(const AspectMap& map, const AspectGraph& graph) {
  TextTable table({">set", "det A", ">workspace at least [" + map.unit() + "]", "aspects"});
  for (std::size_t i = 0; i < graph.sets.size(); ++i) {
    const AspectSet& set = graph.sets[i];
    table.add({std::to_string(i + 1), set.determinant_sign > 0 ? "+" : "-",
               shown_bound(set.workspace_lower, Side::below), ids(set.aspects)});
  }
  return table.text();
}

std::string gates_text(const AspectMap& map, const AspectGraph& graph) {
  if (graph.gates.empty()) return "no gates were found\n";
  TextTable table({">aspect", ">aspect", "gate", "", "near"});
  for (const Neighbours& gate : graph.gates)
    table.add({std::to_string(gate.first), std::to_string(gate.second), through(map, gate),
               gate.proved ? "proved" : "possible", to_string(map.manipulator()->task_space(), gate.pose)});
  return table.text();
}

std::string headline(const AspectMap& map, const AspectGraph& graph) {
  const std::size_t sets = graph.sets.size();
  std::string text = map.manipulator()->name() + ": " + counted(map.aspects().size(), "aspect") + " in " +
                     counted(sets, "set") + ", joined through serial gates; ";
  return text +
         (graph.proved_set_count == sets
              ? "proved to be different"
              : "at least " + std::to_string(graph.proved_set_count) + " are proved to be different") +
         "\n";
}

}  // namespace

Report report_graph(const AspectMap& map, const AspectGraph& graph) {
  json object = {{"mechanism", map.manipulator()->name()},
                 {"aspects", json::array()},
                 {"gates", json::array()},
                 {"sets", json::array()},
                 {"proved_set_count", graph.proved_set_count}};
  for (const Aspect& aspect : map.aspects()) object["aspects"].push_back(json_aspect(aspect, graph));
  for (const Neighbours& gate : graph.gates) object["gates"].push_back(json_gate(map, gate));
  for (std::size_t i = 0; i < graph.sets.size(); ++i) object["sets"].push_back(json_set(map, graph, i));
  const Report constraints = report_constraints(*map.manipulator());
  object.update(constraints.json);
  return {object, headline(map, graph) + '\n' + sets_text(map, graph) + '\n' + gates_text(map, graph) + '\n' +
                      constraints.text};
}

std::string graph_as_dot(const AspectMap& map, const AspectGraph& graph) {
  std::string text = "graph aspects {\n";
  for (std::size_t i = 0; i < graph.sets.size(); ++i) {
    text += "  subgraph cluster_" + std::to_string(i + 1) + " {\n    label=\"set " + std::to_string(i + 1) +
            ", det A " + (graph.sets[i].determinant_sign > 0 ? "> 0" : "< 0") + "\";\n";
    for (const int id : graph.sets[i].aspects)
      text += "    " + std::to_string(id) + " [label=\"" + std::to_string(id) + "\\n" +
              to_string(map.aspects()[static_cast<std::size_t>(id - 1)].mode) + "\"];\n";
    text += "  }\n";
  }
  for (const Neighbours& gate : graph.gates) {
    const bool serial = gate.crossing == Crossing::serial;
    text += "  " + std::to_string(gate.first) + " -- " + std::to_string(gate.second) + " [" +
            (serial ? "label=\"leg " + std::to_string(gate.leg + 1) + "\"" : std::string("color=red")) +
            (gate.proved ? "" : ", style=dashed") + "];\n";
  }
  return text + "}\n";
}

}  // namespace parallel_aspects::tools
