// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ask/plan.h"

#include "ask/question_parts.h"
#include "aspects/tree/held_joint_example.h"
#include "model/message_text.h"
#include "motion/choose/plan_around_cusp.h"
#include "motion/plan/end_aspects.h"
#include "parallel_aspects/aspects/uniqueness.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects::ask {

std::string between_points(const PlanAnswer& answer) {
  if (answer.turns_hinges) return "angles run evenly, the short way";
  return answer.slice && answer.slice->joint
             ? "the direction of the held anchor from the base, and phi, run straight"
             : "positions run straight; quaternions straight and normalised, the short way";
}

namespace {

Problem wrong(ProblemKind kind, std::string fault, std::string remedy) {
  return {kind, "around_cusp", "{around_cusp} " + std::move(fault), std::move(remedy)};
}

/// Cusps are points in slices of SE2 alone, of one robot.
void check_slice(const Manipulator& robot, const std::optional<MapSlice>& slice, ProblemList& problems) {
  if (robot.task_space() != TaskSpace::SE2)
    return problems.push_back(wrong(ProblemKind::robot,
                                    "is of robots that move in SE2, and '" + given(robot.name()) +
                                        "' moves in " + std::string(name(robot.task_space())),
                                    "leave it out"));
  const std::string example = given(example_of_held_joint(robot));
  if (example.empty())
    return problems.push_back(
        wrong(ProblemKind::robot,
              "needs an actuated joint that can be held, and '" + given(robot.name()) + "' has none",
              "leave it out"));
  if (!slice || !slice->joint)
    return problems.push_back(wrong(ProblemKind::together,
                                    "needs a slice that holds an actuated joint, where cusps are points",
                                    "give {slice} with its value at the start, such as " + example));
  UniquenessOptions options;
  options.slice = slice;
  if (const std::string why = find_uniqueness_problem(robot, options); !why.empty())
    problems.push_back(told(why));
}

/// "; there are 6: 1 at 14.98 15.4 17.9; 2 at ...".
std::string list_of(const Manipulator& robot, const CuspList& list) {
  std::string text = "there are " + std::to_string(list.cusps.size());
  for (std::size_t k = 0; k < list.cusps.size(); ++k) {
    text += (k == 0 ? ": " : "; ") + std::to_string(k + 1) + " at";
    for (std::size_t j = 0; j < robot.leg_count(); ++j)
      text += " " + number_text(list.cusps[k].actuated[static_cast<Eigen::Index>(j)]);
  }
  return text;
}

/// What keeps a question from being one of a change of the assembly mode around a cusp: such a path is in one
/// aspect of a slice that holds an actuated joint, and ends at the actuated values of its start.
void check_cusp(const Manipulator& robot, const PlanQuestion& question, const std::optional<MapSlice>& slice,
                ProblemList& problems) {
  check_slice(robot, slice, problems);
  const EndQuestion& goal = question.goal;
  if (goal.pose || goal.mode || goal.joints || goal.aspect || goal.tracked)
    problems.push_back(wrong(ProblemKind::together, "ends at the actuated values of the start",
                             "leave out what says where the path ends"));
  const bool has_wish =
      question.prefer != PathPreference::quick && question.prefer != PathPreference::shortest;
  if (question.policy != PathPolicy::stay || has_wish)
    problems.push_back(wrong(ProblemKind::together, "stays in one aspect, on a clear path",
                             "leave out {policy} and {prefer}"));
}

/// Plans it; there is no problem of the kind above.
void plan_around(Session& session, const PlanQuestion& question, PathEnd from, const Control& control,
                 PlanAnswer& answer, ProblemList& problems) {
  const Manipulator& robot = *session.robot();
  CuspList cusps = find_cusps(robot, *answer.slice->joint, control.begin("Looking for cusps."));
  const std::size_t cusp = question.around_cusp->value - 1;
  if (control.is_over()) return;
  if (cusp >= cusps.cusps.size())
    problems.push_back(wrong(ProblemKind::value,
                             "is " + std::to_string(cusp + 1) + ", but with " + to_string(*answer.slice) +
                                 " " + list_of(robot, cusps),
                             "give the number of one of these"));
  const FoundMap found = problems.empty() ? session.map(question.map, {}, control, problems) : FoundMap{};
  if (!found.map) return;
  place_in_aspect("start", *found.map, question.start, from, problems);
  if (!problems.empty()) return;
  const MapControl looking = control.begin("Looking for a path around the cusp.");
  const auto planner = std::make_shared<CuspPlanner>(found.map, std::move(cusps.cusps));
  answer.map = found.map;
  answer.loaded = found.loaded;
  answer.path = planner->plan(from, cusp, looking);
  answer.between = [planner](const Pose& a, const Pose& b, double t) { return planner->between(a, b, t); };
  answer.turns_around_cusps = planner->turns_around_cusps(answer.path);
  if (answer.path)
    answer.encoder_noise = planner->followed_noise(answer.path);
  else
    answer.other_start = planner->find_start(cusp, looking);
}

/// One question on its way to an answer: what is found is added to the answer, what is wrong to the problems.
class Planning {
 public:
  Planning(Session& session, const PlanQuestion& question, const Control& control)
      : session_(session), question_(question), control_(control) {}

  Outcome<PlanAnswer> run() {
    check();
    if (problems_.empty()) plan();
    if (problems_.empty() && !control_.is_over()) time();
    return outcome_of(std::move(problems_), control_, std::move(answer_));
  }

 private:
  const Manipulator& robot() const { return *session_.robot(); }

  // With six degrees of freedom there is no map but a roadmap; it is quicker elsewhere as well, and knows
  // less.
  bool has_map() const {
    return answer_.slice || session_.known_map() ||
           (robot().task_space() != TaskSpace::SE3 && !asks_roadmap());
  }
  bool asks_roadmap() const { return !question_.roadmap.is_default(); }

  // Before anything starts.
  void check() {
    answer_.between = between_poses(robot().motions());
    answer_.turns_hinges = robot().task_space() == TaskSpace::R2;
    answer_.policy = question_.policy;
    answer_.prefer = question_.prefer;
    answer_.around_cusp = question_.around_cusp;
    answer_.slice = session_.slice_of(question_.map);
    from_ = path_end("start", robot(), question_.start, problems_);
    if (question_.around_cusp)
      check_cusp(robot(), question_, answer_.slice, problems_);
    else
      to_ = path_end("goal", robot(), question_.goal, problems_);
    has_map() ? check_map() : check_roadmap();
    check_timing();
    if (problems_.empty() && answer_.slice) put_ends_onto_slice();
  }

  void put_ends_onto_slice() {
    double moved = 0.0;
    if (!question_.start.aspect)
      moved = put_onto_slice(*answer_.slice, robot(), "start", from_.pose, problems_);
    if (!question_.goal.aspect && !question_.around_cusp)
      moved = std::max(moved, put_onto_slice(*answer_.slice, robot(), "goal", to_.pose, problems_));
    answer_.moved_onto_slice = moved;
  }

  void check_map() {
    if (asks_roadmap())
      problems_.push_back({ProblemKind::together, "samples",
                           "{samples} and {seed} are for roadmaps, and a map is asked here",
                           "leave them out"});
  }

  void check_roadmap() {
    const bool is_needed = robot().task_space() == TaskSpace::SE3;
    const std::string none = is_needed ? "in SE3 there is none" : "{samples} and {seed} ask a roadmap";
    if (question_.policy == PathPolicy::any)
      problems_.push_back(
          {ProblemKind::robot, "policy", "{policy} any needs a map, and " + none,
           is_needed ? "give {policy} serial, or {slice}" : "leave {samples} and {seed} out"});
    if (!question_.map.is_default())
      problems_.push_back({ProblemKind::robot, "load",
                           "{resolution}, {load} and {save} are for maps, and " + none, "leave them out"});
    if (question_.start.aspect || question_.goal.aspect)
      problems_.push_back({ProblemKind::robot, "start_aspect",
                           "{start_aspect} and {goal_aspect} are for maps, and " + none, "give poses"});
  }

  void check_timing() {
    if (question_.acceleration && !(question_.acceleration->array() > 0.0).all())
      return problems_.push_back({ProblemKind::value, "acceleration",
                                  "{acceleration} has a number that is not positive",
                                  "give positive numbers"});
    const bool is_fast = question_.prefer == PathPreference::fast;
    const std::string needed_by = is_fast ? "{prefer} fast" : question_.timed_for;
    const bool has_values = question_.acceleration || session_.acceleration().values.size() > 0;
    acceleration_ = question_.acceleration.value_or(session_.acceleration().values);
    if (question_.policy == PathPolicy::any && !needed_by.empty())
      problems_.push_back({ProblemKind::together, "policy",
                           needed_by +
                               " needs a platform that is under control all the way, and {policy} any may "
                               "pass det A = 0",
                           "give {policy} serial"});
    const Problems missing = problems_of(robot(), acceleration_);
    is_timed_ = missing.empty();
    if (is_timed_ || (needed_by.empty() && !question_.acceleration)) return;
    const std::string& otherwise = session_.acceleration().otherwise;
    if (!has_values)
      return problems_.push_back(
          {ProblemKind::together, "acceleration", needed_by + " needs acceleration limits",
           session_.acceleration().remedy + (otherwise.empty() ? "" : ", or " + otherwise)});
    for (const std::string& each : missing)
      problems_.push_back(told(each + (otherwise.empty() ? "" : " Or " + otherwise + ".")));
  }

  void plan() {
    if (question_.around_cusp) return plan_around(session_, question_, from_, control_, answer_, problems_);
    const bool has_aspect = question_.start.aspect || question_.goal.aspect;
    if (!has_aspect && question_.map.save.empty())
      if (auto none = excluded_end(*session_.certifier(), from_, to_)) {
        answer_.path = std::move(*none);
        return;
      }
    has_map() ? plan_in_map() : plan_over_roadmap();
  }

  /// With what tells how long a path takes, where that counts.
  PathWish wish(const MapControl& control) const {
    PathWish wish{question_.policy, question_.prefer, {}};
    if (wish.prefer == PathPreference::fast)
      wish.time = path_timer(*session_.certifier(), answer_.between, acceleration_, control);
    return wish;
  }

  void plan_in_map() {
    const FoundMap found = session_.map(question_.map, {}, control_, problems_);
    if (!found.map) return;
    place_in_aspect("start", *found.map, question_.start, from_, problems_);
    place_in_aspect("goal", *found.map, question_.goal, to_, problems_);
    if (!problems_.empty()) return;
    answer_.map = found.map;
    answer_.loaded = found.loaded;
    const auto planner = session_.planner(found.map);
    answer_.between = [planner](const Pose& a, const Pose& b, double t) { return planner->between(a, b, t); };
    const MapControl control = control_.begin("Looking for gates and a path.");
    answer_.path = planner->plan(from_, to_, wish(control), control);
  }

  void plan_over_roadmap() {
    std::vector<WorkingMode> modes;
    for (const std::optional<WorkingMode>& mode : {from_.mode, to_.mode})
      if (mode && std::find(modes.begin(), modes.end(), *mode) == modes.end()) modes.push_back(*mode);
    const auto roadmap = session_.roadmap(question_.roadmap.options(std::move(modes)), control_, problems_);
    if (!roadmap) return;
    const MapControl control = control_.begin("Looking for gates and a path.");
    answer_.path = plan_in_roadmap(*roadmap, from_, to_, wish(control), control);
  }

  void time() {
    note_turns();
    if (is_timed_ && answer_.path)
      answer_.timed = time_path(*session_.certifier(), answer_.path, answer_.between, acceleration_,
                                control_.begin("Timing the path."));
  }

  // Which actuated joints arrive whole turns from the values that were asked for.
  void note_turns() {
    if (!to_.q || !answer_.path) return;
    for (std::size_t j = 0; j < robot().leg_count(); ++j) {
      const Leg& leg = robot().leg(j);
      const double value = answer_.path.points.back().q[static_cast<Eigen::Index>(j)],
                   asked = (*to_.q)[static_cast<Eigen::Index>(j)];
      if (leg.actuated_by_angle() && std::abs(value - asked) > EIGEN_PI)
        answer_.remarks.push_back("'" + given(leg.actuated_joint) + "' arrives at " + number_text(value) +
                                  ", whole turns from what {goal_joints} says.");
    }
  }

  Session& session_;
  const PlanQuestion& question_;
  const Control& control_;
  PathEnd from_, to_;
  JointVector acceleration_;
  bool is_timed_ = false;
  PlanAnswer answer_;
  ProblemList problems_;
};

}  // namespace

Outcome<PlanAnswer> answer(Session& session, const PlanQuestion& question, const Control& control) {
  return Planning(session, question, control).run();
}

}  // namespace parallel_aspects::ask
