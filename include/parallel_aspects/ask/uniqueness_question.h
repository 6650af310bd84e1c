// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_UNIQUENESS_QUESTION_H
#define PARALLEL_ASPECTS_ASK_UNIQUENESS_QUESTION_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/aspects/uniqueness.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace parallel_aspects::ask {

/// Which poses of an aspect have the same actuated values, and where direct solutions meet.
struct UniquenessQuestion {
  std::optional<HeldJoint> slice{};          ///< of SE2 or SO3
  std::optional<HeldRange> cusps_over{};     ///< of SE2: curves of cusps alone
  std::optional<double> resolution{};        ///< of the map of aspects
  RoadmapSource roadmap{};                   ///< of SO3 and SE3
  std::optional<Count<1, 1000000>> poses{};  ///< of it that are examined
  std::optional<std::size_t> most_cells{};   ///< as in `UniquenessOptions`
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, UniquenessQuestion& question) {
  visit({"slice", "\"strut_1_joint=15\"",
         "In SE2 and SO3: the actuated joint that is held, with its value [m or rad], in SO3 for cusps and "
         "numbers of solutions; without it, in SE2, all poses, where struts and slides have limits"},
        question.slice);
  visit({"cusps_over", "\"strut_1_joint=10:32\"",
         "In SE2: the curves that cusps form while this actuated joint is held at each value of the range "
         "[m or rad] in turn, by default within its limits; they alone are listed"},
        question.cusps_over);
  visit(
      {"resolution", "R",
       "Longest edge of an undecided leaf of the map of aspects [m or rad]; by default what suits the robot"},
      question.resolution);
  visit({"samples", "N", "In SO3 and SE3: poses of the certified roadmap, by default 1000"},
        question.roadmap.samples);
  visit({"seed", "N", "In SO3 and SE3: seed of its poses, by default 1"}, question.roadmap.seed);
  visit({"poses", "N",
         "In SO3 and SE3: configurations of the roadmap whose direct solutions are searched, by default "
         "1000; some milliseconds each"},
        question.poses);
}

/// An item of a result, with the result that it belongs to.
template <class Item, class Whole>
struct Part {
  const Whole* of;   ///< the result
  const Item* item;  ///< of it
};

/// Each of them; both must outlive the result.
template <class Item, class Whole>
std::vector<Part<Item, Whole>> parts(const Whole& of, const std::vector<Item>& items) {
  std::vector<Part<Item, Whole>> result;
  for (const Item& each : items) result.push_back({&of, &each});
  return result;
}

/// Index of the basic component that a basic region lies over; nothing where that is not proved, or where
/// basic components are of several working modes at once and a region lies over more than one.
std::optional<std::size_t> component_below(const Uniqueness& uniqueness, const BasicRegion& region);

/// Whether basic components are of several working modes at once.
bool are_of_all_modes(const Uniqueness& uniqueness);

template <class Visit>
void describe(Visit& visit, const Part<Aspect, AspectMap>& component) {
  const Aspect& aspect = *component.item;
  visit({"id", "", "from 1"}, aspect.id);
  visit({"working_mode", "", "signs of B_jj"}, aspect.mode);
  visit({"determinant_sign", "", "of det A"}, aspect.determinant_sign);
  visit({"measure", "", "best estimate of its size"}, aspect.measure);
  visit({"unit", "", "of that"}, component.of->unit());
  visit({"deepest", "", "pose in the middle of the largest ball that was found in it"}, aspect.deepest);
  visit({"unresolved_with", "", "ids of those that could be the same"}, aspect.unresolved_with);
}

template <class Visit>
void describe(Visit& visit, const Part<SolutionRegion, SolutionNumbers>& part) {
  const SolutionRegion& region = *part.item;
  visit({"working_mode", "", "whose solutions are counted; null for all"},
        only_if(region.mode.leg_count() > 0, region.mode));
  visit({"solutions", "", "how many the values have"}, region.solutions);
  visit({"measure", "", "best estimate; angles that are whole turns apart count once"}, region.measure);
  visit({"measure_lower", "", "proved"}, region.measure_lower);
  visit({"measure_upper", "", "proved"}, region.measure_upper);
  visit({"unit", "", "of these"}, part.of->region_unit);
}

template <class Visit>
void describe(Visit& visit, const Part<BasicComponent, SolutionNumbers>& part) {
  const BasicComponent& component = *part.item;
  visit({"working_mode", "", "as of `regions`"}, only_if(component.mode.leg_count() > 0, component.mode));
  visit({"actuated", "m or rad", "values in it"}, component.inside);
  visit({"solutions", "", "how many each has"}, component.solutions.size());
  visit({"poses", "", "all solutions of these values"}, component.solutions);
  visit({"components", "", "that hold them; 0 where the map cannot decide"}, component.aspects);
  visit({"measure", "", "best estimate"}, component.measure);
  visit({"measure_lower", "", "proved"}, component.measure_lower);
  visit({"unit", "", "of these"}, part.of->region_unit);
}

template <class Visit>
void describe(Visit& visit, const Part<BasicRegion, Uniqueness>& part) {
  const BasicRegion& region = *part.item;
  visit({"component", "", "that it is of; 0 where that is not known"}, region.aspect);
  visit({"pose", "", "one of it"}, region.pose);
  visit({"over", "", "those with the same number lie over one connected set of values"}, region.over);
  visit({"basic_component", "", "index of that below; null for none or several"},
        component_below(*part.of, region));
  visit({"actuated", "m or rad", "values of its pose"}, region.actuated);
  visit({"unique", "", "proved: no two of its poses have the same values"}, region.is_unique);
  visit({"measure_lower", "", "of the values for which that is proved"}, region.measure_lower);
  visit({"unit", "", "of that"}, part.of->region_unit);
}

template <class Visit>
void describe(Visit& visit, const Part<UniquenessDomain, Uniqueness>& part) {
  const UniquenessDomain& domain = *part.item;
  visit({"component", "", "that it is of"}, domain.aspect);
  visit({"whole_component", "", "whether it is all of it; then there is nothing else"}, domain.whole_aspect);
  if (domain.whole_aspect) return;
  visit({"basic_regions", "", "indices in that list, from 0"}, domain.basic_regions);
  visit({"measure_lower", "", "of its actuated values, proved"}, domain.measure_lower);
  visit({"unit", "", "of that"}, part.of->region_unit);
}

template <class Visit>
void describe_numbers(Visit& visit, const SolutionNumbers& numbers) {
  visit({"regions", "", "actuated values by their number of solutions, unless a leg has an actuated elbow"},
        parts(numbers, numbers.regions));
  visit({"measure_unknown", "", "where no number is proved, over all working modes; null for other robots"},
        only_if(numbers.has_regions, numbers.measure_unknown));
  visit({"basic_components", "", "connected sets of values with one number of solutions, the largest first"},
        parts(numbers, numbers.basic_components));
}

/// Cusps and numbers of solutions in SO3, with an actuated joint held.
struct CuspsInSlice {
  std::string joint;        ///< that is held
  HeldJoint held;           ///< and where
  CuspList found;           ///< all cusps
  SolutionNumbers numbers;  ///< of direct solutions
};

template <class Visit>
void describe(Visit& visit, const CuspsInSlice& answer) {
  visit({"slice", "", "`held`, the joint with its value"},
        std::vector<std::pair<std::string, NamedValues>>{{"held", {{answer.joint, answer.held.value}}}});
  visit({"cusps", "", "where three direct solutions meet, within limits"}, answer.found.cusps);
  visit({"cusps_complete", "", "whether it is proved that there are no others"}, answer.found.complete);
  visit({"undecided_curves", "", "whether bounds leave curves of poses; then `cusps_complete` is false"},
        answer.found.leaves_curves);
  describe_numbers(visit, answer.numbers);
}

/// Curves of cusps, over the value of the joint that is held.
struct CuspsOverJoint {
  std::string joint;  ///< that is held
  std::string unit;   ///< of its values
  CuspCurves found;   ///< all curves
};

template <class Visit>
void describe(Visit& visit, const CuspsOverJoint& answer) {
  visit({"held_joint", "", "whose values are examined"}, answer.joint);
  visit({"unit", "", "of these"}, answer.unit);
  visit({"lower", "", "lower end of its range"}, answer.found.range.lower);
  visit({"upper", "", "upper end"}, answer.found.range.upper);
  visit({"cusp_curves", "", "pieces of curves of cusps within limits, as follows"}, answer.found.curves);
  visit({"cusp_counts", "", "number of `cusps` of every slice between `lower` and `upper`, proved"},
        answer.found.counts);
  visit({"cusp_curves_complete", "", "whether it is proved that there are no other curves"},
        answer.found.complete);
  visit({"undecided", "", "else: values of the held joint, `lower` to `upper`, where there may be more"},
        answer.found.undecided);
}

/// What direct solutions the configurations of a roadmap have.
struct SurveyOfRoadmap {
  std::shared_ptr<const PoseRoadmap> roadmap;  ///< null in an answer of no meaning alone
  AssemblySurvey survey;                       ///< of it
};

/// How many `poses` have so many `solutions`.
inline auto list_of(const PosesBySolutions& counts) {
  std::vector<std::vector<std::pair<std::string, int>>> list;
  for (const auto& [solutions, poses] : counts)
    list.push_back({{"solutions", static_cast<int>(solutions)}, {"poses", static_cast<int>(poses)}});
  return list;
}

template <class Visit>
void describe(Visit& visit, const SurveyOfRoadmap& answer) {
  const AssemblySurvey& survey = answer.survey;
  visit({"samples", "", "of the roadmap"}, answer.roadmap ? answer.roadmap->poses().size() : 0);
  visit({"seed", "", "likewise"}, answer.roadmap ? answer.roadmap->options().seed : 0U);
  visit({"poses", "", "configurations of the roadmap whose actuated values were examined"}, survey.poses);
  visit({"possibly_incomplete", "", "those whose list of direct solutions may lack some"}, survey.incomplete);
  visit({"solutions", "", "how many `poses` have so many proved `solutions`, in whichever aspect"},
        list_of(survey.solutions));
  visit({"components", "", "of the roadmap, as follows"}, survey.components);
}

/// What is known.
struct UniquenessAnswer {
  TaskSpace task_space = TaskSpace::T2;  ///< of the robot
  /// Of all poses or of a slice (never null in an answer); in SO3 with a joint held; over a held joint; over
  /// a roadmap.
  std::variant<std::shared_ptr<const Uniqueness>, CuspsInSlice, CuspsOverJoint, SurveyOfRoadmap> found;
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const UniquenessAnswer& answer) {
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  if (const auto* uniqueness = std::get_if<0>(&answer.found)) return describe(visit, **uniqueness);
  if (const auto* cusps = std::get_if<1>(&answer.found)) return describe(visit, *cusps);
  if (const auto* curves = std::get_if<2>(&answer.found)) return describe(visit, *curves);
  describe(visit, std::get<3>(answer.found));
}

/// What is wrong with it, for this robot.
ProblemList problems_of(const Manipulator& robot, const UniquenessQuestion& question);

/// Finds it out; of all poses with the map that the session knows, if any.
Outcome<UniquenessAnswer> answer(Session& session, const UniquenessQuestion& question,
                                 const Control& control = {});

}  // namespace parallel_aspects::ask

namespace parallel_aspects {

/// Fields of a cusp.
template <class Visit>
void describe(Visit& visit, const Cusp& cusp) {
  visit({"actuated", "m or rad", "of all actuated joints, in their order"}, cusp.actuated);
  visit({"working_mode", "", "signs of B_jj"}, cusp.mode);
  visit({"pose", "", "where three solutions meet"}, cusp.pose);
  visit({"proved", "", "true"}, true);
  visit({"accuracy", "rad", "in both angles of the slice"}, cusp.accuracy);
  visit({"component", "", "whose paths can go around it, not proved; 0 where not known"}, cusp.aspect);
}

/// The fields of a node.
template <class Visit>
void describe(Visit& visit, const SolutionNode& node) {
  visit({"actuated", "m", "of all actuated joints, in their order"}, node.actuated);
  visit({"poses", "", "both"}, std::vector<Pose>(node.poses.begin(), node.poses.end()));
  visit({"proved", "", "true"}, true);
  visit({"accuracy", "rad", "as of `cusps`"}, node.accuracy);
}

/// The fields of a curve of cusps.
template <class Visit>
void describe(Visit& visit, const CuspCurve& curve) {
  visit({"proved", "", "true of all of it"}, true);
  visit({"closed", "", "whether it has no ends"}, curve.closed);
  visit({"points", "", "in turn, each in a box that holds a cusp of the curve"}, curve.points);
  visit({"events", "", "in turn: its ends unless it is closed, and what is between"}, curve.events);
}

/// Of what is along it.
template <class Visit>
void describe(Visit& visit, const CuspEvent& event) {
  visit({"kind", "", "what is there"}, event.kind);
  visit({"lower", "m or rad", "value of the held joint"}, event.lower);
  visit({"upper", "m or rad", "likewise"}, event.upper);
}

/// Of the slices between two values.
template <class Visit>
void describe(Visit& visit, const CuspCount& count) {
  visit({"lower", "m or rad", "value of the held joint"}, count.lower);
  visit({"upper", "m or rad", "likewise"}, count.upper);
  visit({"cusps", "", "of each slice between these"}, count.cusps);
}

/// The fields of a solution.
template <class Visit>
void describe(Visit& visit, const ProvedSolution& solution) {
  visit({"pose", "", "near the solution"}, solution.pose);
  visit({"radius", "m", "of the ball about it that holds exactly one"}, solution.radius);
}

/// The fields of a change of the assembly mode.
template <class Visit>
void describe(Visit& visit, const AssemblyChange& change) {
  visit({"actuated", "m or rad", "values of both"}, change.actuated);
  visit({"from", "", "a solution of these"}, change.from);
  visit({"to", "", "another"}, change.to);
  visit({"path", "", "poses from one to the other, each segment free of singularities"}, change.path);
  visit({"proved", "", "true"}, true);
}

/// The fields of a component of a roadmap.
template <class Visit>
void describe(Visit& visit, const ComponentSurvey& component) {
  visit({"working_mode", "", "signs of B_jj"}, component.mode);
  visit({"determinant_sign", "", "of det A"}, component.determinant_sign);
  visit({"component", "", "of that side of the roadmap, from 1"}, static_cast<int>(component.component + 1));
  visit({"samples", "", "of it"}, component.samples);
  visit({"poses", "", "how many of these were examined"}, component.poses);
  visit({"solutions_in_aspect", "", "likewise, proved to be in the same aspect"},
        ask::list_of(component.in_aspect));
  visit({"unknown", "", "solutions that may be in it as well"}, component.unknown);
  visit({"assembly_change", "", "a proof that its aspect is no uniqueness domain"}, component.change);
}

/// The fields of the answer for all poses, or for a slice.
template <class Visit>
void describe(Visit& visit, const Uniqueness& uniqueness) {
  const AspectMap* const map = uniqueness.map.get();
  visit({"slice", "", "as of `map`"}, map != nullptr ? map->slice() : std::nullopt);
  visit({"at_most_one_solution_a_sign", "", "whether each aspect is a uniqueness domain, by a theorem"},
        uniqueness.at_most_one_a_sign);
  visit({"components", "", "aspects, or components of the slice, as follows"},
        map != nullptr ? ask::parts(*map, map->aspects()) : std::vector<ask::Part<Aspect, AspectMap>>());
  visit({"cusps", "", "where three direct solutions meet, within limits"}, uniqueness.cusps);
  visit({"cusps_complete", "", "whether it is proved that there are no others"}, uniqueness.cusps_complete);
  visit({"nodes", "", "with three struts: pairs of singular poses of the same values, within limits"},
        uniqueness.nodes);
  visit({"nodes_complete", "", "whether it is proved that there are no others"}, uniqueness.nodes_complete);
  ask::describe_numbers(visit, uniqueness);
  visit({"basic_regions", "", "over each of these that is not tiny, those of each component"},
        ask::parts(uniqueness, uniqueness.basic_regions));
  visit({"uniqueness_domains", "", "sets of these that are as large as can be, as follows"},
        ask::parts(uniqueness, uniqueness.domains));
  visit({"uniqueness_domains_complete", "", "whether all of them are listed"}, uniqueness.domains_complete);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_UNIQUENESS_QUESTION_H
