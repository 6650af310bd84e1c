// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_DISTANCE_H
#define PARALLEL_ASPECTS_ASK_DISTANCE_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/model/pose.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects::ask {

/// How far singularities and limits are from a pose.
struct DistanceQuestion {
  std::optional<Pose> pose{};                   ///< in the task frame
  std::optional<WorkingMode> mode{};            ///< by default every one
  std::optional<double> tolerance{};            ///< relative gap between the bounds that is aimed at
  std::optional<Count<1, 10'000'000>> boxes{};  ///< that one search may evaluate
  MapSource map{};                              ///< that is asked, too; by default what the session knows

  DistanceOptions options() const;  ///< those of a meter
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, DistanceQuestion& question) {
  visit({"pose", "\"x y\"", "The pose of the platform; lengths [m]"}, question.pose);
  visit({"mode", "\"(+,-)\"", "Working mode, as signs of B_jj; by default every one"}, question.mode);
  visit({"tolerance", "T", "Relative gap between the bounds that is aimed at, by default 0.01"},
        question.tolerance);
  visit({"boxes", "N", "Boxes that one search may evaluate, by default 400; more are tighter"},
        question.boxes);
  visit({"map", "FILE", "Ask this map, too, for tighter bounds: as `aspects map --save` wrote it"},
        question.map.load);
  visit({"resolution", "R", "Of that map [m or rad], or of one that is computed, without {map}"},
        question.map.resolution);
}

/// The distance to one kind of boundary, with what is at fault there.
struct DistanceTo {
  BoundaryDistance distance;        ///< as of the meter
  std::optional<LegIndex> leg{};    ///< at fault; not of parallel singularities
  std::optional<LimitEnd> limit{};  ///< which of its limits; of limits alone

  bool has_witness() const noexcept { return std::isfinite(distance.upper); }  ///< whether one was found
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const DistanceTo& answer) {
  const BoundaryDistance& distance = answer.distance;
  const bool is_found = answer.has_witness();
  visit({"status", "",
         "`tight`, `loose`, `no witness`, `absent` (proved: there is none), `touching`, or `unavailable`, "
         "where nothing is known"},
        distance.status);
  visit({"lower", "m", "proved: no such pose is closer; infinite, in JSON null, where absent"},
        distance.lower);
  visit({"upper", "m", "distance of the witness; likewise where there is none"}, distance.upper);
  visit({"upper_proved", "", "whether that is proved too"}, distance.upper_proved);
  visit({"boxes", "", "that were evaluated"}, distance.boxes);
  visit({"leg", "", "at fault, of `serial` and `actuated_limit`; else null"}, answer.leg);
  visit({"limit", "", "`lower` or `upper`, of `actuated_limit`; else null"}, answer.limit);
  visit({"witness", "", "the nearest pose that was found; null, as the rest, where there is none"},
        only_if(is_found, distance.witness));
  visit({"witness_joints", "rad or m", "values of the actuated joints there"},
        only_if(is_found, distance.witness_q));
  visit({"direction", "rad and m, a metre", "twist (w, v) with which the path there starts, a metre of it"},
        only_if(is_found, distance.direction));
  visit({"joint_displacement", "rad or m", "of each actuated joint, from here to the witness"},
        only_if(is_found, distance.joint_displacement));
}

/// What is measured in one working mode.
struct DistancesInMode {
  WorkingMode mode;             ///< which
  BoundaryDistances distances;  ///< as of the meter
  std::string missed_margins;   ///< as of `missed_margins`, of a pose that is reached

  bool is_reached() const noexcept;  ///< whether there are joint values, so that distances were measured

  DistanceTo parallel() const { return {distances.parallel}; }  ///< singularities
  DistanceTo serial() const;                                    ///< likewise
  DistanceTo actuated_limit() const;                            ///< of some actuated joint
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const DistancesInMode& answer) {
  visit({"working_mode", "", "signs of B_jj"}, answer.mode);
  visit(
      {"status", "", "`measured`, `outside limits`, `at a serial singularity`, `out of reach` or `invalid`"},
      answer.distances.status);
  visit({"joints", "rad or m", "values of the actuated joints; null where nothing is measured"},
        only_if(answer.is_reached(), answer.distances.q));
  visit({"missed_margins", "",
         "a sentence about each margin that the configuration does not keep; null where it keeps all"},
        only_if(!answer.missed_margins.empty(), answer.missed_margins));
  visit({"parallel", "", "the distance to det A = 0, as follows"}, answer.parallel());
  visit({"serial", "", "to B_jj = 0 of some leg, likewise"}, answer.serial());
  visit({"actuated_limit", "", "to a limit of some actuated joint, likewise"}, answer.actuated_limit());
}

/// How far they are.
struct DistanceAnswer {
  TaskSpace task_space = TaskSpace::T2;  ///< of the robot
  Pose pose;                             ///< as asked
  std::vector<DistancesInMode> answers;  ///< one a working mode
  std::optional<bool> loaded;            ///< whether a file had the map; nothing where none was named
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const DistanceAnswer& answer) {
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  visit({"pose", "", "as asked"}, answer.pose);
  visit({"answers", "", "one for each working mode, as follows"}, answer.answers);
  visit({"loaded", "",
         "whether {map} had the map, which else is computed; null without {map} and {resolution}"},
        answer.loaded);
}

/// Measures them. A `BoundaryDistanceMeter` does without a session, and without taking memory each time.
Outcome<DistanceAnswer> answer(Session& session, const DistanceQuestion& question,
                               const Control& control = {});

}  // namespace parallel_aspects::ask

#endif  // PARALLEL_ASPECTS_ASK_DISTANCE_H
