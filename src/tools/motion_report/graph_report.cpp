// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/kinematics/kinematics.h"
#include "tools/motion_report/plan_report.h"
#include "tools/report/constraints_report.h"
#include "tools/report/report.h"

#include <algorithm>
#include <set>
#include <string>

namespace parallel_aspects::tools {
namespace {

using nlohmann::json;

std::string ids(const std::vector<int>& aspects) {
  std::string text;
  for (const int aspect : aspects) text += (text.empty() ? "" : " ") + std::to_string(aspect);
  return text;
}

std::string through(const Manipulator& robot, const Neighbours& gate) {
  return gate.crossing == Crossing::serial ? "B_jj = 0 of " + robot.leg(gate.leg).name : "det A = 0";
}

json json_aspect(const Aspect& aspect, const AspectGraph& graph) {
  return {{"id", aspect.id},
          {"working_mode", aspect.mode.signs()},
          {"determinant_sign", aspect.determinant_sign},
          {"measure", aspect.measure},
          {"set", graph.set_of(aspect.id) + 1}};
}

json json_part(const RoadmapPart& part, const AspectGraph& graph) {
  return {
      {"id", part.id},      {"working_mode", part.mode.signs()}, {"determinant_sign", part.determinant_sign},
      {"measure", nullptr}, {"samples", part.samples},           {"set", graph.set_of(part.id) + 1}};
}

json json_gate_crossing(TaskSpace space, const GateCrossing& crossing) {
  json object = {{"pose", json_pose(space, crossing.pose)},
                 {"index", json_number(crossing.index)},
                 {"segment", json::array()}};
  for (const Pose& pose : crossing.segment) object["segment"].push_back(json_pose(space, pose));
  return object;
}

json json_gate(const Manipulator& robot, const Neighbours& gate) {
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

/// Without its workspace.
json json_set(const AspectGraph& graph, std::size_t index) {
  const AspectSet& set = graph.sets[index];
  json not_proved_apart = json::array();
  for (std::size_t i = 0; i < graph.sets.size(); ++i)
    if (i != index && graph.set_group[i] == graph.set_group[index]) not_proved_apart.push_back(i + 1);
  return {
      {"set", index + 1},           {"aspects", set.aspects}, {"determinant_sign", set.determinant_sign},
      {"workspace_lower", nullptr}, {"unit", nullptr},        {"not_proved_apart_from", not_proved_apart}};
}

/// What graphs of maps and of roadmaps have alike.
json json_graph(const Manipulator& robot, const AspectGraph& graph, const std::string& reason) {
  json object = {{"mechanism", robot.name()},
                 {"aspects", json::array()},
                 {"gates", json::array()},
                 {"sets", json::array()},
                 {"proved_set_count", graph.proved_set_count},
                 {"reason", reason}};
  for (const Neighbours& gate : graph.gates) object["gates"].push_back(json_gate(robot, gate));
  for (std::size_t i = 0; i < graph.sets.size(); ++i) object["sets"].push_back(json_set(graph, i));
  return object;
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

std::string gates_text(const Manipulator& robot, const AspectGraph& graph) {
  if (graph.gates.empty()) return "no gates were found\n";
  TextTable table({">aspect", ">aspect", "gate", "", "near"});
  for (const Neighbours& gate : graph.gates)
    table.add({std::to_string(gate.first), std::to_string(gate.second), through(robot, gate),
               gate.proved ? "proved" : "possible", to_string(robot.task_space(), gate.pose)});
  return table.text();
}

/// What joins aspects to sets, or why nothing does.
std::string joints_text(const Manipulator& robot, const AspectGraph& graph, const std::string& node) {
  const bool is_joined = std::any_of(graph.gates.begin(), graph.gates.end(), [](const Neighbours& gate) {
    return gate.proved && gate.crossing == Crossing::serial;
  });
  if (is_joined) return "joined through serial gates";
  return working_modes(robot).size() == 1
             ? "each one " + node + ": with one working mode there are no serial gates"
             : "each one " + node + ": no serial gate is proved";
}

std::string apart_text(const AspectGraph& graph) {
  const std::size_t sets = graph.sets.size();
  if (sets == 1) return "";
  return graph.proved_set_count == sets
             ? "; proved to be different"
             : "; at least " + std::to_string(graph.proved_set_count) + " are proved to be different";
}

std::string empty_text(const AspectMap& map) {
  const std::string where = map.slice() ? "the slice " + to_string(*map.slice()) : "the region of the map";
  const double undecided = map.measure_undecided();
  return undecided > 0.0 ? "no aspect is proved in " + where + ", of which " + shown(undecided) + " " +
                               map.unit() + " are undecided, over all working modes"
                         : "proved: " + where + " holds no part of an aspect";
}

std::string headline(const AspectMap& map, const AspectGraph& graph) {
  return map.aspects().empty()
             ? empty_text(map)
             : counted(map.aspects().size(), "aspect") + " in " + counted(graph.sets.size(), "set") + ", " +
                   joints_text(*map.manipulator(), graph, "aspect") + apart_text(graph);
}

/// Nothing where there is nothing to list.
std::string tables_text(const AspectMap& map, const AspectGraph& graph) {
  return map.aspects().empty() ? ""
                               : sets_text(map, graph) + '\n' + gates_text(*map.manipulator(), graph) + '\n';
}

std::string headline(const PoseRoadmap& roadmap, const RoadmapGraph& found) {
  const Manipulator& robot = *roadmap.certifier().manipulator();
  return counted(found.parts.size(), "part") + " of at least " + counted(roadmap.proved_count(), "aspect") +
         ", in " + counted(found.graph.sets.size(), "set") + ", " + joints_text(robot, found.graph, "part") +
         apart_text(found.graph) + (found.graph.proved_set_count > 1 ? ", by the sign of det A" : "");
}

/// A line for each set: there may be hundreds of parts.
std::string sets_text(const RoadmapGraph& found) {
  TextTable table({">set", "det A", ">parts", ">working modes", ">samples"});
  for (std::size_t i = 0; i < found.graph.sets.size(); ++i) {
    const AspectSet& set = found.graph.sets[i];
    std::set<std::size_t> modes;
    std::size_t samples = 0;
    for (const int id : set.aspects) {
      const RoadmapPart& part = found.parts[static_cast<std::size_t>(id - 1)];
      modes.insert(part.mode.index());
      samples += part.samples;
    }
    table.add({std::to_string(i + 1), set.determinant_sign > 0 ? "+" : "-",
               std::to_string(set.aspects.size()), std::to_string(modes.size()), std::to_string(samples)});
  }
  return table.text();
}

std::string gates_text(const AspectGraph& graph) {
  return graph.gates.empty() ? ""
                             : counted(graph.gates.size(), "serial gate") +
                                   " between parts, each proved; --json lists them, --dot draws them\n";
}

/// What is not resolved.
std::string open_text(const RoadmapGraph& found) {
  const std::size_t sets = found.graph.sets.size(), proved = found.graph.proved_set_count;
  return "Parts are poses that proved segments join; two may belong to one aspect, and aspects that no "
         "sample "
         "meets are not seen.\n" +
         (sets > proved
              ? "Whether the " + std::to_string(sets) + " sets are more than " + std::to_string(proved) +
                    " is not resolved: gates that were not found may join those of one sign.\n"
              : std::string()) +
         "Parallel gates are not looked for.\n";
}

/// Nodes of a graph in the language of Graphviz, from which it is put together.
template <class Nodes>
std::string dot_of(const Nodes& nodes, const AspectGraph& graph) {
  std::string text = "graph aspects {\n";
  for (std::size_t i = 0; i < graph.sets.size(); ++i) {
    text += "  subgraph cluster_" + std::to_string(i + 1) + " {\n    label=\"set " + std::to_string(i + 1) +
            ", det A " + (graph.sets[i].determinant_sign > 0 ? "> 0" : "< 0") + "\";\n";
    for (const int id : graph.sets[i].aspects)
      text += "    " + std::to_string(id) + " [label=\"" + std::to_string(id) + "\\n" +
              to_string(nodes[static_cast<std::size_t>(id - 1)].mode) + "\"];\n";
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

}  // namespace

Report report_graph(const AspectMap& map, const AspectGraph& graph) {
  json object = json_graph(*map.manipulator(), graph, headline(map, graph));
  for (const Aspect& aspect : map.aspects()) object["aspects"].push_back(json_aspect(aspect, graph));
  for (std::size_t i = 0; i < graph.sets.size(); ++i) {
    object["sets"][i]["workspace_lower"] = graph.sets[i].workspace_lower;
    object["sets"][i]["unit"] = map.unit();
  }
  const Report constraints = report_constraints(*map.manipulator());
  object.update(constraints.json);
  return {object, map.manipulator()->name() + ": " + headline(map, graph) + "\n\n" + tables_text(map, graph) +
                      constraints.text};
}

Report report_graph(const PoseRoadmap& roadmap, const RoadmapGraph& found) {
  const Manipulator& robot = *roadmap.certifier().manipulator();
  json object = json_graph(robot, found.graph, headline(roadmap, found));
  for (const RoadmapPart& part : found.parts) object["aspects"].push_back(json_part(part, found.graph));
  object["samples"] = roadmap.poses().size();
  object["seed"] = roadmap.options().seed;
  const Report constraints = report_constraints(robot);
  object.update(constraints.json);
  return {object, robot.name() + ": " + headline(roadmap, found) + "\na certified roadmap of " +
                      counted(roadmap.poses().size(), "sampled pose") + ", seed " +
                      std::to_string(roadmap.options().seed) + "\n\n" + sets_text(found) + '\n' +
                      gates_text(found.graph) + open_text(found) + '\n' + constraints.text};
}

std::string graph_as_dot(const AspectMap& map, const AspectGraph& graph) {
  return dot_of(map.aspects(), graph);
}

std::string graph_as_dot(const RoadmapGraph& found) { return dot_of(found.parts, found.graph); }

}  // namespace parallel_aspects::tools
