// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/motion_guard.h"

#include "interval/rounding.h"
#include "model/linear_algebra.h"
#include "model/task_space_traits.h"
#include "motion/guard/clear_region.h"
#include "motion/guard/issued_motion.h"
#include "motion/guard/stopping.h"
#include "parallel_aspects/kinematics/jacobians.h"
#include "parallel_aspects/model/anchor_distance.h"
#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/motion/escape_direction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// For floating-point arithmetic beside the proofs; far more than it is off by.
constexpr double relative_rounding = 1e-9, rounding_of_size = 1e-12;

// A command is followed for this many latencies longer than is needed, as far as its scale is concerned. The
// speed then falls with the distance so gently that a robot that answers late, by up to the latency, does not
// oscillate: v(t) = d(t) / T with d'(t) = -v(t - latency) is monotone for T >= e latency.
constexpr double calm = 3.0;

// Cosine of the angle between a command and the fastest way out, from which on it passes whole; smaller ones
// pass in part, so that the scale is continuous.
constexpr double clearly_away = 0.05;

// Parts of a command over whose reach enclosures are made at first, and the least later; then about the part
// that was last proved, so that it changes continuously and the time is short.
constexpr std::array<double, 4> first_reaches{1.0, 0.3, 0.1, 0.03};
constexpr double least_reach = 0.03;

// How much more than the distance that is proved is looked at for a way out.
constexpr double nearly = 0.1;

// The scale rises as from here at least.
constexpr double least_rise = 0.05;

double positive_part(double value) noexcept { return std::max(0.0, value); }

}  // namespace

const char* name(GuardReason reason) noexcept {
  switch (reason) {
    case GuardReason::none:
      return "none";
    case GuardReason::hazard:
      return "hazard";
    case GuardReason::inside_threshold:
      return "inside threshold";
    case GuardReason::escape:
      return "escape";
    case GuardReason::joint_velocity:
      return "joint velocity";
    case GuardReason::recovery:
      return "recovery";
    case GuardReason::unknown_state:
      return "unknown state";
    case GuardReason::invalid_command:
      return "invalid command";
    case GuardReason::too_many_commands:
      break;
  }
  return "too many commands";
}

std::vector<std::string> problems_of(const GuardOptions& options) {
  std::vector<std::string> problems;
  const auto require = [&](bool holds, const char* what, double value, const char* range) {
    if (!holds)
      problems.push_back(std::string("The ") + what + " of the guard is " + std::to_string(value) +
                         "; it must be " + range + ".");
  };
  const auto not_negative = [](double value) { return std::isfinite(value) && value >= 0.0; };
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  require(not_negative(options.latency), "latency", options.latency, "finite and not negative [s]");
  require(positive(options.period), "period", options.period, "finite and positive [s]");
  require(positive(options.sample_age), "sample age", options.sample_age, "finite and positive [s]");
  require(positive(options.linear_deceleration), "linear deceleration", options.linear_deceleration,
          "finite and positive [m/s^2]");
  require(positive(options.angular_deceleration), "angular deceleration", options.angular_deceleration,
          "finite and positive [rad/s^2]");
  require(not_negative(options.recovery), "recovery", options.recovery, "finite and not negative [s]");
  for (const double stop : options.stop)
    require(not_negative(stop), "stop threshold", stop, "finite and not negative [m]");
  return problems;
}

/// What one call works with.
class MotionGuard::Core {
 public:
  Core(std::shared_ptr<const Manipulator> manipulator, const GuardOptions& options)
      : manipulator_(std::move(manipulator)),
        options_(options),
        region_(make_clear_region(manipulator_)),
        issued_(options.latency, options.sample_age, traits(manipulator_->task_space()).rotations) {}

  const Manipulator& manipulator() const noexcept { return *manipulator_; }

  GuardedMotion guard(const TrackedState& state, const ProvedDistances& proved, const TaskVector& twist,
                      double time) noexcept {
    const auto size = static_cast<Eigen::Index>(manipulator_->leg_count());
    const double age = time - state.time;
    if (state.status != TrackStatus::tracking || !region_->usable() ||
        !(age >= -options_.sample_age && age <= options_.sample_age))
      return halt(time, GuardReason::unknown_state);
    if (twist.size() != size || !twist.allFinite()) return halt(time, GuardReason::invalid_command);
    const JointVector rates = joint_velocities(*manipulator_, state.pose, state.q, twist);
    if (!rates.allFinite()) return halt(time, GuardReason::unknown_state);
    GuardedMotion result;
    result.scale = 1.0;
    result.reason = GuardReason::none;
    limit_joint_velocities(rates, result);
    limit_by_hazards(state, proved, twist, rates, time, result);
    recover(time, result);
    return issue(time, twist, rates, result);
  }

  GuardedMotion halt(double time, GuardReason reason) noexcept {
    const auto size = static_cast<Eigen::Index>(manipulator_->leg_count());
    GuardedMotion result;
    result.reason = reason;
    result.twist = result.joint_velocities = TaskVector::Zero(size);
    scale_ = 0.0;
    time_ = time;
    issued_.issue(time, result.twist, 0.0);
    return result;
  }

  void forget() noexcept {
    issued_.forget();
    scale_ = 1.0;
    time_ = infinite;
    reaches_.fill(0.0);
  }

  void set_stop(const std::array<double, hazard_count>& stop) noexcept { options_.stop = stop; }

 private:
  // A command as the metric sees it.
  struct Motion {
    MetricSpeed speed;
    double seconds = 0.0, brake = 0.0;
    bool may_begin_yet = false;
  };

  // Speeds in one direction, 0 or more; of commands that were merged there are several.
  struct SpeedRange {
    double least, most;
    double range() const noexcept { return most - least; }
  };

  // What is about to happen, the commands before the new one and that.
  struct Prospect {
    std::array<Motion, IssuedMotion::most> before;
    std::size_t count = 0;
    Motion command;
    double spread = 0.0;
  };

  // How far one hazard lets the command go.
  struct Verdict {
    double scale = 0.0;
    bool inside = false, escape = false;
    bool nearer = false;  // the command goes towards a half space that the robot is too near to
  };

  // What one hazard is judged by.
  struct Vicinity {
    Hazard hazard;
    double stop, known;  // distances: the threshold, and what is proved
    const JointVector &q, &rates;
  };

  double braking_time(const TaskVector& twist) const noexcept {
    const TaskSpaceTraits& space = traits(manipulator_->task_space());
    const auto turns = static_cast<Eigen::Index>(space.rotations);
    return std::max(twist.head(turns).norm() / options_.angular_deceleration,
                    twist.tail(twist.size() - turns).norm() / options_.linear_deceleration);
  }

  void limit_joint_velocities(const JointVector& rates, GuardedMotion& result) const noexcept {
    for (Eigen::Index j = 0; j < rates.size(); ++j) {
      const auto leg = static_cast<std::size_t>(j);
      const double most = manipulator_->leg(leg).limits.velocity, rate = std::abs(rates[j]);
      if (!(most > 0.0) || rate * result.scale <= most) continue;
      result.scale = most / rate;
      result.reason = GuardReason::joint_velocity;
      result.leg = leg;
    }
  }

  void limit_by_hazards(const TrackedState& state, const ProvedDistances& proved, const TaskVector& twist,
                        const JointVector& rates, double time, GuardedMotion& result) noexcept {
    if (twist.isZero(0.0)) return;
    const RoundingUpward upward;
    region_->move_to(state.pose, state.mode);
    look_ahead(state, twist, time);
    const double moved = anchor_distance(*manipulator_, proved.pose, state.pose);
    for (const Hazard hazard : {Hazard::parallel_singularity, Hazard::serial_singularity, Hazard::limit}) {
      const auto i = static_cast<std::size_t>(hazard);
      // Those of another working mode say nothing here, but for serial singularities.
      const bool holds = proved.mode == state.mode || hazard == Hazard::serial_singularity;
      const double lower = holds && !std::isnan(proved.lower[i]) ? proved.lower[i] : -infinite;
      if (lower == infinite) continue;
      const double distance = lower - moved * (1.0 + relative_rounding) - slack();
      const Verdict verdict = judge(hazard, options_.stop[i], distance, state.q, rates);
      if (verdict.escape && result.reason == GuardReason::none) {
        result.reason = GuardReason::escape;
        result.hazard = hazard;
      }
      if (!(verdict.scale < result.scale)) continue;
      result.scale = verdict.scale;
      result.reason = verdict.inside ? GuardReason::inside_threshold : GuardReason::hazard;
      result.hazard = hazard;
    }
  }

  double slack() const noexcept { return rounding_of_size * manipulator_->size(); }

  void look_ahead(const TrackedState& state, const TaskVector& twist, double time) noexcept {
    issued_.pending(state.time, time, pending_);
    prospect_.count = pending_.count;
    prospect_.spread = state.spread;
    for (std::size_t i = 0; i < pending_.count; ++i) {
      const PendingMotion& motion = pending_.list[i];
      MetricSpeed speed = region_->speed_of(motion.twist);
      speed.turn_off = motion.turn_off;
      speed.off = region_->speed_at_most(motion.turn_off, motion.slide_off);
      prospect_.before[i] = {speed, motion.seconds, motion.brake, motion.may_begin_yet};
    }
    prospect_.command = {region_->speed_of(twist), options_.period + calm * options_.latency,
                         braking_time(twist), true};
  }

  // How far earlier commands may still go, by the speed that `of` finds in each [m, or rad].
  template <class Of>
  double pending_travel(const Of& of) const noexcept {
    double travel = 0.0, least_before = 0.0;
    for (std::size_t i = 0; i < prospect_.count; ++i) {
      const Motion& motion = prospect_.before[i];
      const SpeedRange speed = of(motion.speed);
      travel += speed.most * motion.seconds;
      // Delays that differ may let a faster command begin sooner or end later than a slower one.
      if (motion.may_begin_yet)
        travel += (positive_part(speed.most - least_before) + speed.range()) * options_.latency;
      double lost = speed.range();
      if (i + 1 < prospect_.count)
        lost += positive_part(speed.most - of(prospect_.before[i + 1].speed).least);
      travel += 0.5 * lost * motion.brake;
      least_before = speed.least;
    }
    return travel;
  }

  template <class Of>
  StoppingMotion stopping(const Of& of) const noexcept {
    StoppingMotion motion{of(prospect_.command.speed).most, prospect_.command.seconds,
                          prospect_.command.brake, 0.0, 0.0};
    if (prospect_.count == 0) return motion;
    const Motion& last = prospect_.before[prospect_.count - 1];
    motion.last = of(last.speed).most;
    motion.last_brake = last.brake;
    return motion;
  }

  // Of at most this scale; travel is convex in the scale.
  template <class Of>
  double travel_up_to(double scale, const Of& of) const noexcept {
    const StoppingMotion motion = stopping(of);
    return (pending_travel(of) + std::max(motion.travel(0.0), motion.travel(scale))) *
           (1.0 + relative_rounding);
  }

  static SpeedRange path_of(const MetricSpeed& speed) noexcept {
    return {positive_part(speed.path - speed.off), speed.path + speed.off};
  }
  static SpeedRange turn_of(const MetricSpeed& speed) noexcept {
    return {positive_part(speed.turn - speed.turn_off), speed.turn + speed.turn_off};
  }

  // First by the proved distance alone; then by what is proved to be clear about the robot.
  Verdict judge(Hazard hazard, double stop, double distance, const JointVector& q,
                const JointVector& rates) noexcept {
    Verdict best;
    const double known = distance - prospect_.spread;
    best.scale = stopping(path_of).largest_scale((known - stop) - pending_travel(path_of));
    best.inside = known < stop;
    double& proved = reaches_[static_cast<std::size_t>(hazard)];
    const std::array<double, 4> later{std::min(1.0, std::max(least_reach, 2.0 * proved)),
                                      std::max(least_reach, 0.5 * proved), 0.0, 0.0};
    const std::array<double, 4>& reaches = proved > 0.0 ? later : first_reaches;
    const Vicinity vicinity{hazard, stop, known, q, rates};
    for (const double reach : reaches) look_about(vicinity, reach, best);
    if (best.inside)
      for (const double reach : reaches) look_for_escape(vicinity, reach, best);
    proved = std::max(least_reach, best.scale);
    best.escape = best.escape && best.scale > 0.0;
    return best;
  }

  void look_about(const Vicinity& vicinity, double reach, Verdict& best) const noexcept {
    if (reach <= best.scale) return;
    const bool is_outside = vicinity.known >= vicinity.stop;
    const Verdict verdict = judge_within(vicinity, reach, vicinity.stop, is_outside);
    const bool inside = best.inside && verdict.inside, nearer = best.nearer || verdict.nearer;
    if (verdict.scale > best.scale) best = verdict;
    best.inside = inside;
    best.nearer = nearer;
  }

  // Below the threshold what is clear of a smaller ball suffices, as long as the hazard is in it; or half of
  // it, ahead.
  void look_for_escape(const Vicinity& vicinity, double reach, Verdict& best) const noexcept {
    if (reach <= best.scale) return;
    const double path = travel_up_to(reach, path_of);
    const double least = positive_part(vicinity.known) * (1.0 + nearly) + path;
    if (least < vicinity.stop) {
      const Verdict verdict = judge_within(vicinity, reach, least, false);
      if (verdict.escape && verdict.scale > best.scale) best = verdict;
      best.nearer = best.nearer || verdict.nearer;
    }
    if (reach <= best.scale || best.nearer || !is_ahead_clear(vicinity, least + path)) return;
    best.scale = reach;
    best.inside = best.escape = true;
  }

  // Whether no pose of the hazard within `radius` is ahead of the robot: then going there increases the
  // distance from all of them. Earlier commands may go aside by less than is left.
  bool is_ahead_clear(const Vicinity& vicinity, double radius) const noexcept {
    const TaskVector& rate = prospect_.command.speed.rate;
    const TaskVector ahead = rate / rate.norm();
    const auto aside = [&](const MetricSpeed& speed) {
      const double away = (speed.rate - positive_part(speed.rate.dot(ahead)) * ahead).norm();
      return SpeedRange{positive_part(away - speed.off), away + speed.off};
    };
    const double kept = 1.0 - region_->distortion(radius);
    const double left = kept * (vicinity.known - region_->bend(travel_up_to(1.0, turn_of)));
    if (!(pending_travel(aside) + stopping(aside).travel(0.0) < left)) return false;
    return region_->is_ahead_clear(vicinity.hazard, ahead, radius * (1.0 + relative_rounding));
  }

  Verdict judge_within(const Vicinity& vicinity, double reach, double stop,
                       bool known_outside) const noexcept {
    Verdict verdict;
    verdict.inside = true;
    const double radius =
        (stop + prospect_.spread + travel_up_to(reach, path_of)) * (1.0 + relative_rounding) + slack();
    const double kept = 1.0 - region_->distortion(radius);
    if (!(kept > 0.0)) return verdict;
    const double bend = region_->bend(travel_up_to(reach, turn_of));
    const ClearHalfSpaces clear = region_->find(vicinity.hazard, radius);
    verdict.scale = reach;
    verdict.inside = false;
    for (std::size_t k = 0; k < clear.count; ++k) {
      const ClearHalfSpace& half_space = clear.list[k];
      if (vicinity.hazard == Hazard::limit && is_beyond(half_space, vicinity.q)) continue;
      const double spare =
          half_space.clearance - bend - prospect_.spread / kept - slack() - relative_rounding * radius;
      judge_half_space(half_space, spare, stop / kept, known_outside, verdict);
    }
    if (vicinity.hazard == Hazard::limit) turn_back(vicinity.q, vicinity.rates, verdict);
    return verdict;
  }

  // `spare`: how far the half space lets the robot go at all.
  void judge_half_space(const ClearHalfSpace& half_space, double spare, double stop, bool known_outside,
                        Verdict& verdict) const noexcept {
    const auto towards = [&](const MetricSpeed& speed) {
      const double along = -half_space.normal.dot(speed.rate);
      return SpeedRange{positive_part(along - speed.off), positive_part(along + speed.off)};
    };
    const double room = spare - pending_travel(towards);
    if (spare >= stop || known_outside) {
      verdict.inside = verdict.inside || spare < stop;
      verdict.scale = std::min(verdict.scale, stopping(towards).largest_scale(room - stop));
      return;
    }
    verdict.inside = verdict.escape = true;
    const TaskVector& rate = prospect_.command.speed.rate;
    const double away = half_space.normal.dot(rate) / (clearly_away * rate.norm());
    verdict.nearer = verdict.nearer || (spare > 0.0 && away < 0.0);
    const bool clears = room - stopping(towards).travel(0.0) > 0.0;
    verdict.scale = std::min(verdict.scale, clears ? positive_part(away) : 0.0);
  }

  bool is_beyond(const ClearHalfSpace& half_space, const JointVector& q) const noexcept {
    const JointLimits& limits = manipulator_->leg(half_space.leg).limits;
    const double value = q[static_cast<Eigen::Index>(half_space.leg)];
    return half_space.end == LimitEnd::lower ? value < limits.lower : value > limits.upper;
  }

  // Joints that are beyond their limits must not go farther.
  void turn_back(const JointVector& q, const JointVector& rates, Verdict& verdict) const noexcept {
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const JointLimits& limits = manipulator_->leg(static_cast<std::size_t>(j)).limits;
      if (limits.contain(q[j])) continue;
      verdict.inside = verdict.escape = true;
      if (q[j] < limits.lower ? rates[j] < 0.0 : rates[j] > 0.0) verdict.scale = 0.0;
    }
  }

  void recover(double time, GuardedMotion& result) noexcept {
    const double since = time - time_;
    time_ = time;
    const bool limited = options_.recovery > 0.0 && since >= 0.0 && std::isfinite(since);
    const double most =
        limited ? std::min(1.0, scale_ + std::max(scale_, least_rise) * since / options_.recovery) : 1.0;
    if (result.scale > most) {
      result.scale = most;
      if (result.reason == GuardReason::none || result.reason == GuardReason::joint_velocity)
        result.reason = GuardReason::recovery;
    }
    // Limits of velocity are no reason to rise slowly.
    scale_ = result.reason == GuardReason::joint_velocity ? most : result.scale;
  }

  GuardedMotion issue(double time, const TaskVector& twist, const JointVector& rates,
                      GuardedMotion result) noexcept {
    result.twist = result.scale * twist;
    result.joint_velocities = result.scale * rates;
    if (issued_.issue(time, result.twist, braking_time(result.twist))) return result;
    return halt(time, GuardReason::too_many_commands);
  }

  const std::shared_ptr<const Manipulator> manipulator_;
  GuardOptions options_;
  const std::unique_ptr<ClearRegion> region_;
  IssuedMotion issued_;
  IssuedMotion::Pending pending_;
  Prospect prospect_;
  std::array<double, hazard_count> reaches_{};  // what was last proved, by `Hazard`; 0 for nothing yet
  double scale_ = 1.0;                          // of the last command
  double time_ = infinite;                      // of it
};

MotionGuard::MotionGuard(std::shared_ptr<const Manipulator> manipulator, const GuardOptions& options) {
  const std::vector<std::string> problems = problems_of(options);
  if (!problems.empty()) throw InvalidDescription(problems);
  core_ = std::make_unique<Core>(std::move(manipulator), options);
}

MotionGuard::~MotionGuard() = default;
MotionGuard::MotionGuard(MotionGuard&&) noexcept = default;
MotionGuard& MotionGuard::operator=(MotionGuard&&) noexcept = default;

GuardedMotion MotionGuard::guard(const TrackedState& state, const ProvedDistances& proved,
                                 const TaskVector& twist, double time) noexcept {
  return core_->guard(state, proved, twist, time);
}

GuardedMotion MotionGuard::guard_joints(const TrackedState& state, const ProvedDistances& proved,
                                        const JointVector& velocities, double time) noexcept {
  const Manipulator& manipulator = core_->manipulator();
  if (!state.followed()) return core_->halt(time, GuardReason::unknown_state);
  if (velocities.size() != static_cast<Eigen::Index>(manipulator.leg_count()))
    return core_->halt(time, GuardReason::invalid_command);
  const TaskVector right = inverse_diagonal(manipulator, state.pose, state.q).cwiseProduct(velocities);
  return core_->guard(state, proved, solution(direct_matrix(manipulator, state.pose, state.q), right), time);
}

GuardedMotion MotionGuard::halt(double time, GuardReason reason) noexcept {
  return core_->halt(time, reason);
}

void MotionGuard::forget() noexcept { core_->forget(); }

void MotionGuard::set_stop(const std::array<double, hazard_count>& stop) noexcept { core_->set_stop(stop); }

}  // namespace parallel_aspects
