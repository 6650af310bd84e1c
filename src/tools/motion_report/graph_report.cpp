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

std::string ids(const std::vector<int>& aspects) {
  std::string text;
  for (const int aspect : aspects) text += (text.empty() ? "" : " ") + std::to_string(aspect);
  return text;
}

std::string through(const Manipulator& robot, const Neighbours& gate) {
  return gate.crossing == Crossing::serial ? "B_jj = 0 of " + robot.leg(gate.leg).name : "det A = 0";
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

/// Nothing where there is nothing to list.
std::string tables_text(const AspectMap& map, const AspectGraph& graph) {
  return map.aspects().empty() ? ""
                               : sets_text(map, graph) + '\n' + gates_text(*map.manipulator(), graph) + '\n';
}

/// A line for each set: there may be hundreds of parts.
std::string sets_text(const ask::GraphAnswer& answer) {
  TextTable table({">set", "det A", ">parts", ">working modes", ">samples"});
  for (const ask::JoinedAspects& set : answer.sets) {
    std::set<std::size_t> modes;
    int samples = 0;
    for (const int id : set.joined.aspects) {
      const ask::GraphNode& part = answer.aspects[static_cast<std::size_t>(id - 1)];
      modes.insert(part.mode.index());
      samples += part.samples.value_or(0);
    }
    table.add({std::to_string(set.set), set.joined.determinant_sign > 0 ? "+" : "-",
               std::to_string(set.joined.aspects.size()), std::to_string(modes.size()),
               std::to_string(samples)});
  }
  return table.text();
}

std::string gates_text(const AspectGraph& graph) {
  return graph.gates.empty() ? ""
                             : counted(graph.gates.size(), "serial gate") +
                                   " between parts, each proved; --json lists them, --dot draws them\n";
}

/// What is not resolved.
std::string open_text(const AspectGraph& graph) {
  const std::size_t sets = graph.sets.size(), proved = graph.proved_set_count;
  return "Parts are poses that proved segments join; two may belong to one aspect, and aspects that no "
         "sample "
         "meets are not seen.\n" +
         (sets > proved
              ? "Whether the " + std::to_string(sets) + " sets are more than " + std::to_string(proved) +
                    " is not resolved: gates that were not found may join those of one sign.\n"
              : std::string()) +
         "Parallel gates are not searched.\n";
}

std::string roadmap_text(const ask::GraphAnswer& answer) {
  return "a certified roadmap of " + counted(answer.roadmap->poses().size(), "sampled pose") + ", seed " +
         std::to_string(answer.roadmap->options().seed) + "\n\n" + sets_text(answer) + '\n' +
         gates_text(*answer.graph) + open_text(*answer.graph) + '\n';
}

}  // namespace

Report report_graph(const Manipulator& robot, const ask::GraphAnswer& answer) {
  return constrained_report(
      robot, answer,
      robot.name() + ": " + answer.reason + "\n" +
          (answer.map ? '\n' + tables_text(*answer.map, *answer.graph) : roadmap_text(answer)));
}

std::string graph_as_dot(const ask::GraphAnswer& answer) {
  const AspectGraph& graph = *answer.graph;
  std::string text = "graph aspects {\n";
  for (std::size_t i = 0; i < graph.sets.size(); ++i) {
    text += "  subgraph cluster_" + std::to_string(i + 1) + " {\n    label=\"set " + std::to_string(i + 1) +
            ", det A " + (graph.sets[i].determinant_sign > 0 ? "> 0" : "< 0") + "\";\n";
    for (const int id : graph.sets[i].aspects)
      text += "    " + std::to_string(id) + " [label=\"" + std::to_string(id) + "\\n" +
              to_string(answer.aspects[static_cast<std::size_t>(id - 1)].mode) + "\"];\n";
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
