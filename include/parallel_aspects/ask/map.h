// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_MAP_H
#define PARALLEL_ASPECTS_ASK_MAP_H

#include "parallel_aspects/ask/connect.h"
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

/// The fields of a basin.
template <class Visit>
void describe(Visit& visit, const Basin& basin) {
  const int deeper = static_cast<int>(basin.deeper.value_or(0));
  visit({"aspect", "", "id"}, basin.aspect);
  visit({"deepest_index", "", "`lower` and `upper` bound of the largest index in it"}, basin.depth);
  visit({"deepest_pose", "", "where the index is no less than the lower one"}, basin.deepest);
  visit(
      {"deeper", "",
       "place in the list, from 0, of the deeper basin that it is joined to first as the margin falls; null "
       "for the deepest"},
      ask::only_if(basin.deeper.has_value(), deeper));
  visit({"saddle", "",
         "`lower` and `upper` bound of the largest index that a path to that basin can keep; null for the "
         "deepest"},
        ask::only_if(basin.deeper.has_value(), basin.saddle));
}

/// The fields of what symmetries saved.
template <class Visit>
void describe(Visit& visit, const SymmetryUse& symmetry) {
  visit({"motions", "", "what becomes of a point of the base in each, as \"(x, -y)\""}, symmetry.motions);
  visit({"computed_modes", "", "working modes whose components are not images of others"},
        static_cast<int>(symmetry.computed_modes));
}

namespace ask {

/// The map of aspects.
struct MapQuestion {
  MapSource source{};                          ///< resolution and slice, and files
  std::vector<NamedRange> region{};            ///< of the free positions [m]; by default that of the session
  std::vector<WorkingMode> modes{};            ///< by default all
  std::optional<Count<0, 1024>> threads{};     ///< 0 for one a core
  std::optional<Count<0, 20>> extra_levels{};  ///< as of `MapOptions`
  RoadmapSource roadmap{};                     ///< of what is made in its place with six degrees of freedom
  std::optional<ParallelIndex> index{};        ///< by which depths are measured; nothing for none
  bool complete = false;                       ///< as of `MapOptions`
  bool no_symmetry = false;                    ///< likewise
  bool neighbours = false;                     ///< whether these are found, too
  bool persistence = false;                    ///< whether basins are
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, MapQuestion& question) {
  describe(visit, question.source);
  visit(
      {"region", "\"x=0:5 y=0:9\"",
       "Where to look: a lower and an upper end of every position that is free [m]; by default all that the "
       "legs reach"},
      question.region);
  visit({"mode", "\"(+,-)\"", "Map these working modes only, as signs of B_jj; by default every one"},
        question.modes);
  visit({"threads", "N", "Threads to compute with; by default one a core. The result does not depend on it"},
        question.threads);
  visit({"extra_levels", "N", "How often contested leaves may be halved below the resolution, by default 12"},
        question.extra_levels);
  describe(visit, question.roadmap);
  visit(
      {"index", "parallel|det_a",
       "By which index depths and bottlenecks are measured: parallel, |det A| over the norms of its rows, or "
       "det_a, |det A| itself"},
      question.index);
  visit({"neighbours", "", "List which aspects touch across a singularity, and where that is proved"},
        question.neighbours);
  visit({"no_symmetry", "", "Compute what symmetries of the robot show to be the same, too"},
        question.no_symmetry);
  visit(
      {"complete", "",
       "Prove that no small aspects hide, if possible, in many times the time; needed with three degrees of "
       "freedom and for fine maps with two"},
      question.complete);
  visit({"persistence", "", "List the basins of each aspect: which parts of it a larger margin separates"},
        question.persistence);
}

/// An aspect, as faces write it.
struct MappedAspect {
  Aspect aspect;                            ///< as of `AspectMap`
  std::string unit;                         ///< of measures
  std::vector<NamedRange> bounds;           ///< of its inside leaves
  std::string color;                        ///< in every picture of the map
  std::optional<IndexRange> deepest_index;  ///< where measured
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const MappedAspect& answer) {
  const Aspect& aspect = answer.aspect;
  visit({"id", "", "from 1: by working mode, then positive before negative det A, then falling measure"},
        aspect.id);
  visit({"working_mode", "", "signs of B_jj"}, aspect.mode);
  visit({"determinant_sign", "", "of det A, 1 or -1"}, aspect.determinant_sign);
  visit({"measure", "", "best estimate of the volume of its workspace projection, in `unit`"},
        aspect.measure);
  visit({"measure_lower", "", "proved: from the inside boxes"}, aspect.measure_lower);
  visit({"measure_upper", "", "proved: with every undecided box that could belong to it"},
        aspect.measure_upper);
  visit({"unit", "", "`m`, `m^2`, `m^2 rad`, `m^3`, `rad^3`; of slices also `rad`, `m rad` and `rad^2`"},
        answer.unit);
  visit({"inside_leaves", "", "number of boxes that prove it"}, static_cast<int>(aspect.inside_leaves));
  visit({"bounding_box", "", "of these boxes; empty in SO3"}, answer.bounds);
  visit({"deepest_pose", "", "center of the largest ball found in them"}, aspect.deepest);
  visit({"deepest_clearance", "",
         "radius of that ball: no singularity or limit is closer (within the slice, where one is mapped) [m, "
         "with rotations of SE2 weighted by the characteristic length; rad in SO3; where a joint is held, "
         "positions count as the anchor of its leg moves]"},
        aspect.deepest_clearance);
  visit({"color", "", "`#rrggbb`, in every picture of this map"}, answer.color);
  visit({"deepest_index", "",
         "`lower` and `upper` bound of the largest index in it, proved; null unless measured"},
        answer.deepest_index);
  visit({"unresolved_with", "",
         "ids that could be the same aspect; empty when it is proved separate from all others"},
        aspect.unresolved_with);
}

/// Two aspects that could be one.
struct PairBottleneck {
  std::vector<int> aspects;  ///< the two ids
  IndexRange bottleneck;     ///< the largest index that a path between them can keep
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const PairBottleneck& answer) {
  visit({"aspects", "", "the two ids"}, answer.aspects);
  visit(
      {"bottleneck", "", "`lower` and `upper` bound of the largest index that a path between them can keep"},
      answer.bottleneck);
}

/// Samples of a roadmap in one working mode with one sign of det A.
struct SampledSide {
  WorkingMode mode;                          ///< signs of B_jj
  int determinant_sign = 1;                  ///< of det A
  std::size_t samples = 0;                   ///< proved to lie on it
  std::vector<std::size_t> component_sizes;  ///< of these, by component, falling
  std::vector<double> largest_indices;       ///< the largest parallel index of a sample, likewise

  double largest_share() const;  ///< of the samples, of the largest component
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const SampledSide& side) {
  visit({"working_mode", "", "signs of B_jj"}, side.mode);
  visit({"determinant_sign", "", "of det A"}, side.determinant_sign);
  visit({"samples", "", "poses that are proved to lie on it"}, side.samples);
  visit({"component_sizes", "", "poses in each set that is proved connected, falling"}, side.component_sizes);
  visit({"largest_indices", "", "of each such set, the largest parallel index of its samples"},
        side.largest_indices);
  visit({"largest_share", "", "of its poses in the largest set"}, side.largest_share());
}

/// What there is in place of a map, with six degrees of freedom.
struct SampledAspects {
  std::shared_ptr<const PoseRoadmap> roadmap;  ///< null in an answer of no meaning alone
  std::vector<SampledSide> sides;              ///< of it
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const SampledAspects& sampled) {
  const PoseRoadmap* const roadmap = sampled.roadmap.get();
  visit({"samples", "", "poses that were drawn"}, roadmap ? roadmap->poses().size() : 0);
  visit({"seed", "", "that they were drawn with"}, roadmap ? roadmap->options().seed : 0U);
  visit({"seconds", "s", "of the computation"}, roadmap ? roadmap->seconds() : 0.0);
  visit({"proved_count", "",
         "lower bound of the number of generalized aspects, proved: as many as there are `sides`"},
        roadmap ? roadmap->proved_count() : 0);
  visit({"components_at_most", "", "upper bound of the number of aspects that the samples lie in, proved"},
        roadmap ? roadmap->component_count() : 0);
  visit({"sides", "", "one for each working mode and sign of det A that holds a sample, as follows"},
        sampled.sides);
}

/// The map.
struct MapAnswer {
  std::shared_ptr<const AspectMap> map;               ///< null in an answer of no meaning alone
  TaskSpace task_space = TaskSpace::T2;               ///< of the robot
  std::optional<MapSlice> slice;                      ///< of the map
  std::vector<NamedRange> region;                     ///< what was searched
  double resolution = 0.0;                            ///< as of `AspectMap`
  double seconds = 0.0;                               ///< likewise, as what is below
  std::optional<SymmetryUse> symmetry;                ///< nothing where it was loaded
  std::string unit;                                   ///< of measures
  std::vector<WorkingMode> working_modes;             ///< those that have aspects
  std::vector<MappedAspect> aspects;                  ///< by id
  int proved_count = 0;                               ///< lower bound
  std::optional<int> count_at_most;                   ///< upper bound
  bool cut_by_region = false;                         ///< whether the region may cut aspects
  bool loaded = false;                                ///< whether it is that of a file
  int indeterminate_leaves = 0;                       ///< where further aspects could hide
  std::vector<std::vector<int>> unresolved;           ///< pairs of ids
  double measure_undecided = 0.0;                     ///< over all working modes
  NamedValues margins;                                ///< of the robot
  double tolerance = 0.0;                             ///< likewise [m]
  std::string no_aspect;                              ///< why there is none, with what to change; else empty
  std::optional<MapBasins> basins;                    ///< where measured
  std::optional<std::vector<Neighbours>> neighbours;  ///< where asked for
  std::optional<LegIndex> neighbours_not_across;      ///< whose joint is held
  std::optional<SampledAspects> sampled;              ///< in place of all but the task space

  std::optional<std::vector<PairBottleneck>> bottlenecks() const;  ///< of `unresolved`, in that order
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const MapAnswer& answer) {
  const bool has_basins = answer.basins && !answer.basins->basins.empty();
  visit({"task_space", "", "`T1`, `T2`, `SE2`, `T3`, `SO3`, `SE3`, `R1` or `R2`"}, answer.task_space);
  if (answer.sampled) return describe(visit, *answer.sampled);
  visit({"slice", "",
         "`held`: coordinates or the joint with their values, `free`: names of the others, `axis`: in the "
         "base, "
         "that a free angle turns about, or null; null where all poses are mapped"},
        answer.slice);
  visit({"region", "",
         "box that was searched, by free coordinate; by default it encloses every reachable pose; empty in "
         "SO3, "
         "where every orientation is searched"},
        answer.region);
  visit({"resolution", "m or rad", "longest edge of a leaf of the base map; at most what was asked for"},
        answer.resolution);
  visit({"seconds", "s",
         "time that the computation of the map took, also where it is loaded; depths and bottlenecks come on "
         "top, and so does what else is asked for, as {neighbours}"},
        answer.seconds);
  visit({"loaded", "", "whether the map comes from the file of {load}"}, answer.loaded);
  visit(
      {"symmetry", "",
       "what symmetries of the robot saved: `motions`, what becomes of a point of the base in each of those "
       "used, as `\"(x, -y)\"`, and `computed_modes`, the number of working modes whose components are not "
       "images of others; null where the map was loaded"},
      answer.symmetry);
  visit({"working_modes", "", "those in which at least one pose is proved singularity-free"},
        answer.working_modes);
  visit({"unit", "", "of all measures"}, answer.unit);
  visit({"aspects", "", "as follows"}, answer.aspects);
  visit({"proved_count", "",
         "lower bound of the number of generalized aspects, proved; of their parts in the region where "
         "`cut_by_region`"},
        answer.proved_count);
  visit({"cut_by_region", "",
         "whether the region may leave out poses that legs reach: then an aspect that it cuts may be counted "
         "as "
         "several"},
        answer.cut_by_region);
  visit({"count_at_most", "",
         "upper bound of the number of aspects that have a pose in the region, proved; null while there are "
         "indeterminate leaves"},
        answer.count_at_most);
  visit({"indeterminate_leaves", "",
         "undecided leaves, by mode and sign, where aspects that are not listed could hide"},
        answer.indeterminate_leaves);
  visit({"inside_components", "", "number of entries of `aspects`"}, static_cast<int>(answer.aspects.size()));
  visit({"unresolved", "", "pairs of ids that are neither joined nor proved separate"}, answer.unresolved);
  visit({"measure_undecided", "", "volume over all working modes where the map decides nothing, in `unit`"},
        answer.measure_undecided);
  visit({"margins", "", "those that the map was computed with, by name; empty without any"}, answer.margins);
  visit({"tolerance", "m", "of the points and lengths of the robots that it holds for; 0 without one"},
        answer.tolerance);
  visit({"no_aspect", "", "where there is none: why, with what to change; else null"},
        only_if(!answer.no_aspect.empty(), answer.no_aspect));
  visit({"index", "", "by which depths are measured: `parallel` or `det_a`; null unless measured"},
        answer.basins ? std::make_optional(answer.basins->index) : std::nullopt);
  visit({"bottlenecks", "", "of each pair of `unresolved`, as follows; null unless measured"},
        answer.bottlenecks());
  visit({"basins", "", "with {persistence}: as follows; else null"},
        has_basins ? std::make_optional(answer.basins->basins) : std::nullopt);
  visit({"neighbours", "", "with {neighbours}: as the `gates` of `graph`; else null"}, answer.neighbours);
  visit({"neighbours_not_across", "",
         "the leg whose joint is held, across whose B_jj = 0 no neighbours are searched; else null"},
        answer.neighbours_not_across);
}

/// Computes it, or takes it from a file. With six degrees of freedom there are maps of slices alone, and a
/// roadmap of all poses.
Outcome<MapAnswer> answer(Session& session, const MapQuestion& question, const Control& control = {});

/// What a map says by itself.
MapAnswer answer_of(std::shared_ptr<const AspectMap> map);
/// What a roadmap does.
MapAnswer answer_of(std::shared_ptr<const PoseRoadmap> roadmap);

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
