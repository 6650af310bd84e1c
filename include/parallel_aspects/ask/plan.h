// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_PLAN_H
#define PARALLEL_ASPECTS_ASK_PLAN_H

#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/motion/plan_path.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// All values, for whoever reads one by its name.
inline constexpr std::array<PathPolicy, 3> choices(PathPolicy /*tag*/) {
  return {PathPolicy::stay, PathPolicy::serial, PathPolicy::any};
}
/// All values, likewise.
inline constexpr std::array<PathPreference, 4> choices(PathPreference /*tag*/) {
  return {PathPreference::shortest, PathPreference::clear, PathPreference::fast, PathPreference::quick};
}

/// The fields of a point of a path.
template <class Visit>
void describe(Visit& visit, const PathPoint& point) {
  visit({"pose", "", "of the platform"}, point.pose);
  visit({"working_mode", "", "signs of B_jj"}, point.mode);
  visit({"actuated", "rad or m", "values of the actuated joints"}, point.q);
}

/// The fields of a start around a cusp.
template <class Visit>
void describe(Visit& visit, const CuspStart& start) {
  const PathPoint point = start.point.value_or(PathPoint());
  visit({"component", "", "that the cusp belongs to"}, start.aspect);
  visit({"pose", "", "null where none is found"}, ask::only_if(start.point.has_value(), point.pose));
  visit({"working_mode", "", "likewise"}, ask::only_if(start.point.has_value(), point.mode));
  visit({"actuated", "rad or m", "likewise"}, ask::only_if(start.point.has_value(), point.q));
}

/// The fields of a way from one aspect into another.
template <class Visit>
void describe(Visit& visit, const PathCrossing& crossing) {
  const bool serial = crossing.kind == Crossing::serial;
  visit({"after_point", "", "index of the point before it"}, static_cast<int>(crossing.point));
  visit({"before_point", "", "index of the point behind it"}, static_cast<int>(crossing.behind));
  visit({"crossing", "", "`serial` or `parallel`"}, crossing.kind);
  visit({"control_lost", "", "where parallel"}, !serial);
  visit({"leg", "", "null where parallel"}, ask::only_if(serial, ask::LegIndex{crossing.leg}));
  visit({"from_aspect", "", "null over a roadmap"}, ask::only_if(crossing.from != 0, crossing.from));
  visit({"to_aspect", "", "likewise"}, ask::only_if(crossing.to != 0, crossing.to));
}

namespace ask {

/// Where a path begins or ends.
struct EndQuestion {
  std::optional<Pose> pose{};         ///< in the task frame
  std::optional<WorkingMode> mode{};  ///< by default any
  std::optional<JointVector>
      joints{};  ///< in place of a pose, or with one, which chooses the nearest of several
  std::optional<Count<1, 1000000>>
      aspect{};                      ///< in place of both: the deepest pose of this aspect of the map
  std::optional<PathEnd> tracked{};  ///< in place of all: what belongs together, as a robot is followed
};

/// A path of the platform that is proved, or a proof that there is none.
struct PlanQuestion {
  EndQuestion start{};                            ///< where it begins
  EndQuestion goal{};                             ///< and ends
  PathPolicy policy = PathPolicy::stay;           ///< what it may pass
  PathPreference prefer = PathPreference::quick;  ///< which of several
  std::optional<Count<1, 10000>> around_cusp{};   ///< in place of a goal
  MapSource map{};                                ///< that is asked
  RoadmapSource roadmap{};                        ///< in place of a map

  /// Limits [rad/s^2 or m/s^2]; by default those of the session. The path is timed where they are known.
  std::optional<JointVector> acceleration{};
  std::string timed_for{};  ///< a clause: what needs the path in time, which is refused where there is none
};

/// Fields of an end.
template <class Visit>
void describe_end(Visit& visit, const std::string& name, EndQuestion& end) {
  const bool starts = name == "start";
  visit({name, "\"x y\"", starts ? "Where the path begins: a pose; lengths [m]" : "Where it ends, likewise"},
        end.pose);
  visit({name + "_mode", "\"(+,-)\"", "Working mode there, as signs of B_jj; by default any"}, end.mode);
  visit({name + "_joints", "\"q1 q2\"",
         "In place of a pose: values of the actuated joints, in the order of the legs [rad or m]; of several "
         "assembly modes the one next to {" +
             name + "}"},
        end.joints);
  visit({name + "_aspect", "ID", "In place of a pose: the deepest one of this aspect of the map"},
        end.aspect);
}

/// Its fields.
template <class Visit>
void describe(Visit& visit, PlanQuestion& question) {
  describe_end(visit, "start", question.start);
  describe_end(visit, "goal", question.goal);
  visit({"policy", "stay|serial|any",
         "stay: in one aspect, the default. serial: legs may change their posture on the way. any: through "
         "det A = 0 too, where control of the platform is lost; each such place is listed"},
        question.policy);
  visit({"prefer", "short|clear|fast|quick",
         "Which of several paths. short: the shortest that is found. clear: the one with the largest least "
         "parallel index. fast: the one that takes the least time. quick: a short one that is found soonest, "
         "the default"},
        question.prefer);
  visit({"around_cusp", "N",
         "In place of an end, with {slice}: around this cusp of those that `uniqueness` lists, back to the "
         "actuated values of the start in another assembly mode of its aspect"},
        question.around_cusp);
  describe(visit, question.map);
  visit({"samples", "N",
         "With six degrees of freedom, or in place of a map: poses of the roadmap, by default 1000"},
        question.roadmap.samples);
  visit({"seed", "N", "Likewise: seed of its poses, by default 1"}, question.roadmap.seed);
  visit({"acceleration", "\"10 10\"",
         "Acceleration limits of the actuated joints [rad/s^2 or m/s^2], with which the path is timed; by "
         "default those of motion.acceleration in the YAML, if any"},
        question.acceleration);
}

/// What is known of the path.
struct PlanAnswer {
  PathPolicy policy = PathPolicy::stay;                ///< as asked
  PathPreference prefer = PathPreference::quick;       ///< as asked
  PlannedPath path;                                    ///< or why there is none
  std::optional<MapSlice> slice;                       ///< that it stays in
  std::optional<double> moved_onto_slice;              ///< the farthest of the ends [m]
  std::shared_ptr<const AspectMap> map;                ///< null where no map was asked
  bool loaded = false;                                 ///< from the file
  bool turns_hinges = false;                           ///< whether poses are angles of passive joints
  PoseBetween between{};                               ///< how the pose runs from a point to the next
  std::optional<Count<1, 10000>> around_cusp;          ///< as asked
  std::optional<std::vector<int>> turns_around_cusps;  ///< by cusp, counter-clockwise
  std::optional<double> encoder_noise;                 ///< `CuspPlanner::followed_noise`
  CuspStart other_start;             ///< where to begin, where no path around the cusp is found
  std::vector<std::string> remarks;  ///< sentences for people, fields in braces
  std::optional<TimedPath> timed;    ///< where asked for and there is a path
};

/// How the pose runs from a point of a path to the next; what is proved is proved of this curve alone.
std::string between_points(const PlanAnswer& answer);

/// Its fields.
template <class Visit>
void describe(Visit& visit, const PlanAnswer& answer) {
  const bool has_path = static_cast<bool>(answer.path);
  visit({"policy", "", "`stay`, `serial` or `any`"}, answer.policy);
  visit({"prefer", "", "`quick`, `short`, `clear` or `fast`"}, answer.prefer);
  visit({"answer", "", "`yes`, `no` or `unknown`"}, answer.path.answer);
  visit({"proved", "", "whether that is proved, which yes and no are"},
        answer.path.answer != SameAspect::unknown);
  visit({"reason", "", "why, a sentence or more"}, answer.path.message);
  visit({"slice", "", "what {slice} holds, as of `connect`; null without it"}, answer.slice);
  visit(
      {"between_points", "",
       "how the pose runs from a point to the next, which is the curve that is proved: `phi` alone does not "
       "run evenly. Through det A = 0 it runs straight in the coordinates of the map"},
      between_points(answer));
  visit({"path", "",
         "points with `pose`, `working_mode` and the values of the `actuated` joints [rad or m], angles "
         "without jumps"},
        answer.path.points);
  visit(
      {"crossings", "",
       "`after_point` and `before_point` (index of the points before and behind it), `crossing` (`serial` or "
       "`parallel`), `control_lost` (where parallel), `leg` (null where parallel), `from_aspect` and "
       "`to_aspect` (null over a roadmap)"},
      answer.path.crossings);
  visit({"length", "m", "of the way of the operational point; null without a path"},
        only_if(has_path, answer.path.length));
  visit({"turned", "rad", "of the rotation of the platform; null without a path"},
        only_if(has_path, answer.path.turned));
  visit({"least_index", "", "smallest parallel index at 32 poses a segment, not proved; null without a path"},
        only_if(has_path, answer.path.least_index));
  visit({"least_det_a", "", "smallest determinant there, likewise"},
        only_if(has_path, answer.path.least_det_a));
  visit({"moved_onto_slice", "m", "how far an end was moved onto what {slice} says; null without it"},
        answer.moved_onto_slice);
  visit({"around_cusp", "", "the number of the cusp, where asked for; else null"}, answer.around_cusp);
  visit({"turns_around_cusps", "",
         "with {around_cusp}: how often the actuated values go around each cusp of the slice, "
         "counter-clockwise, seen at 32 poses a segment; else null"},
        answer.turns_around_cusps);
  visit(
      {"encoder_noise", "rad, or share of the robot's size",
       "of such a path: an estimate of the largest `tracking/encoder_noise` with which a tracker follows it; "
       "else null"},
      answer.encoder_noise);
  visit({"other_start", "",
         "with {around_cusp} and without a path: the `component` that the cusp belongs to and, where one is "
         "found, `pose`, `working_mode` and `actuated` of a start that has a path; else null"},
        only_if(answer.other_start.aspect != 0, answer.other_start));
  visit({"loaded", "", "whether the map is that of {load}; null where no map was asked"},
        only_if(answer.map != nullptr, answer.loaded));
  visit({"seconds", "s", "of the path in time; null where it is not timed"},
        answer.timed && *answer.timed ? std::make_optional(answer.timed->seconds) : std::nullopt);
  visit({"trajectory", "",
         "where the limits of the joints are known: `message` (what is proved of it, or why there is none), "
         "how many `waypoints`, `corners_rounded` and `stops`; else null"},
        answer.timed);
}

/// Answers it.
Outcome<PlanAnswer> answer(Session& session, const PlanQuestion& question, const Control& control = {});

}  // namespace ask
}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_PLAN_H
