// SPDX-License-Identifier: BSD-3-Clause
#include "ask/question_parts.h"
#include "model/message_text.h"
#include "parallel_aspects/ask/map.h"
#include "parallel_aspects/motion/plan_path.h"

#include <algorithm>
#include <utility>

namespace parallel_aspects::ask {
namespace {

/// What joins nodes to sets, or why nothing does.
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

std::string graph_reason(const AspectMap& map, const AspectGraph& graph) {
  if (!map.aspects().empty())
    return counted(map.aspects().size(), "aspect") + " in " + counted(graph.sets.size(), "set") + ", " +
           joints_text(*map.manipulator(), graph, "aspect") + apart_text(graph);
  const std::string where = map.slice() ? "the slice " + to_string(*map.slice()) : "the region of the map";
  return map.measure_undecided() > 0.0
             ? "no aspect is proved in " + where + ", of which " + number_text(map.measure_undecided()) +
                   " " + map.unit() + " are undecided, over all working modes"
             : "proved: " + where + " holds no part of an aspect";
}

std::string graph_reason(const PoseRoadmap& roadmap, const RoadmapGraph& found) {
  const Manipulator& robot = *roadmap.certifier().manipulator();
  return counted(found.parts.size(), "part") + " of at least " + counted(roadmap.proved_count(), "aspect") +
         ", in " + counted(found.graph.sets.size(), "set") + ", " + joints_text(robot, found.graph, "part") +
         apart_text(found.graph) + (found.graph.proved_set_count > 1 ? ", by the sign of det A" : "");
}

int number_of_set(const AspectGraph& graph, int id) { return static_cast<int>(graph.set_of(id)) + 1; }

std::vector<JoinedAspects> sets_of(const AspectGraph& graph, const AspectMap* map) {
  std::vector<JoinedAspects> sets;
  for (std::size_t i = 0; i < graph.sets.size(); ++i) {
    JoinedAspects& set = sets.emplace_back();
    set.set = static_cast<int>(i) + 1;
    set.joined = graph.sets[i];
    if (map != nullptr) set.workspace_lower = set.joined.workspace_lower;
    if (map != nullptr) set.unit = map->unit();
    for (std::size_t k = 0; k < graph.sets.size(); ++k)
      if (k != i && graph.set_group[k] == graph.set_group[i])
        set.not_proved_apart_from.push_back(static_cast<int>(k) + 1);
  }
  return sets;
}

void add_graph(const AspectMap& map, GraphAnswer& answer) {
  for (const Aspect& each : map.aspects())
    answer.aspects.push_back({each.id, each.mode, each.determinant_sign, each.measure, std::nullopt,
                              number_of_set(*answer.graph, each.id)});
  answer.reason = graph_reason(map, *answer.graph);
}

void add_graph(const PoseRoadmap& roadmap, const RoadmapGraph& found, GraphAnswer& answer) {
  answer.graph = std::make_shared<const AspectGraph>(found.graph);
  for (const RoadmapPart& each : found.parts)
    answer.aspects.push_back({each.id, each.mode, each.determinant_sign, std::nullopt,
                              static_cast<int>(each.samples), number_of_set(found.graph, each.id)});
  answer.reason = graph_reason(roadmap, found);
}

}  // namespace

Outcome<GraphAnswer> answer(Session& session, const GraphQuestion& question, const Control& control) {
  GraphAnswer found;
  ProblemList problems;
  found.slice = session.slice_of(question.map);
  const bool of_map = has_map(found.slice, *session.robot());
  check_sources(of_map, question.map, question.roadmap, problems);
  if (problems.empty() && of_map) {
    const FoundMap source = session.map(question.map, {}, control, problems);
    found.map = source.map;
    found.loaded = source.loaded;
    if (found.map) found.graph = compute_aspect_graph(*found.map, control.begin("Looking for gates."));
    if (found.graph) add_graph(*found.map, found);
  } else if (problems.empty()) {
    found.roadmap = session.roadmap(question.roadmap.options({}), control, problems);
    if (!found.roadmap) return outcome_of(std::move(problems), control, std::move(found));
    const auto graph = compute_roadmap_graph(*found.roadmap, control.begin("Looking for gates."));
    if (graph) add_graph(*found.roadmap, *graph, found);
  }
  if (found.graph) found.sets = sets_of(*found.graph, found.map.get());
  return outcome_of(std::move(problems), control, std::move(found));
}

}  // namespace parallel_aspects::ask
