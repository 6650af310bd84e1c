// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_CONNECT_H
#define PARALLEL_ASPECTS_ASK_CONNECT_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// All values, for whoever reads one by its name.
inline constexpr std::array<ParallelIndex, 2> choices(ParallelIndex /*tag*/) {
  return {ParallelIndex::normalised, ParallelIndex::determinant};
}

/// "inside", "undecided", "outside" or "not mapped".
inline const char* name(LocationStatus status) {
  return status == LocationStatus::inside      ? "inside"
         : status == LocationStatus::undecided ? "undecided"
         : status == LocationStatus::outside   ? "outside"
                                               : "not mapped";
}

/// The fields of a range of an index.
template <class Visit>
void describe(Visit& visit, const IndexRange& range) {
  visit({"lower", "", "proved"}, range.lower);
  visit({"upper", "", "proved"}, range.upper);
}

namespace ask {

/// Which configurations a pose, or values of the actuated joints, can be, and which aspects hold them.
struct LocateQuestion {
  std::optional<Pose> pose{};           ///< in the task frame
  std::optional<JointVector> joints{};  ///< in place of a pose; with both they are one configuration
  std::optional<WorkingMode> mode{};    ///< by default every one
  std::optional<Sign> sign{};           ///< of det A; by default both
  MapSource map{};                      ///< that is asked
  RoadmapSource roadmap{};              ///< in place of a map, with six degrees of freedom
  bool brief = false;                   ///< asks none but those that are known
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, LocateQuestion& question) {
  visit({"pose", "\"x y\"", "Pose of the platform; lengths [m]"}, question.pose);
  visit(
      {"joints", "\"q1 q2\"",
       "In place of a pose: values of the actuated joints, in the order of the legs [rad or m]; with a pose "
       "they are one configuration"},
      question.joints);
  visit({"mode", "\"(+,-)\"", "Working mode, as signs of B_jj; by default every one"}, question.mode);
  visit({"sign", "+", "Sign of det A, + or -; by default both"}, question.sign);
  describe(visit, question.map);
  describe(visit, question.roadmap);
}

/// A pose and joint values that assemble, and where that is.
struct LocatedConfiguration {
  Pose pose;                               ///< in the task frame
  JointVector q;                           ///< in the order of the legs [rad or m]
  std::optional<WorkingMode> mode;         ///< none where some B_jj is zero
  int determinant_sign = 0;                ///< 0 where det A is zero
  bool within_limits = true;               ///< of the actuated joints
  std::string missed_margins;              ///< as of `missed_margins`
  std::optional<Location> location;        ///< nothing where no map was asked
  std::optional<std::uint32_t> component;  ///< of the roadmap, from 0; nothing where none is proved
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const LocatedConfiguration& answer) {
  const bool is_inside = answer.location && *answer.location;
  visit({"pose", "", "of the platform"}, answer.pose);
  visit({"joints", "rad or m", "joint values in the order of the legs"}, answer.q);
  visit({"working_mode", "", "signs of B_jj; null where one is zero"}, answer.mode);
  visit({"determinant_sign", "", "of det A: 1, -1 or 0"}, answer.determinant_sign);
  visit({"within_limits", "", "whether the joint values are"}, answer.within_limits);
  visit({"missed_margins", "", "a sentence about each margin that it does not keep; null where it keeps all"},
        only_if(!answer.missed_margins.empty(), answer.missed_margins));
  visit({"status", "",
         "`inside` and `outside` of aspects are proved; `undecided`: nearer to a singularity or a limit than "
         "the map can decide; `not mapped`; null without a map"},
        answer.location ? std::make_optional(answer.location->status) : std::nullopt);
  visit({"aspect", "", "id of the aspect that is proved to hold it; else null"},
        is_inside ? std::make_optional(answer.location->aspect) : std::nullopt);
  visit({"component", "",
         "with six degrees of freedom: that of the roadmap which a segment is proved to join it to, from 1 "
         "among those of its working mode and sign of det A; else null"},
        answer.component ? std::make_optional(static_cast<int>(*answer.component) + 1) : std::nullopt);
}

/// The answer: configurations, and the aspects that hold them.
struct LocateAnswer {
  TaskSpace task_space = TaskSpace::T2;              ///< of the robot
  DirectStatus status = DirectStatus::solved;        ///< of joint values, as of `direct`
  std::string reason;                                ///< why there is none, a sentence; else empty
  std::vector<LocatedConfiguration> configurations;  ///< by working mode, or by falling det A
  std::optional<MapSlice> slice;                     ///< of the map
  std::optional<bool> loaded;                        ///< from the file; nothing where no map was asked
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const LocateAnswer& answer) {
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  visit({"status", "", "of joint values, as of `fk`"}, answer.status);
  visit({"reason", "", "why there are none, a message; else null"},
        only_if(!answer.reason.empty(), answer.reason));
  visit({"configurations", "", "those that are meant, as follows"}, answer.configurations);
  visit({"slice", "", "with {slice}: what is held and free, as for maps; else null"}, answer.slice);
  visit({"loaded", "", "whether the map is that of {load}; null without a map"}, answer.loaded);
}

/// Finds them. A map of all working modes is asked, so that ids are those of `aspects map`.
Outcome<LocateAnswer> answer(Session& session, const LocateQuestion& question, const Control& control = {});

/// Whether two poses lie in one aspect.
struct ConnectQuestion {
  std::optional<Pose> start{};                      ///< one of the two
  std::optional<Pose> goal{};                       ///< the other
  std::optional<WorkingMode> mode{};                ///< by default every one
  MapSource map{};                                  ///< that is asked last, or of the slice
  RoadmapSource roadmap{};                          ///< that is asked before the map
  ParallelIndex index = ParallelIndex::normalised;  ///< of bottlenecks
  bool brief = false;  ///< asks no map but one that is known, and searches for no bottleneck
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, ConnectQuestion& question) {
  visit({"start", "\"x y\"", "A pose of the platform; lengths [m]"}, question.start);
  visit({"goal", "\"x y\"", "Another one"}, question.goal);
  visit({"mode", "\"(+,-)\"", "Working mode, as signs of B_jj; by default every one"}, question.mode);
  visit({"slice", "\"phi=0\"",
         "Ask within a slice: held pose coordinates, or in SE2 an actuated joint, with the value [m or rad]; "
         "its map answers. Poses are (x, y, phi) whatever is held"},
        question.map.hold);
  visit({"samples", "N", "Poses of the roadmap that is asked where the straight way is not free"},
        question.roadmap.samples);
  visit({"seed", "N", "Seed of the roadmap"}, question.roadmap.seed);
  visit({"resolution", "R",
         "Resolution of the map that is asked last [m or rad]; by default one is made in T2 only"},
        question.map.resolution);
  visit({"load", "FILE", "Take the map from this file if it is of this robot and these options"},
        question.map.load);
  visit({"index", "parallel|det_a",
         "By which index bottlenecks are measured: parallel, |det A| over the norms of its rows, or det_a, "
         "|det A| itself; by default parallel"},
        question.index);
}

/// The largest index that a path can keep, and which index.
struct IndexBottleneck {
  ParallelIndex kind = ParallelIndex::normalised;  ///< by which
  Bottleneck found;                                ///< the largest
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const IndexBottleneck& bottleneck) {
  visit({"index", "", "`parallel` or `det_a`"}, bottleneck.kind);
  visit({"lower", "", "proved"}, bottleneck.found.index.lower);
  visit({"upper", "", "proved"}, bottleneck.found.index.upper);
}

/// What is known in one working mode.
struct ConnectionInMode {
  WorkingMode mode;                           ///< which
  AspectComparison comparison;                ///< as of `same_aspect`
  std::optional<PathClearance> clearance;     ///< of its path, where there is one; `time` counts segments
  std::optional<Pose> narrowest;              ///< of the path, where `clearance->measured` was measured
  std::optional<IndexBottleneck> bottleneck;  ///< where there is a map

  bool has_bottleneck() const noexcept {  ///< whether one is found
    return bottleneck && bottleneck->found.status == BottleneckStatus::found;
  }
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const ConnectionInMode& answer) {
  visit({"working_mode", "", "signs of B_jj"}, answer.mode);
  visit({"same_aspect", "", "`yes` and `no` are proved; `unknown`"}, answer.comparison.answer);
  visit({"reason", "", "a message"}, answer.comparison.message);
  visit(
      {"failing_constraint", "",
       "the constraint that is proved to fail at one of the two poses, where that is why the answer is `no`; "
       "else null"},
      answer.comparison.failing);
  visit(
      {"path", "",
       "with `yes`: poses from the first to the second; positions run straight from one to the next, "
       "quaternions straight and normalised, and each such segment is proved free; empty where the map gave "
       "the answer"},
      answer.comparison.path);
  visit({"clearance", "m",
         "proved: no singularity is nearer than this to any pose of the path; null without one"},
        answer.clearance ? std::make_optional(answer.clearance->lower) : std::nullopt);
  visit({"narrowest", "", "the pose of the path that was measured to be nearest to one; null without one"},
        answer.narrowest);
  visit(
      {"bottleneck", "",
       "the largest index that a path between the two can keep: `index` (`parallel` or `det_a`), `lower`, "
       "`upper`, proved; null without a map, or where the two are proved to lie in different aspects or not "
       "to lie in one"},
      answer.has_bottleneck() ? answer.bottleneck : std::nullopt);
}

/// Whether they do.
struct ConnectAnswer {
  TaskSpace task_space = TaskSpace::T2;    ///< of the robot
  Pose from;                               ///< as it was asked of, moved onto the slice
  Pose to;                                 ///< likewise
  std::vector<ConnectionInMode> answers;   ///< one a working mode
  std::optional<MapSlice> slice;           ///< nothing where all poses were meant
  std::optional<double> moved_onto_slice;  ///< the farther of the two [m]
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const ConnectAnswer& answer) {
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  visit({"from", "", "one of the two poses"}, answer.from);
  visit({"to", "", "the other"}, answer.to);
  visit({"answers", "", "one for each working mode, as follows"}, answer.answers);
  visit({"slice", "", "with {slice}: what is held and free, as for maps; else null"}, answer.slice);
  visit({"moved_onto_slice", "m", "by how much a pose was moved onto it at most; null without {slice}"},
        answer.moved_onto_slice);
}

/// Asks, until one knows: what is proved of the two poses, a roadmap, a map; in a slice its map alone.
Outcome<ConnectAnswer> answer(Session& session, const ConnectQuestion& question, const Control& control = {});

}  // namespace ask
}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_CONNECT_H
