// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASK_CHECK_H
#define PARALLEL_ASPECTS_ASK_CHECK_H

#include "parallel_aspects/ask/choose.h"
#include "parallel_aspects/ask/question.h"
#include "parallel_aspects/ask/session.h"
#include "parallel_aspects/motion/check_trajectory.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The fields of a singularity that is passed.
template <class Visit>
void describe(Visit& visit, const TrajectoryCrossing& crossing) {
  visit({"kind", "", "which"}, crossing.kind);
  visit({"leg", "", "whose, where it is of one"}, ask::leg_or_none(crossing.leg));
  visit({"after", "s", "later than this, proved"}, crossing.after);
  visit({"before", "s", "passed by this time, proved"}, crossing.before);
  visit({"working_mode", "", "that it goes on in"}, crossing.mode);
  visit({"determinant_sign", "", "that it goes on with"}, crossing.determinant_sign);
}

/// The fields of an index.
template <class Visit>
void describe(Visit& visit, const SampledLeast& least) {
  visit({"value", "", "the least of the samples"}, least.value);
  visit({"time", "s", "when"}, least.time);
  visit({"leg", "", "whose, where it is by leg"}, ask::leg_or_none(least.leg));
}

namespace ask {

/// What actuated joints may pass.
enum class CheckPolicy { stay, serial };
/// All values, for whoever reads one by its name.
inline constexpr std::array<CheckPolicy, 2> choices(CheckPolicy /*tag*/) {
  return {CheckPolicy::stay, CheckPolicy::serial};
}
/// "stay" or "serial".
inline const char* name(CheckPolicy policy) { return policy == CheckPolicy::stay ? "stay" : "serial"; }

/// Whether a trajectory is safe: of the platform or of the actuated joints, which each face reads in its own
/// way.
struct CheckQuestion {
  std::optional<std::vector<PoseWaypoint>> path{};         ///< of the platform
  std::optional<std::vector<JointWaypoint>> trajectory{};  ///< in place of it
  std::optional<WorkingMode> mode{};                       ///< of the path
  std::optional<Pose> start_pose{};                        ///< of the trajectory, about
  std::optional<Sign> start_sign{};                        ///< or the sign of det A there
  std::optional<CheckPolicy> policy{};                     ///< of the trajectory; by default stay
  std::optional<Count<1, 10000>> distances{};              ///< at how many times they are measured
  bool keep_samples = false;                               ///< whether the answer has them
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, CheckQuestion& question) {
  visit({"mode", "\"(+,-)\"", "Working mode of the poses, as signs of B_jj"}, question.mode);
  visit({"start_pose", "\"x y\"",
         "About where the platform is at the start, where actuated joints have several assembly modes"},
        question.start_pose);
  visit({"start_sign", "+", "Or the sign of det A there"}, question.start_sign);
  visit({"policy", "stay|serial",
         "Of joints. stay: every singularity is a violation, the default. serial: legs may pass B_jj = 0, as "
         "`plan` has them"},
        question.policy);
  visit(
      {"distances", "N", "Measure the distances to singularities and limits at so many times, for all three"},
      question.distances);
}

/// Whether all of it is there and goes together, whatever the waypoints are; else `answer` says why not.
bool is_whole(const CheckQuestion& question);

/// How fast an actuated joint is.
struct JointSpeed {
  std::string joint;    ///< its name
  FastestMotion speed;  ///< see there
  double limit = 0.0;   ///< infinite for none
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const JointSpeed& joint) {
  visit({"joint", "", "its name"}, joint.joint);
  visit({"fastest", "rad/s or m/s", "proved to be reached"}, joint.speed.value);
  visit({"never_faster", "rad/s or m/s", "proved"}, joint.speed.bound);
  visit({"time", "s", "about when it is as fast as that"}, joint.speed.time);
  visit({"limit", "rad/s or m/s", "of the URDF"}, joint.limit);
  visit({"exceeded", "", "`yes`, `no` or `unknown`"},
        std::string(joint.speed.value > joint.limit    ? "yes"
                    : joint.speed.bound <= joint.limit ? "no"
                                                       : "unknown"));
}

/// What is known of the trajectory.
struct CheckAnswer {
  TaskSpace task_space = TaskSpace::T2;    ///< of the robot
  TrajectoryCheck check;                   ///< what is proved
  double from = 0.0;                       ///< time of the first waypoint [s]
  std::vector<JointSpeed> speeds;          ///< of the check, by joint
  std::vector<SampleDistances> distances;  ///< of its samples, where asked for

  std::optional<NamedValues> least_distance() const;  ///< of these
};

/// Its fields.
template <class Visit>
void describe(Visit& visit, const CheckAnswer& answer) {
  const TrajectoryCheck& check = answer.check;
  visit({"task_space", "", "how the platform moves"}, answer.task_space);
  visit({"answer", "", "`yes`, `no` or `unknown`"}, check.answer);
  visit({"proved", "", "whether that is `yes` or `no`"}, check.answer != TrajectoryAnswer::unknown);
  visit({"reason", "", "a message"}, check.reason);
  visit({"free_until", "s", "proved free from the start to this time"}, check.free_until);
  visit({"first_violation", "",
         "with `no`: `kind` (`parallel_singularity`, `serial_singularity`, which a leg that cannot reach has "
         "passed, `actuated_limit` or `constraint`), `leg` and `constraint` where it is of one, and the "
         "bracket of its time: proved to be later than `after` and no later than `before` [s]"},
        check.violation);
  visit({"crossings", "",
         "the singularities that are passed, each with `kind`, `leg`, `after` and `before` as "
         "`first_violation`, and what the trajectory goes on in: `working_mode`, null where it is not "
         "followed further, and `determinant_sign`, 0 where it is not known"},
        check.crossings);
  visit({"checked_from", "s",
         "the time of the first waypoint; where it is later than 0, how the robot gets there is not checked, "
         "and the text says so"},
        answer.from);
  visit({"followed_until", "s", "proved: up to this time there is no crossing but within those brackets"},
        check.followed_until);
  visit({"not_followed", "", "why it is not followed to its end; else null"},
        only_if(!check.not_followed.empty(), check.not_followed));
  visit(
      {"least_distance", "m",
       "with {distances}: `parallel_distance`, `serial_distance` and `limit_distance`, proved at every time "
       "up to `free_until`; infinite, in JSON null, where there is no such boundary; else null"},
      answer.least_distance());
  visit({"least_index", "",
         "`parallel` and `serial`, each `value` and `time`, and the `leg`: the least of 200 samples or more "
         "up to `free_until`, not proved ([margins](../howto/constraints.md#margins-from-singularities) says "
         "which indices)"},
        std::vector<std::pair<std::string, SampledLeast>>{{"parallel", check.parallel_index},
                                                          {"serial", check.serial_index}});
  visit({"speeds", "",
         "of each actuated joint: `joint`, `fastest`, a speed that it is proved to reach up to `free_until` "
         "[rad/s or m/s], about at `time`, `never_faster`, proved (infinite, in JSON null, where it is not "
         "known), `limit` of the URDF (likewise for none), and whether it is `exceeded`: `yes`, `no` or "
         "`unknown`. The answer does not depend on them, but the exit code does: 3 where one is exceeded, 4 "
         "where that is not known"},
        answer.speeds);
}

/// Checks it.
Outcome<CheckAnswer> answer(Session& session, const CheckQuestion& question, const Control& control = {});

}  // namespace ask
}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASK_CHECK_H
