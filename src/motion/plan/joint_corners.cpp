// SPDX-License-Identifier: BSD-3-Clause
#include "motion/plan/joint_corners.h"

#include "motion/roadmap.h"
#include "parallel_aspects/kinematics/inverse.h"

#include <algorithm>
#include <optional>

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

}  // namespace parallel_aspects
