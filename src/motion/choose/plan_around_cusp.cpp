// SPDX-License-Identifier: BSD-3-Clause
#include "motion/choose/plan_around_cusp.h"

#include "aspects/uniqueness/cusp_aspect.h"
#include "model/angles.h"
#include "model/message_text.h"
#include "motion/choose/cusp_loops.h"
#include "motion/plan/path_builder.h"
#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/tracking/tracker.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

constexpr int steps_of_a_loop = 32;

// Paths with as much room, to this share of it, differ by the cusps that they go around.
constexpr double same_room = 0.01;

// Noises that are tried, the largest first, each this share of the one before [rad, or share of the robot's
// size].
constexpr double largest_noise = 1e-2, next_noise = 0.9, least_noise = 1e-7;

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

  /// Counts turns counter-clockwise; for angles, around the values in every turn.
  int turns_around(const JointVector& actuated) const {
    const Vector2d middle = near(values_.front(), plane_of(actuated));
    int turns = 0;
    for (const int x : shifts(0))
      for (const int y : shifts(1)) turns += turns_around(Vector2d(middle + 2.0 * pi * Vector2d(x, y)));
    return turns;
  }

 private:
  bool is_angle(std::size_t axis) const {
    return robot_.leg(static_cast<std::size_t>(legs_[axis])).actuated_by_angle();
  }

  std::vector<int> shifts(std::size_t axis) const {
    return is_angle(axis) ? std::vector<int>{-1, 0, 1} : std::vector<int>{0};
  }

  Vector2d plane_of(const JointVector& q) const { return {q[legs_[0]], q[legs_[1]]}; }

  /// The same values, angles shifted to the turn next to these.
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
  std::array<Eigen::Index, 2> legs_;
  std::vector<Vector2d> values_;
};

}  // namespace

/// One question.
class CuspPlanner::Search {
 public:
  Search(const CuspPlanner& owner, const Cusp& cusp, std::size_t index, const MapControl& control)
      : owner_(owner),
        map_(*owner.map_),
        robot_(*map_.manipulator()),
        cusp_(cusp),
        index_(index),
        control_(control),
        circle_(circle_of_anchor(robot_, *map_.slice()->joint)) {}

  PlannedPath run(const PathEnd& from) {
    if (from.mode && *from.mode != cusp_.mode)
      return without_path(SameAspect::unknown, "The cusp is one of the working mode " +
                                                   to_string(cusp_.mode) + ", and the start is in " +
                                                   to_string(*from.mode) + ".");
    const Location start = map_.locate(from.pose, cusp_.mode);
    if (!start)
      return without_path(SameAspect::unknown,
                          "No aspect of the cusp's working mode is known to hold the start.");
    if (std::optional<PlannedPath> best = best_path(from, start.aspect)) return *std::move(best);
    return without_path(SameAspect::unknown,
                        "No path around the cusp to another pose of the start's actuated values is found in "
                        "component " +
                            std::to_string(start.aspect) + ", which holds the start.");
  }

  CuspStart find_start() {
    const BesideCusp beside = look_beside(map_, cusp_);
    CuspStart result{beside.aspect, {}};
    for (auto pose = beside.poses.rbegin(); pose != beside.poses.rend() && !is_cancelled(control_); ++pose)
      if (const auto path = best_path({*pose, cusp_.mode}, beside.aspect)) {
        result.point = path->points.front();
        break;
      }
    return result;
  }

 private:
  std::optional<PlannedPath> best_path(const PathEnd& from, int aspect) {
    CuspLoops loops(map_, owner_.segments_, cusp_.mode, aspect, from.pose, control_);
    std::optional<PlannedPath> best;
    for (const Pose& goal : others(from.pose, aspect)) {
      if (is_cancelled(control_)) break;
      take_better(path_of(loops.find(cusp_.actuated, goal), from), best);
    }
    return best;
  }

  PlannedPath path_of(const std::vector<Pose>& poses, const PathEnd& from) const {
    if (poses.empty()) return without_path(SameAspect::unknown, "");
    PathBuilder builder(robot_,
                        [this](const Pose& a, const Pose& b, double t) { return owner_.between(a, b, t); });
    builder.go(poses, cusp_.mode);
    return begun_at(from.q, robot_,
                    builder.take("Every segment is proved free of singularities. The actuated joints come "
                                 "back to where they were, and the platform does not."));
  }

  void take_better(PlannedPath path, std::optional<PlannedPath>& best) {
    if (!path || owner_.turns_around_cusps(path)[index_] == 0) return;
    const double room = owner_.least_room(path);
    const auto around = cusps_around(path);
    if (best && room < (around < around_ ? 1.0 - same_room : 1.0 + same_room) * room_) return;
    best = std::move(path);
    room_ = room, around_ = around;
  }

  std::ptrdiff_t cusps_around(const PlannedPath& path) const {
    const std::vector<int> turns = owner_.turns_around_cusps(path);
    return std::count_if(turns.begin(), turns.end(), [](int turn) { return turn != 0; });
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

  const CuspPlanner& owner_;
  const AspectMap& map_;
  const Manipulator& robot_;
  const Cusp& cusp_;
  std::size_t index_;
  const MapControl& control_;
  AnchorCircle circle_;
  double room_ = 0.0;          // of the best path
  std::ptrdiff_t around_ = 0;  // how many cusps that goes around
};

CuspPlanner::CuspPlanner(std::shared_ptr<const AspectMap> map, std::vector<Cusp> cusps)
    : map_(std::move(map)), cusps_(std::move(cusps)), segments_(map_) {}

PlannedPath CuspPlanner::plan(const PathEnd& from, std::size_t cusp, const MapControl& control) const {
  return Search(*this, cusps_[cusp], cusp, control).run(from);
}

CuspStart CuspPlanner::find_start(std::size_t cusp, const MapControl& control) const {
  return Search(*this, cusps_[cusp], cusp, control).find_start();
}

void CuspPlanner::look_along(const PlannedPath& path, const Look& look) const {
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    for (int step = 0; step <= steps_of_a_loop; ++step) {
      const PathPoint &from = path.points[i], &to = path.points[i + 1];
      look(between(from.pose, to.pose, static_cast<double>(step) / steps_of_a_loop), from.mode);
    }
}

double CuspPlanner::least_room(const PlannedPath& path) const {
  const Manipulator& robot = *map_->manipulator();
  double least = std::numeric_limits<double>::infinity();
  look_along(path, [&](const Pose& pose, const WorkingMode& mode) {
    least = std::min(least, room_at(robot, pose, inverse(robot, pose, mode).q));
  });
  return least;
}

double CuspPlanner::followed_noise(const PlannedPath& path) const {
  SampleOptions options;
  options.encoder_noise = largest_noise;
  std::optional<StandOff> stand_off(std::in_place, map_->manipulator(), options);
  look_along(path, [&](const Pose& pose, const WorkingMode& mode) {
    while (stand_off && !stand_off->can_distinguish(pose, mode)) {
      options.encoder_noise *= next_noise;
      stand_off.reset();
      if (options.encoder_noise > least_noise) stand_off.emplace(map_->manipulator(), options);
    }
  });
  return stand_off ? options.encoder_noise : 0.0;
}

std::string noise_text(double noise) {
  if (!(noise > 0.0)) return "It is so narrow that by an estimate no tracker follows it.";
  const double digit = std::pow(10.0, std::floor(std::log10(noise)) - 1.0);
  return "By an estimate a tracker follows it with encoders that are off by up to " +
         number_text(digit * std::floor(noise / digit)) +
         " rad, or that share of the robot's size in m (tracking/encoder_noise).";
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
