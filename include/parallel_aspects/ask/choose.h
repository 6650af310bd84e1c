// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_CHOOSE_H
#define PARALLEL_ASPECTS_ASK_CHOOSE_H

#include "parallel_aspects/ask/connect.h"
#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/motion/choose_working_mode.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// All values, for whoever reads one by its name.
inline constexpr std::array<Preference, 3> choices(Preference /*tag*/) {
  return {Preference::clear, Preference::travel, Preference::fast};
}

/// "parallel_singularity", "serial_singularity", "actuated_limit", "constraint" or "none".
const char* name(Violation kind) noexcept;

/// The fields of the first violation of a trajectory.
template <class Visit>
void describe(Visit& visit, const TrajectoryViolation& violation) {
  visit({"kind", "", "what is violated"}, violation.kind);
  visit({"leg", "", "whose, where it is of one"}, ask::leg_or_none(violation.leg));
  visit({"constraint", "", "which, where it is of one"}, violation.constraint);
  visit({"after", "s", "proved free from the start to here"}, violation.after);
  visit({"before", "s", "proved to be violated here or earlier"}, violation.before);
}

/// The fields of a clearance.
template <class Visit>
void describe(Visit& visit, const PathClearance& clearance) {
  visit({"proved", "m", "no singularity is nearer to any pose of the path"}, clearance.lower);
  visit({"measured", "m", "the least that was measured"}, clearance.measured);
  visit({"time", "s", "of that pose"}, clearance.time);
  visit({"singularity", "", "`serial` or `parallel`"}, std::string(clearance.serial ? "serial" : "parallel"));
  visit({"leg", "", "whose, where serial"}, ask::only_if(clearance.serial, ask::LegIndex{clearance.leg}));
  visit({"measures", "", "poses that were measured"}, static_cast<int>(clearance.measures));
}

/// The fields of a working mode on a path.
template <class Visit>
void describe(Visit& visit, const ModeOnPath& mode) {
  const TrajectoryCheck& check = mode.check;
  const bool is_safe = check.answer == TrajectoryAnswer::safe;
  visit({"working_mode", "", "signs of B_jj"}, mode.mode);
  visit({"answer", "", "`yes`, `no` or `unknown`"}, check.answer);
  visit({"reason", "", "a message"}, check.reason);
  visit({"determinant_sign", "", "of det A at the start; 0 where not proved"}, mode.determinant_sign);
  visit({"aspect", "", "id of the one that holds the start; null where it is not known"},
        ask::only_if(mode.aspect > 0, mode.aspect));
  visit({"free_until", "s", "proved free from the start to here"}, check.free_until);
  visit({"first_violation", "", "as of `check`; null where there is none"}, check.violation);
  visit({"clearance", "",
         "where the path is safe: `proved` for all of it and the least that was `measured` [m], its `time` "
         "[s], "
         "the kind of `singularity` and its `leg`, and how many `measures` were made; else null"},
        mode.clearance);
  visit({"least_index", "", "the least sampled `parallel` and `serial` index up to `free_until`"},
        ask::NamedValues{{"parallel", check.parallel_index.value}, {"serial", check.serial_index.value}});
  visit({"travel", "rad or m", "where it is safe: of each actuated joint; else empty"}, mode.travel);
  visit({"total_travel", "rad or m", "its sum; null where it is not safe"},
        ask::only_if(is_safe, mode.total_travel()));
  visit({"least_time", "s", "at the velocity limits; null where it is not safe"},
        ask::only_if(is_safe, mode.least_time));
}

/// The fields of a working mode in a region.
template <class Visit>
void describe(Visit& visit, const ModeInRegion& mode) {
  visit({"working_mode", "", "signs of B_jj"}, mode.mode);
  visit({"answer", "", "`yes`, `no` or `unknown`"}, mode.answer);
  visit({"reason", "", "a message"}, mode.reason);
  visit({"determinant_sign", "", "of det A, where the answer is yes; else 0"}, mode.determinant_sign);
  visit(
      {"least_index", "",
       "where the answer is yes: `lower` and `upper`, proved bounds of the least parallel index; else null"},
      ask::only_if(mode.answer == TrajectoryAnswer::safe, mode.least_index));
  visit({"witnesses", "", "poses that refute it"}, mode.witnesses);
  visit({"undecided", "", "the share that is not proved"}, mode.undecided);
}

/// The fields of a piece of a path.
template <class Visit>
void describe(Visit& visit, const PathPiece& piece) {
  visit({"working_mode", "", "in which it is done"}, piece.mode);
  visit({"start", "s", "where it begins"}, piece.start);
  visit({"end", "s", "where it ends"}, piece.end);
}

/// The fields of a change of posture.
template <class Visit>
void describe(Visit& visit, const PostureChange& change) {
  visit({"time", "s", "where the path is left and gone on with"}, change.time);
  visit({"pose", "", "there"}, change.pose);
  visit({"singular_pose", "", "where B_jj = 0"}, change.singular);
  visit({"leg", "", "whose"}, ask::LegIndex{change.leg});
  visit({"from_mode", "", "working mode before"}, change.from);
  visit({"to_mode", "", "and after"}, change.to);
  visit({"detour", "m", "there and back"}, change.detour);
}

/// The fields of a path with changes of posture.
template <class Visit>
void describe(Visit& visit, const ChangingPath& path) {
  visit({"answer", "", "`yes`, `no` or `unknown`"}, path.answer);
  visit({"proved", "", "whether that is proved"}, path.answer != TrajectoryAnswer::unknown);
  visit({"reason", "", "a message"}, path.reason);
  visit({"pieces", "", "in one working mode each"}, path.pieces);
  visit({"changes", "", "of posture, between them"}, path.changes);
}

namespace ask {

/// In which working modes a tool path or a region of poses can be done.
struct ChooseQuestion {
  std::optional<std::vector<PoseWaypoint>> path{};  ///< which each face reads in its own way
  std::vector<NamedRange> region{};                 ///< in place of it
  std::optional<MapSlice> hold{};                   ///< of the region
  std::optional<Preference> prefer{};               ///< of a path; by default clear
  bool changes = false;                             ///< of a path
  bool brief = false;                               ///< asks no map but one that is known
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, ChooseQuestion& question) {
  visit(
      {"region", "\"x=-1:1 y=-1:1\"", "A box of poses: a lower and an upper end of each coordinate [m, rad]"},
      question.region);
  visit({"slice", "\"roll=0 pitch=0 yaw=0\"", "Pose coordinates that are held in the region [m or rad]"},
        question.hold);
  visit({"prefer", "clear",
         "Which working mode is best: clear, the farthest from singularities, which is the default; travel, "
         "the least travel of actuated joints; or fast"},
        question.prefer);
  visit({"changes", "", "Let the robot change its posture at serial singularities beside the path"},
        question.changes);
}

/// In which they can be done.
struct ChooseAnswer {
  TaskSpace task_space = TaskSpace::T2;        ///< of the robot
  std::optional<Preference> prefer;            ///< of a path: what is best
  std::optional<std::vector<NamedRange>> box;  ///< of a region: what was asked
  std::optional<MapSlice> slice;               ///< likewise
  PathChoice path;                             ///< where a path was asked of
  RegionChoice region;                         ///< where a region was
  std::optional<ChangingPath> with_changes;    ///< where asked for

  TrajectoryAnswer verdict() const noexcept { return box ? region.answer : path.answer; }   ///< of either
  const std::string& reason() const noexcept { return box ? region.reason : path.reason; }  ///< likewise

  /// Of a region: two poses that no path joins in any working mode, where found.
  std::optional<std::vector<Pose>> apart() const;
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const ChooseAnswer& answer) {
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  visit({"prefer", "", "of a path: what is best; else null"}, answer.prefer);
  visit({"region", "", "of a region: what was asked; else null"}, answer.box);
  visit({"slice", "", "with {slice}: what is held and free, as for maps; else null"}, answer.slice);
  visit({"answer", "", "`yes`, `no` or `unknown`"}, answer.verdict());
  visit({"proved", "", "whether that is a theorem"}, answer.verdict() != TrajectoryAnswer::unknown);
  visit({"reason", "", "a sentence"}, answer.reason());
  visit({"apart", "", "of a region: two poses that are joined in no working mode, where found; else null"},
        answer.apart());
  const Field modes{"modes", "", "every working mode, the best first, as follows"};
  answer.box ? visit(modes, answer.region.modes) : visit(modes, answer.path.modes);
  visit(
      {"with_changes", "",
       "with {changes}: `answer`, `proved`, `reason`; `pieces` with `working_mode`, `start` and `end` [s]; "
       "`changes` with `time` [s], `pose`, `singular_pose`, `leg`, `from_mode`, `to_mode` and `detour` [m]; "
       "else null"},
      answer.with_changes);
}

/// Chooses.
Outcome<ChooseAnswer> answer(Session& session, const ChooseQuestion& question, const Control& control = {});

}  // namespace ask
}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_CHOOSE_H
