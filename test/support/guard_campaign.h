// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_GUARD_CAMPAIGN_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_GUARD_CAMPAIGN_H

#include "model/linear_algebra.h"
#include "parallel_aspects/distance/boundary_distances.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/motion/motion_guard.h"

#include "support/pose_pairs.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <deque>
#include <limits>
#include <optional>
#include <random>
#include <variant>
#include <vector>

namespace parallel_aspects::test {

constexpr double guard_step = 0.002;  // of the loop [s]: 500 Hz

/// A platform that follows twists late, and slows down at given decelerations: the model of
/// docs/howto/guard.md, by formulas of its own.
class LatePlatform {
 public:
  /// `delay`: of commands [s]; negative for one that differs from command to command, up to -delay.
  LatePlatform(TaskSpace space, const Pose& pose, const GuardOptions& options, double delay,
               std::uint64_t seed)
      : space_(space), pose_(pose), options_(options), delay_(delay), random_(seed) {}

  const Pose& pose() const { return pose_; }

  void command(double time, const TaskVector& twist) {
    double delay = delay_;
    if (delay < 0.0) delay = std::uniform_real_distribution<double>(0.0, -delay)(random_);
    const double begin = std::max(time + delay, waiting_.empty() ? 0.0 : waiting_.back().begin);
    waiting_.push_back({begin, twist});
  }

  void move(double from, double until) {
    constexpr int parts = 4;
    for (int i = 0; i < parts; ++i) {
      const double now = from + (until - from) * (i + 0.5) / parts;
      take(now);
      pose_ = displaced(space_, pose_, (until - from) / parts * velocity(now));
    }
  }

 private:
  struct Waiting {
    double begin;
    TaskVector twist;
  };
  struct Shed {  // an excess of velocity that is being lost
    double begin, seconds;
    TaskVector twist;
  };

  void take(double now) {
    while (!waiting_.empty() && waiting_.front().begin <= now) {
      const TaskVector& next = waiting_.front().twist;
      if (followed_.size() == 0) followed_ = TaskVector::Zero(next.size());
      const double seconds = braking_time(followed_);
      if (seconds > 0.0 && !(followed_ - next).isZero(0.0))
        shed_.push_back({waiting_.front().begin, seconds, followed_ - next});
      followed_ = next;
      waiting_.pop_front();
    }
    while (!shed_.empty() && shed_.front().begin + 10.0 < now) shed_.pop_front();
  }

  double braking_time(const TaskVector& twist) const {
    const auto turns = static_cast<Eigen::Index>(rotational_degrees_of_freedom(space_));
    return std::max(twist.head(turns).norm() / options_.angular_deceleration,
                    twist.tail(twist.size() - turns).norm() / options_.linear_deceleration);
  }

  TaskVector velocity(double now) const {
    if (followed_.size() == 0) return TaskVector::Zero(static_cast<Eigen::Index>(degrees_of_freedom(space_)));
    TaskVector result = followed_;
    for (const Shed& shed : shed_)
      result += std::max(0.0, 1.0 - (now - shed.begin) / shed.seconds) * shed.twist;
    return result;
  }

  TaskSpace space_;
  Pose pose_;
  GuardOptions options_;
  double delay_;
  std::mt19937_64 random_;
  std::deque<Waiting> waiting_;
  std::deque<Shed> shed_;
  TaskVector followed_;
};

inline const BoundaryDistance& distance_to(const BoundaryDistances& distances, Hazard hazard) {
  return hazard == Hazard::parallel_singularity ? distances.parallel
         : hazard == Hazard::serial_singularity ? distances.serial
                                                : distances.actuated_limit;
}

/// A pose near this one where a leg of the Agile Eye is stretched or folded: its anchor on the axis of its
/// actuated joint. B_jj only touches zero there, so the meter finds no such pose.
inline void add_touching_witness(const Manipulator& robot, const Pose& pose, BoundaryDistance& serial) {
  if (robot.task_space() != TaskSpace::SO3 || serial.status != DistanceStatus::no_witness) return;
  for (const Leg& leg : robot.legs())
    for (const double side : {1.0, -1.0}) {
      const auto* crank = std::get_if<RevoluteActuation>(&leg.actuation);
      if (crank == nullptr) continue;
      const Eigen::AngleAxisd turn(shortest_rotation(pose.transform(leg.anchor), side * crank->axis));
      const TaskVector twist = turn.angle() * turn.axis();
      const Pose there = displaced(robot.motions(), pose, twist);
      const double distance = anchor_distance(robot, pose, there);
      if (!(squared_inverse_entry(leg, there.transform(leg.anchor)) < 1e-9) || !(distance < serial.upper))
        continue;
      serial.upper = distance;
      serial.witness = there;
      serial.direction = twist / distance;
    }
}

inline ProvedDistances proved_of(const BoundaryDistances& distances, const Pose& pose,
                                 const WorkingMode& mode) {
  ProvedDistances proved{pose, mode, {}};
  for (std::size_t i = 0; i < hazard_count; ++i) {
    const BoundaryDistance& each = distance_to(distances, static_cast<Hazard>(i));
    proved.lower[i] =
        each.status == DistanceStatus::unavailable ? std::numeric_limits<double>::quiet_NaN() : each.lower;
  }
  return proved;
}

inline TrackedState tracked_at(const Manipulator& robot, const Pose& pose, const WorkingMode& mode,
                               double time) {
  TrackedState state;
  state.status = TrackStatus::tracking;
  state.time = time;
  state.pose = pose;
  state.mode = mode;
  const InverseSolution solution = inverse(robot, pose, mode);
  if (solution.status == InverseStatus::out_of_reach) state.status = TrackStatus::ambiguous;
  state.q = solution.q;
  return state;
}

/// Options that fit the size of a robot.
inline GuardOptions guard_options_for(const Manipulator& robot) {
  GuardOptions options;
  options.latency = 0.02;
  options.period = 0.004;
  options.linear_deceleration = 2.0 * robot.size();
  options.angular_deceleration = 4.0;
  // With six degrees of freedom the distances that are proved are far less than those that there are.
  options.stop.fill((robot.leg_count() > 3 ? 0.005 : 0.02) * robot.size());
  return options;
}

/// What became of one run.
struct GuardRun {
  bool lost = false;                                        ///< a leg came out of reach
  double over = std::numeric_limits<double>::infinity();    ///< least distance over its threshold, any hazard
  double pushed = std::numeric_limits<double>::infinity();  ///< of the hazard that it was pushed into
  double last = 0.0;                                        ///< distance of that hazard at the end
  double least_gain = std::numeric_limits<double>::infinity();  ///< of that distance since the start, ever
  int halts = 0;                                                ///< calls that gave zero
  int turns = 0;              ///< how often the scale turned back by more than a tenth, while it was pushed
  std::vector<double> times;  ///< of calls [s]
};

inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Counts how often a value turns back by more than a share of its range.
class TurnCount {
 public:
  void add(double value) {
    if (rising_ ? value > extreme_ : value < extreme_) extreme_ = value;
    if (std::abs(value - extreme_) <= 0.1) return;
    rising_ = !rising_;
    extreme_ = value;
    ++turns_;
  }
  int turns() const { return turns_; }

 private:
  bool rising_ = false;
  double extreme_ = 1.0;
  int turns_ = 0;
};

/// Pushes a robot towards a hazard: always the shortest way that was last measured, turned aside by `aside`.
/// Distances are measured 50 times a second, and known a period later.
class GuardLoop {
 public:
  GuardLoop(std::shared_ptr<const Manipulator> robot, const GuardOptions& options)
      : robot_(robot), options_(options), guard_(robot, options), meter_(robot) {}

  GuardRun push(const Pose& start, const WorkingMode& mode, Hazard hazard, double speed, double seconds,
                double delay, const TaskVector& aside, std::uint64_t seed, double sense = 1.0) {
    GuardRun run;
    TurnCount turns;
    LatePlatform platform(robot_->task_space(), start, options_, delay, seed);
    guard_.forget();
    BoundaryDistances measured = measure(start, mode);
    ProvedDistances proved = proved_of(measured, start, mode), next = proved;
    TaskVector towards = distance_to(measured, hazard).direction;
    const double first = distance_to(measured, hazard).upper;
    const int steps = static_cast<int>(seconds / guard_step);
    for (int i = 0; i < steps; ++i) {
      const double time = i * guard_step;
      if (i % 10 == 0) {
        proved = next;
        measured = measure(platform.pose(), mode);
        next = proved_of(measured, platform.pose(), mode);
        judge(measured, hazard, run);
        run.least_gain = std::min(run.least_gain, distance_to(measured, hazard).upper - first);
        const TaskVector& direction = distance_to(measured, hazard).direction;
        if (direction.size() > 0 && direction.allFinite()) towards = direction;
      }
      const TrackedState state = tracked_at(*robot_, platform.pose(), mode, time);
      run.lost = run.lost || !state.followed();
      if (run.lost) return run;
      const double before = thread_seconds();
      const GuardedMotion motion = guard_.guard(state, proved, sense * speed * (towards + aside), time);
      run.times.push_back(thread_seconds() - before);
      turns.add(motion.scale);
      run.halts += motion.scale == 0.0 ? 1 : 0;
      platform.command(time, motion.twist);
      platform.move(time, time + guard_step);
    }
    run.turns = turns.turns();
    run.last = distance_to(measured, hazard).upper;
    end_ = platform.pose();
    return run;
  }

  const Pose& end() const { return end_; }
  BoundaryDistances measure(const Pose& pose, const WorkingMode& mode) {
    BoundaryDistances found = meter_.measure(pose, mode);
    add_touching_witness(*robot_, pose, found.serial);
    return found;
  }

 private:
  void judge(const BoundaryDistances& measured, Hazard hazard, GuardRun& run) const {
    for (std::size_t i = 0; i < hazard_count; ++i) {
      const BoundaryDistance& each = distance_to(measured, static_cast<Hazard>(i));
      if (each.status == DistanceStatus::unavailable || each.status == DistanceStatus::absent) continue;
      const double distance = each.status == DistanceStatus::touching ? 0.0 : each.upper;
      run.over = std::min(run.over, distance - options_.stop[i]);
      if (static_cast<Hazard>(i) == hazard) run.pushed = std::min(run.pushed, distance - options_.stop[i]);
    }
  }

  std::shared_ptr<const Manipulator> robot_;
  GuardOptions options_;
  MotionGuard guard_;
  BoundaryDistanceMeter meter_;
  Pose end_;
};

/// A configuration from which the hazard can be pushed into, and nothing is below its threshold.
struct GuardStart {
  Pose pose;
  WorkingMode mode;
};

/// A pose on the way to the hazard, at about this distance from it and reached; nothing where there is none.
inline std::optional<Pose> pose_before(GuardLoop& loop, const GuardStart& start, Hazard hazard,
                                       double distance) {
  Pose pose = start.pose;
  for (int i = 0; i < 20; ++i) {
    const BoundaryDistances here = loop.measure(pose, start.mode);
    const BoundaryDistance& nearest = distance_to(here, hazard);
    if (!here || !std::isfinite(nearest.upper)) return std::nullopt;
    if (std::abs(nearest.upper - distance) < 0.05 * distance) return pose;
    if (nearest.upper < distance) return std::nullopt;
    pose = pose_between(pose, nearest.witness, 1.0 - distance / nearest.upper);
  }
  return std::nullopt;
}

/// Drawn at random.
inline std::optional<GuardStart> draw_start(PosePairs& random, GuardLoop& loop, Hazard hazard,
                                            const GuardOptions& options, int tries = 300) {
  for (int i = 0; i < tries; ++i) {
    const WorkingMode mode = random.mode();
    const auto pose = random.reached(mode);
    if (!pose) continue;
    const BoundaryDistances distances = loop.measure(*pose, mode);
    bool clear = static_cast<bool>(distances);
    for (std::size_t k = 0; k < hazard_count; ++k)
      clear = clear && distance_to(distances, static_cast<Hazard>(k)).lower > 1.2 * options.stop[k];
    if (clear && std::isfinite(distance_to(distances, hazard).upper)) return GuardStart{*pose, mode};
  }
  return std::nullopt;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_GUARD_CAMPAIGN_H
