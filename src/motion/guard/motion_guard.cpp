// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/motion_guard.h"

#include "interval/interval.h"
#include "model/linear_algebra.h"
#include "model/task_space_traits.h"
#include "motion/guard/hazard_judge.h"
#include "motion/guard/issued_motion.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/problems.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The scale rises as from here at least.
constexpr double least_rise = 0.05;

}  // namespace

/// What one call works with.
class MotionGuard::Core {
 public:
  Core(std::shared_ptr<const Manipulator> manipulator, const GuardOptions& options)
      : manipulator_(std::move(manipulator)),
        options_(options),
        judge_(manipulator_, options),
        issued_(options.latency, options.sample_age, traits(manipulator_->task_space()).rotations) {}

  const Manipulator& manipulator() const noexcept { return *manipulator_; }

  GuardedMotion guard(const TrackedState& state, const ProvedDistances& proved, const TaskVector& twist,
                      double time) noexcept {
    const auto size = static_cast<Eigen::Index>(manipulator_->leg_count());
    const double age = time - state.time;
    if (state.status != TrackStatus::tracking || !judge_.usable() ||
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
    judge_.forget();
  }

  void set_stop(const std::array<double, hazard_count>& stop) noexcept { options_.stop = stop; }

 private:
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
    judge_.look_ahead(state, issued_, twist, time);
    for (const Hazard hazard : {Hazard::parallel_singularity, Hazard::serial_singularity, Hazard::limit}) {
      const auto i = static_cast<std::size_t>(hazard);
      // Distances of another working mode do not apply here, except to serial singularities.
      const bool holds = proved.mode == state.mode || hazard == Hazard::serial_singularity;
      const double lower = holds && !std::isnan(proved.lower[i]) ? proved.lower[i] : -infinite;
      if (lower == infinite) continue;
      const double distance = judge_.after_motion(lower, proved.pose, state.pose);
      const HazardVerdict verdict = judge_.judge(hazard, options_.stop[i], distance, state.q, rates);
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
    // After a limit of velocity the scale need not rise slowly.
    scale_ = result.reason == GuardReason::joint_velocity ? most : result.scale;
  }

  GuardedMotion issue(double time, const TaskVector& twist, const JointVector& rates,
                      GuardedMotion result) noexcept {
    result.twist = result.scale * twist;
    result.joint_velocities = result.scale * rates;
    if (issued_.issue(time, result.twist, judge_.braking_time(result.twist))) return result;
    return halt(time, GuardReason::too_many_commands);
  }

  const std::shared_ptr<const Manipulator> manipulator_;
  GuardOptions options_;
  HazardJudge judge_;
  IssuedMotion issued_;
  double scale_ = 1.0;      // of the last command
  double time_ = infinite;  // of it
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

}  // namespace parallel_aspects
