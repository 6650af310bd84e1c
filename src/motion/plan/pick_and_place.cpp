// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/pick_and_place.h"

#include "motion/roadmap.h"
#include "parallel_aspects/aspects/connectivity.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/singularity/indices.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int max_halvings = 12;     // of a segment
constexpr int tries_at_a_gate = 24;  // from the beginning of the segment that ends there, halfway to it each

class CornerBuilder {
 public:
  CornerBuilder(const PathPlanner& planner, const Manipulator& manipulator, const PlannedPath& path,
                std::vector<JointVector>& corners)
      : planner_(planner), robot_(manipulator), path_(path), corners_(corners) {}

  bool run() {
    if (path_.points.empty()) return false;
    const PathPoint& first = path_.points.front();
    at_ = {first.pose, first.q};
    if (corners_.empty()) corners_.push_back(at_.q);
    std::size_t i = 0;
    for (const PathCrossing& crossing : path_.crossings) {
      if (crossing.point < i + 1) return false;
      if (!go(i, crossing.point - 1) || !cross(crossing.point)) return false;
      i = crossing.point + 2;
    }
    return go(i, path_.points.size() - 1);
  }

 private:
  const PathPoint& point(std::size_t i) const { return path_.points[i]; }

  bool go(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      if (!follow(point(i).pose, point(i + 1).pose, point(i).mode, 0.0, 1.0, max_halvings)) return false;
    return true;
  }

  /// From where the path is, at `begin` of a segment, to `end` of it.
  bool follow(const Pose& from, const Pose& to, const WorkingMode& mode, double begin, double end,
              int halvings) {
    const Place next = place(planner_.between(from, to, end), mode);
    if (move(next)) return true;
    if (halvings == 0) return false;
    const double middle = 0.5 * (begin + end);
    return follow(from, to, mode, begin, middle, halvings - 1) &&
           follow(from, to, mode, middle, end, halvings - 1);
  }

  /// The point before the crossing and the one behind it are as near to the gate as can be proved; the
  /// segment to the one is that from the other. The robot passes in one motion, from as far as that is
  /// certified.
  bool cross(std::size_t last_before) {
    const PathPoint &outer = point(last_before - 1), &inner = point(last_before),
                    &behind = point(last_before + 1);
    double share = 0.0;  // of the segment towards the gate
    for (int i = 0; i < tries_at_a_gate; ++i, share += 0.5 * (1.0 - share)) {
      const Pose pose = planner_.between(outer.pose, inner.pose, share);
      const Place before = place(pose, outer.mode), after = place(pose, behind.mode);
      if (!straight_motion_exists(robot_, before, joint_change(robot_, before.q, after.q), pose)) continue;
      return follow(outer.pose, inner.pose, outer.mode, 0.0, share, max_halvings) && move(after) &&
             follow(pose, outer.pose, behind.mode, 0.0, 1.0, max_halvings);
    }
    return false;
  }

  bool move(const Place& next) {
    const JointVector change = joint_change(robot_, at_.q, next.q);
    if (!(change.norm() > 0.0)) return true;
    if (!straight_motion_exists(robot_, at_, change, next.pose)) return false;
    corners_.push_back(corners_.back() + change);
    at_ = next;
    return true;
  }

  Place place(const Pose& pose, const WorkingMode& mode) const {
    return {pose, inverse(robot_, pose, mode).q};
  }

  const PathPlanner& planner_;
  const Manipulator& robot_;
  const PlannedPath& path_;
  std::vector<JointVector>& corners_;
  Place at_;
};

}  // namespace

bool append_joint_corners(const PathPlanner& planner, const Manipulator& manipulator, const PlannedPath& path,
                          std::vector<JointVector>& corners) {
  return CornerBuilder(planner, manipulator, path, corners).run();
}

namespace {

constexpr std::size_t max_leaves = 20000;  // examined in one aspect

PickAndPlace none(std::string reason) {
  PickAndPlace result;
  result.reason = "No pick and place: " + std::move(reason);
  return result;
}

PickAndPlace cancelled() { return none("none was found in time."); }

/// A task, and the paths to it and back.
struct Candidate {
  PickAndPlace task;
  PlannedPath approach, back;

  bool is_complete() const { return approach && task.carry && back; }

  double least_index() const {
    return std::min({approach.least_index, task.carry.least_index, back.least_index});
  }
};

class Planner {
 public:
  Planner(const std::shared_ptr<const AspectMap>& map, const AcceptsRound& accepts, const MapControl& control)
      : map_(*map), robot_(*map->manipulator()), paths_(map), accepts_(accepts), control_(control) {}

  PickAndPlace plan(const Pose& start, const WorkingMode& mode) {
    if (!straight_motions_are_allowed(robot_))
      return none("straight motions of actuated joints are not proved to keep the constraints.");
    const Location location = map_.locate(start, mode);
    if (location.status != LocationStatus::inside) return none("the map does not locate the start.");
    const AspectGraph* graph = paths_.graph(control_);
    if (graph == nullptr) return cancelled();
    const Aspect& home = aspect(location.aspect);
    std::vector<Candidate> candidates;
    for (const int other : graph->sets[graph->set_of(home.id)].aspects)
      if (other != home.id && !is_cancelled(control_)) add(start, home, aspect(other), candidates);
    if (is_cancelled(control_)) return cancelled();
    if (candidates.empty())
      return none("no serial gate leads from aspect " + std::to_string(home.id) +
                  " to a place that it does not hold.");
    return first_accepted(std::move(candidates));
  }

 private:
  const Aspect& aspect(int id) const { return map_.aspects()[static_cast<std::size_t>(id - 1)]; }

  void add(const Pose& start, const Aspect& home, const Aspect& other, std::vector<Candidate>& candidates) {
    const std::optional<Pose> place = place_in(other, home);
    if (!place) return;
    const PathEnd begin{start, home.mode}, from{home.deepest, home.mode}, to{*place, other.mode};
    const PlannedPath within = paths_.plan(from, {*place, home.mode}, PathPolicy::stay);
    if (within.answer != SameAspect::no) return;
    Candidate candidate{{home.deepest, *place, paths_.plan(from, to, PathPolicy::serial, control_), {}, {}},
                        paths_.plan(begin, from, PathPolicy::stay),
                        paths_.plan(to, begin, PathPolicy::serial, control_)};
    if (!candidate.is_complete()) return;
    const Location there = map_.locate(*place, home.mode);
    candidate.task.reason =
        reason(candidate.task, home, there ? apart(home, aspect(there.aspect)) : within.message);
    candidates.push_back(std::move(candidate));
  }

  PickAndPlace first_accepted(std::vector<Candidate> candidates) const {
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.least_index() > b.least_index();
    });
    for (Candidate& each : candidates) {
      each.task.joint_values = corners({&each.approach, &each.task.carry, &each.back});
      if (each.task && accepts_(each.task.joint_values)) return std::move(each.task);
    }
    return none("every one that was planned comes too close to a singularity to be followed.");
  }

  bool may_hold(const Aspect& aspect, const Pose& pose) const {
    const Location found = map_.locate(pose, aspect.mode);
    if (!found) return found.status != LocationStatus::outside;
    const std::vector<int>& unresolved = aspect.unresolved_with;
    return found.aspect == aspect.id ||
           std::find(unresolved.begin(), unresolved.end(), found.aspect) != unresolved.end();
  }

  /// A pose of one aspect, far from singularities, that another aspect is not known to hold.
  std::optional<Pose> place_in(const Aspect& other, const Aspect& home) const {
    std::optional<Pose> best;
    std::pair<double, double> largest{0.0, 0.0};  // measure and index
    const std::size_t stride = 1 + other.inside_leaves / max_leaves;
    std::size_t leaf = 0;
    map_.visit_inside_poses(other.id, [&](const Pose& pose, double measure) {
      if (leaf++ % stride != 0 || measure < largest.first) return;
      if (may_hold(home, pose)) return;
      const InverseSolution solution = inverse(robot_, pose, other.mode);
      if (solution.status != InverseStatus::solved) return;
      const std::pair<double, double> here{measure, parallel_index(robot_, pose, solution.q)};
      if (!(here > largest)) return;
      largest = here;
      best = pose;
    });
    return best;
  }

  /// Of paths one behind the other; nothing where one is missing or not certified.
  std::vector<JointVector> corners(const std::vector<const PlannedPath*>& paths) const {
    std::vector<JointVector> all;
    for (const PlannedPath* path : paths) {
      if (!*path || !append_joint_corners(paths_, robot_, *path, all)) return {};
    }
    return all;
  }

  static std::string apart(const Aspect& home, const Aspect& there) {
    return "Proved: in this working mode the place is in aspect " + std::to_string(there.id) +
           (there.determinant_sign == home.determinant_sign ? ", which singularities part from it."
                                                            : ", where det A has the other sign.");
  }

  std::string reason(const PickAndPlace& task, const Aspect& home, const std::string& why) const {
    const TaskSpace space = robot_.task_space();
    std::string text = "Pick at " + to_string(space, task.pick) + " and place at " +
                       to_string(space, task.place) + ". Aspect " + std::to_string(home.id) + " " +
                       to_string(home.mode) + " cannot do it. " + why;
    for (const PathCrossing& crossing : task.carry.crossings)
      text += " The path goes from aspect " + std::to_string(crossing.from) + " to aspect " +
              std::to_string(crossing.to) + " " + to_string(aspect(crossing.to).mode) +
              " through a gate at " + to_string(space, task.carry.points[crossing.point].pose) +
              ", where the leg of '" + robot_.leg(crossing.leg).actuated_joint + "' changes its posture.";
    return text;
  }

  const AspectMap& map_;
  const Manipulator& robot_;
  PathPlanner paths_;
  const AcceptsRound& accepts_;
  const MapControl& control_;
};

}  // namespace

PickAndPlace plan_pick_and_place(const std::shared_ptr<const AspectMap>& map, const Pose& start,
                                 const WorkingMode& mode, const AcceptsRound& accepts,
                                 const MapControl& control) {
  return Planner(map, accepts, control).plan(start, mode);
}

}  // namespace parallel_aspects
