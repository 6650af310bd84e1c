// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_MAP_H
#define PARALLEL_ASPECTS_ASK_MAP_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/pose_roadmap.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The fields of a place to cross.
template <class Visit>
void describe(Visit& visit, const GateCrossing& crossing) {
  visit({"pose", "", "in the middle of the segment"}, crossing.pose);
  visit({"index", "",
         "the smallest of the indices of other singularities where it begins, and of the distances of the "
         "actuated joints from their limits over half of their ranges"},
        crossing.index);
  visit({"segment", "", "poses through it"}, crossing.segment);
}

/// The fields of two aspects that touch.
template <class Visit>
void describe(Visit& visit, const Neighbours& gate) {
  visit({"aspects", "", "the two ids"}, std::vector<int>{gate.first, gate.second});
  visit({"crossing", "", "`serial`: B_jj = 0 of one leg, or `parallel`: det A = 0"}, gate.crossing);
  visit({"leg", "", "whose B_jj is zero, where serial; else null"},
        ask::only_if(gate.crossing == Crossing::serial, ask::LegIndex{gate.leg}));
  visit({"proved", "", "whether a path across is proved; else they come close to each other"}, gate.proved);
  visit({"pose", "", "near which they touch"}, gate.pose);
  visit({"crossings", "", "where proved, up to six places to cross it, the best first, as follows"},
        gate.crossings);
}

namespace ask {

/// Which aspects are joined through gates, and which are proved apart.
struct GraphQuestion {
  MapSource map{};          ///< whose aspects they are
  RoadmapSource roadmap{};  ///< in place of a map, with six degrees of freedom
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, GraphQuestion& question) {
  describe(visit, question.map);
  describe(visit, question.roadmap);
}

/// An aspect of a map, or a part of a roadmap.
struct GraphNode {
  int id = 0;                     ///< from 1
  WorkingMode mode;               ///< signs of B_jj
  int determinant_sign = 0;       ///< of det A
  std::optional<double> measure;  ///< of an aspect
  std::optional<int> samples;     ///< of a part
  int set = 0;                    ///< that holds it, from 1
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const GraphNode& answer) {
  visit({"id", "", "as of `map`; with six degrees of freedom that of a component of the roadmap"}, answer.id);
  visit({"working_mode", "", "signs of B_jj"}, answer.mode);
  visit({"determinant_sign", "", "of det A"}, answer.determinant_sign);
  visit({"measure", "", "as of `map`; null with six degrees of freedom"}, answer.measure);
  visit({"samples", "", "with six degrees of freedom: poses of it; else null"}, answer.samples);
  visit({"set", "", "number of the set that holds it"}, answer.set);
}

/// Aspects that gates are proved to join.
struct JoinedAspects {
  int set = 0;                             ///< from 1
  AspectSet joined;                        ///< as of `compute_aspect_graph`
  std::optional<double> workspace_lower;   ///< nothing with six degrees of freedom
  std::optional<std::string> unit;         ///< likewise
  std::vector<int> not_proved_apart_from;  ///< numbers of sets
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const JoinedAspects& answer) {
  visit({"set", "", "its number, from 1"}, answer.set);
  visit({"aspects", "", "the ids"}, answer.joined.aspects);
  visit({"determinant_sign", "", "of det A, of all of them"}, answer.joined.determinant_sign);
  visit(
      {"workspace_lower", "",
       "volume of the poses that are proved to lie in one of them or more; null with six degrees of freedom"},
      answer.workspace_lower);
  visit({"unit", "", "of that volume; likewise"}, answer.unit);
  visit({"not_proved_apart_from", "", "numbers of sets that could be the same"},
        answer.not_proved_apart_from);
}

/// How they are joined.
struct GraphAnswer {
  std::vector<GraphNode> aspects;              ///< by id
  std::vector<JoinedAspects> sets;             ///< by their lowest id
  std::shared_ptr<const AspectGraph> graph;    ///< never null in an answer
  std::string reason;                          ///< what is found, a clause
  std::optional<MapSlice> slice;               ///< of the map
  std::shared_ptr<const AspectMap> map;        ///< null with six degrees of freedom
  std::shared_ptr<const PoseRoadmap> roadmap;  ///< in place of it
  bool loaded = false;                         ///< from the file
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const GraphAnswer& answer) {
  const PoseRoadmap* roadmap = answer.roadmap.get();
  visit({"slice", "", "with {slice}: what is held and free, as for maps; else null"}, answer.slice);
  visit({"aspects", "", "one for each, as follows; with six degrees of freedom components of a roadmap"},
        answer.aspects);
  visit({"gates", "", "between them, as follows"},
        answer.graph ? answer.graph->gates : std::vector<Neighbours>());
  visit({"sets", "", "of aspects that gates are proved to join, as follows"}, answer.sets);
  visit({"proved_set_count", "", "lower bound of the number of different sets, proved"},
        answer.graph ? static_cast<int>(answer.graph->proved_set_count) : 0);
  visit({"reason", "", "what is found, a message"}, answer.reason);
  visit({"samples", "", "with six degrees of freedom: poses of the roadmap; else null"},
        roadmap ? std::make_optional(static_cast<int>(roadmap->poses().size())) : std::nullopt);
  visit({"seed", "", "likewise"},
        roadmap ? std::make_optional(static_cast<int>(roadmap->options().seed)) : std::nullopt);
  visit({"loaded", "", "whether the map is that of {load}"}, answer.loaded);
}

/// Looks for gates.
Outcome<GraphAnswer> answer(Session& session, const GraphQuestion& question, const Control& control = {});

}  // namespace ask
}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_MAP_H
