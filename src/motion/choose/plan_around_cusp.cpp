// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/plan_around_cusp.h"

#include "model/angles.h"
#include "motion/plan/path_builder.h"
#include "parallel_aspects/aspects/held_joint.h"
#include "parallel_aspects/kinematics/direct.h"
#include "parallel_aspects/kinematics/inverse.h"
#include "parallel_aspects/kinematics/jacobians.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

constexpr int steps_of_a_loop = 32;

// Pairs of poses beside a cusp are looked for on circles about it [rad].
constexpr std::array<double, 6> circles{0.3, 0.15, 0.08, 0.04, 0.02, 0.01};
constexpr int points_of_a_circle = 180;

// Actuated values are the same to this share of the largest.
constexpr double same_values = 1e-6;

double difference_of(const JointVector& a, const JointVector& b) {
  return (a - b).cwiseAbs().maxCoeff() / std::max(1.0, a.cwiseAbs().maxCoeff());
}

/// The actuated values of a path that brings them back, in the plane of the two joints that are not held.
class ActuatedLoop {
 public:
  ActuatedLoop(const AspectMap& map, const PlannedPath& path, const PathBuilder::Between& between)
      : robot_(*map.manipulator()), legs_(free_legs(map.slice()->joint->leg)) {
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
      for (int step = 0; step < steps_of_a_loop; ++step) {
        const PathPoint &from = path.points[i], &to = path.points[i + 1];
        const double t = static_cast<double>(step) / steps_of_a_loop;
        const Vector2d next = plane_of(inverse(robot_, between(from.pose, to.pose, t), from.mode).q);
        values_.push_back(values_.empty() ? next : near(values_.back(), next));
      }
  }

  /// Counter-clockwise; around these values of angles in every turn.
  int turns_around(const JointVector& actuated) const {
    const Vector2d middle = near(values_.front(), plane_of(actuated));
    int turns = 0;
    for (const int x : shifts(0))
      for (const int y : shifts(1)) turns += turns_around(Vector2d(middle + 2.0 * pi * Vector2d(x, y)));
    return turns;
  }

 private:
  static std::array<std::size_t, 2> free_legs(std::size_t held) {
    return {held == 0 ? 1U : 0U, held == 2 ? 1U : 2U};
  }

  bool is_angle(std::size_t axis) const { return robot_.leg(legs_[axis]).actuated_by_angle(); }

  std::vector<int> shifts(std::size_t axis) const {
    return is_angle(axis) ? std::vector<int>{-1, 0, 1} : std::vector<int>{0};
  }

  Vector2d plane_of(const JointVector& q) const {
    return {q[static_cast<Eigen::Index>(legs_[0])], q[static_cast<Eigen::Index>(legs_[1])]};
  }

  /// The same values, of angles in the turn next to these.
  Vector2d near(const Vector2d& reference, Vector2d values) const {
    for (const std::size_t axis : {0U, 1U}) {
      const auto k = static_cast<Eigen::Index>(axis);
      if (is_angle(axis)) values[k] = reference[k] + std::remainder(values[k] - reference[k], 2.0 * pi);
    }
    return values;
  }

  int turns_around(const Vector2d& middle) const {
    double angle = 0.0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const Vector2d a = values_[i] - middle, b = values_[(i + 1) % values_.size()] - middle;
      angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return static_cast<int>(std::lround(angle / (2.0 * pi)));
  }

  const Manipulator& robot_;
  std::array<std::size_t, 2> legs_;
  std::vector<Vector2d> values_;
};

/// Two poses of the same actuated values in one aspect.
struct PosePair {
  Pose first, second;
  double least_determinant = 0.0;
};

}  // namespace

/// One question.
class CuspPlanner::Search {
 public:
  Search(CuspPlanner& owner, const Cusp& cusp, std::size_t index, const MapControl& control)
      : owner_(owner),
        map_(*owner.map_),
        robot_(*map_.manipulator()),
        cusp_(cusp),
        index_(index),
        control_(control),
        circle_(circle_of_anchor(robot_, *map_.slice()->joint)) {}

  PlannedPath run(const PathEnd& from) {
    const Location start = map_.locate(from.pose, cusp_.mode);
    if (!start)
      return without_path(SameAspect::unknown,
                          "No aspect of the cusp's working mode is known to hold the start.");
    const auto pair = pair_beside_cusp(start.aspect);
    if (!pair)
      return without_path(
          SameAspect::unknown,
          "No two poses of the same actuated values are found beside the cusp in the aspect of the "
          "start; around a cusp poses change on one side of det A = 0 alone.");
    const PathEnd end{from.pose, cusp_.mode, from.q};
    std::optional<PlannedPath> best;
    for (const Pose& goal : others(from.pose, start.aspect)) {
      for (const PathPreference prefer : {PathPreference::clear, PathPreference::shortest})
        take_better(leg(end, goal, prefer), best);
      take_better(by_way_of(*pair, end, goal), best);
    }
    return best ? *best : without_path(SameAspect::unknown, "No path around the cusp is found.");
  }

 private:
  PlannedPath leg(const PathEnd& from, const Pose& to, PathPreference prefer = PathPreference::clear) {
    PlannedPath path = owner_.planner_.plan(from, {to, cusp_.mode}, {PathPolicy::stay, prefer}, control_);
    if (path) path.message = message();
    return path;
  }

  /// Around the fewest other cusps, and then with the largest least parallel index.
  void take_better(PlannedPath path, std::optional<PlannedPath>& best) const {
    if (!path || is_cancelled(control_) || owner_.turns_around_cusps(path)[index_] == 0) return;
    const auto rank = [this](const PlannedPath& each) {
      const std::vector<int> turns = owner_.turns_around_cusps(each);
      const auto around = std::count_if(turns.begin(), turns.end(), [](int turn) { return turn != 0; });
      return std::pair(around, -each.least_index);
    };
    if (!best || rank(path) < rank(*best)) best = std::move(path);
  }

  static std::string message() {
    return "Every segment is proved free of singularities. The actuated joints come back to where they were, "
           "and "
           "the platform does not.";
  }

  /// To the one, around the cusp to the other, and on.
  PlannedPath by_way_of(const PosePair& pair, const PathEnd& from, const Pose& goal) {
    std::optional<PlannedPath> best;
    for (const auto& [one, other] :
         {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
      const PlannedPath around = leg({one, cusp_.mode}, other);
      if (!around || owner_.turns_around_cusps(around)[index_] == 0) continue;
      const PlannedPath before = leg(from, one), behind = leg({other, cusp_.mode}, goal);
      if (!before || !behind) continue;
      PathBuilder builder(robot_,
                          [this](const Pose& a, const Pose& b, double t) { return owner_.between(a, b, t); });
      for (const PlannedPath* part : {&before, &around, &behind})
        for (const PathPoint& point : part->points) builder.go({point.pose}, point.mode);
      take_better(begun_at(from.q, robot_, builder.take(message())), best);
    }
    return best ? *best : without_path(SameAspect::unknown, "");
  }

  JointVector actuated_at(const Pose& pose) const { return inverse(robot_, pose, cusp_.mode).q; }

  /// The other poses of its actuated values in the aspect.
  std::vector<Pose> others(const Pose& pose, int aspect) const {
    const JointVector q = actuated_at(pose);
    std::vector<Pose> result;
    for (const AssemblyMode& each : direct(robot_, q).solutions) {
      if (pose_distance(each.pose, pose) < 1e-4 || each.serially_singular) continue;
      const Pose held = circle_.nearest(each.pose);
      if (map_.locate(held, cusp_.mode).aspect == aspect && difference_of(actuated_at(held), q) < same_values)
        result.push_back(held);
    }
    return result;
  }

  /// In direction and phi [rad].
  double pose_distance(const Pose& a, const Pose& b) const {
    const Vector2d from = point_of(a), to = point_of(b);
    return std::hypot(std::remainder(to.x() - from.x(), 2.0 * pi),
                      std::remainder(to.y() - from.y(), 2.0 * pi));
  }

  Vector2d point_of(const Pose& pose) const {
    const Vector2d rod = circle_.rod(pose);
    return {std::atan2(rod.y(), rod.x()), 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w())};
  }

  /// On the largest circle about the cusp that has one, that which is farthest from det A = 0.
  std::optional<PosePair> pair_beside_cusp(int aspect) const {
    const Vector2d middle = point_of(cusp_.pose);
    std::optional<PosePair> best;
    for (const double radius : circles) {
      for (int i = 0; i < points_of_a_circle && !is_cancelled(control_); ++i) {
        const double angle = 2.0 * pi * i / points_of_a_circle;
        const Vector2d at = middle + radius * Vector2d(std::cos(angle), std::sin(angle));
        look_beside(circle_.pose(at.x(), at.y()), radius, aspect, best);
      }
      if (best) return best;
    }
    return best;
  }

  void look_beside(const Pose& pose, double radius, int aspect, std::optional<PosePair>& best) const {
    if (map_.locate(pose, cusp_.mode).aspect != aspect) return;
    for (const Pose& other : others(pose, aspect)) {
      if (pose_distance(other, cusp_.pose) > 2.0 * radius) continue;
      const double least = std::min(determinant(pose), determinant(other));
      if (!best || least > best->least_determinant) best = PosePair{pose, other, least};
    }
  }

  double determinant(const Pose& pose) const {
    return std::abs(direct_determinant(robot_, pose, actuated_at(pose)));
  }

  CuspPlanner& owner_;
  const AspectMap& map_;
  const Manipulator& robot_;
  const Cusp& cusp_;
  std::size_t index_;
  const MapControl& control_;
  AnchorCircle circle_;
};

CuspPlanner::CuspPlanner(std::shared_ptr<const AspectMap> map, std::vector<Cusp> cusps)
    : map_(std::move(map)), cusps_(std::move(cusps)), planner_(map_) {}

PlannedPath CuspPlanner::plan(const PathEnd& from, std::size_t cusp, const MapControl& control) {
  return Search(*this, cusps_[cusp], cusp, control).run(from);
}

std::vector<int> CuspPlanner::turns_around_cusps(const PlannedPath& path) const {
  std::vector<int> turns(cusps_.size(), 0);
  if (path.points.empty() || difference_of(path.points.front().q, path.points.back().q) > same_values)
    return turns;
  const ActuatedLoop loop(*map_, path,
                          [this](const Pose& a, const Pose& b, double t) { return between(a, b, t); });
  for (std::size_t k = 0; k < cusps_.size(); ++k) turns[k] = loop.turns_around(cusps_[k].actuated);
  return turns;
}

}  // namespace parallel_aspects
