// SPDX-License-Identifier: BSD-3-Clause
#include "model/angles.h"
#include "parallel_aspects/tracking/tracker.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

double nearest_turn(double last, double angle) {
  return angle + full_turn * std::round((last - angle) / full_turn);
}

// The value inside the limits that is a whole number of turns away and closest to `wanted`; the angle itself
// where there is none.
double turned_inside(const JointLimits& limits, double wanted, double angle) {
  const double near = nearest_turn(wanted, angle);
  if (limits.contain(near)) return near;
  const double end = near < limits.lower ? limits.lower : limits.upper;
  const double at_end = nearest_turn(end, angle);
  for (const double value : {at_end, at_end - full_turn, at_end + full_turn})
    if (limits.contain(value)) return value;
  return angle;
}

// Of the time alone.
SampleGap gap_of(const Manipulator& manipulator, const SampleOptions& options,
                 const SampleIntervals& intervals, double seconds) {
  if (std::isinf(options.longest_interval)) return SampleGap::none;
  if (!(seconds >= 0.0 && seconds <= options.longest_interval)) return SampleGap::silence;
  const bool paused =
      !velocities_limited(manipulator, options) && intervals.exceeded_by(seconds, options.interval_ratio);
  return paused ? SampleGap::pause : SampleGap::none;
}

}  // namespace

std::vector<std::string> problems_of(const SampleOptions& options) {
  std::vector<std::string> problems;
  const auto not_negative = [&](double value, const std::string& what) {
    if (!std::isfinite(value) || value < 0.0)
      problems.push_back("The " + what + " is " + std::to_string(value) +
                         "; it must be finite and not negative.");
  };
  not_negative(options.velocity_tolerance, "tolerance of velocities");
  not_negative(options.encoder_noise, "noise of the encoders");
  not_negative(options.path_bend, "bend of the path");
  if (!(options.longest_interval > 0.0))
    problems.push_back("The longest interval between samples is " + std::to_string(options.longest_interval) +
                       " s; it must be positive, and infinite for none.");
  if (!(options.interval_ratio >= 1.0))
    problems.push_back("The ratio of intervals between samples is " + std::to_string(options.interval_ratio) +
                       "; it must be 1 or more.");
  return problems;
}

JointVector unwrapped(const Manipulator& manipulator, const JointVector& last,
                      const JointVector& q) noexcept {
  JointVector result = q;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    const auto i = static_cast<Eigen::Index>(j);
    if (!leg.actuated_by_angle()) continue;
    const double before = last.size() == q.size() ? last[i] : q[i];
    result[i] = leg.limits.limited() ? turned_inside(leg.limits, before, q[i]) : nearest_turn(before, q[i]);
  }
  return result;
}

JointVector encoder_noise(const Manipulator& manipulator, const SampleOptions& options) noexcept {
  JointVector noise(static_cast<Eigen::Index>(manipulator.leg_count()));
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    noise[static_cast<Eigen::Index>(j)] =
        options.encoder_noise * (manipulator.leg(j).actuated_by_angle() ? 1.0 : manipulator.size());
  return noise;
}

bool velocities_limited(const Manipulator& manipulator, const SampleOptions& options) noexcept {
  const auto& legs = manipulator.legs();
  return options.check_velocity && std::all_of(legs.begin(), legs.end(), [](const Leg& leg) {
           return std::isfinite(leg.limits.velocity);
         });
}

// More than half of the intervals are below the median, or equal to it: no need to sort.
bool SampleIntervals::exceeded_by(double seconds, double ratio) const noexcept {
  if (count_ < fewest) return false;
  const auto known = seconds_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto shorter =
      std::count_if(seconds_.begin(), known, [&](double interval) { return ratio * interval < seconds; });
  return 2 * static_cast<std::size_t>(shorter) > count_;
}

void SampleIntervals::add(double seconds) noexcept {
  if (!(seconds > 0.0)) return;
  next_ = count_ == 0 ? 0 : next_;
  seconds_[next_] = seconds;
  next_ = (next_ + 1) % most;
  count_ = std::min(count_ + 1, most);
}

SampleGap gap_between(const Manipulator& manipulator, const SampleOptions& options,
                      const SampleIntervals& intervals, const JointVector& last, const JointVector& q,
                      double seconds, const JointVector& uncertainty) noexcept {
  const SampleGap gap = gap_of(manipulator, options, intervals, seconds);
  if (gap != SampleGap::none || !options.check_velocity) return gap;
  const JointVector noise = encoder_noise(manipulator, options);
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const Leg& leg = manipulator.leg(j);
    if (!std::isfinite(leg.limits.velocity)) continue;
    const auto i = static_cast<Eigen::Index>(j);
    const double possible =
        leg.limits.velocity * (1.0 + options.velocity_tolerance) * std::fmax(0.0, seconds);
    const double unknown = uncertainty.size() == q.size() ? uncertainty[i] : 0.0;
    if (!(std::abs(q[i] - last[i]) <= possible + noise[i] + unknown)) return SampleGap::step;
    const bool turns_freely = leg.actuated_by_angle() && !leg.limits.limited();
    if (options.unwrap && turns_freely && possible >= EIGEN_PI) return SampleGap::half_turn;
  }
  return SampleGap::none;
}

JointVector PathBend::next(const SampleOptions& options, const JointVector& step,
                           const JointVector& noise) noexcept {
  JointVector change = step;
  if (last_step_.size() == step.size()) change -= last_step_;
  last_step_ = step;
  return allowance_ = (change.cwiseAbs() + 4.0 * noise) * (options.path_bend / 8.0) + noise;
}

}  // namespace parallel_aspects
