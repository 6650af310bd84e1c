// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/tracking/hazards.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

bool has_any(const ThresholdOptions& options) { return options.warn != 0.0 || options.stop != 0.0; }

// A level is entered below its threshold, and left above that by the hysteresis.
bool inside(double distance, double threshold, double hysteresis, bool was_inside) {
  if (threshold == 0.0) return false;
  return distance < threshold || (was_inside && distance < threshold * (1.0 + hysteresis));
}

ThresholdLevel next_level(const ThresholdOptions& options, double distance, ThresholdLevel before) {
  if (!has_any(options)) return ThresholdLevel::clear;
  if (std::isnan(distance)) return ThresholdLevel::unknown;
  const bool stopped = before == ThresholdLevel::stop;
  if (inside(distance, options.stop, options.hysteresis, stopped)) return ThresholdLevel::stop;
  if (inside(distance, options.warn, options.hysteresis, stopped || before == ThresholdLevel::warn))
    return ThresholdLevel::warn;
  return ThresholdLevel::clear;
}

bool nearer(double a, double b) { return std::isnan(b) ? !std::isnan(a) : a < b; }

}  // namespace

const char* name(Hazard hazard) noexcept {
  switch (hazard) {
    case Hazard::parallel_singularity:
      return "parallel singularity";
    case Hazard::serial_singularity:
      return "serial singularity";
    case Hazard::limit:
      break;
  }
  return "limit";
}

const char* name(ThresholdLevel level) noexcept {
  switch (level) {
    case ThresholdLevel::unknown:
      return "unknown";
    case ThresholdLevel::clear:
      return "clear";
    case ThresholdLevel::warn:
      return "warn";
    case ThresholdLevel::unset:
      return "no threshold";
    case ThresholdLevel::stop:
      break;
  }
  return "stop";
}

std::vector<std::string> problems_of(const ThresholdOptions& options) {
  std::vector<std::string> problems;
  const auto check = [&](double value, const std::string& what) {
    if (!std::isfinite(value) || value < 0.0)
      problems.push_back("The " + what + " is " + std::to_string(value) +
                         "; it must be finite and not negative, and 0 for none.");
  };
  check(options.warn, "warn threshold");
  check(options.stop, "stop threshold");
  check(options.hysteresis, "hysteresis");
  if (problems.empty() && options.warn > 0.0 && options.stop > options.warn)
    problems.push_back("The stop threshold of " + std::to_string(options.stop) +
                       " m is above the warn threshold of " + std::to_string(options.warn) +
                       " m; exchange them.");
  return problems;
}

bool is_set(const DistanceThresholds::Options& options) noexcept {
  return std::any_of(options.begin(), options.end(), has_any);
}

void DistanceThresholds::set_options(const Options& options) noexcept {
  options_ = options;
  is_set_ = is_set(options);
  known_.fill(ThresholdLevel::clear);
  lose();
}

const ThresholdState& DistanceThresholds::lose() noexcept {
  levels_.fill(ThresholdLevel::unknown);
  return state_ = {};
}

const ThresholdState& DistanceThresholds::update(const Distances& distances) noexcept {
  std::size_t worst = 0;
  for (std::size_t i = 0; i < hazard_count; ++i) {
    levels_[i] = next_level(options_[i], distances[i], known_[i]);
    if (levels_[i] != ThresholdLevel::unknown) known_[i] = levels_[i];
    if (levels_[i] > levels_[worst] ||
        (levels_[i] == levels_[worst] && nearer(distances[i], distances[worst])))
      worst = i;
  }
  const ThresholdLevel level = is_set_ ? levels_[worst] : ThresholdLevel::unset;
  const double threshold = level == ThresholdLevel::stop   ? options_[worst].stop
                           : level == ThresholdLevel::warn ? options_[worst].warn
                                                           : 0.0;
  return state_ = {level, static_cast<Hazard>(worst), distances[worst], threshold,
                   threshold > 0.0 && distances[worst] >= threshold};
}

const char* name(Approach approach) noexcept {
  switch (approach) {
    case Approach::approaching:
      return "approaching";
    case Approach::leaving:
      return "leaving";
    case Approach::steady:
      return "steady";
    case Approach::unknown:
      break;
  }
  return "unknown";
}

void ApproachSpeed::add(double time, double value) noexcept {
  if (!std::isfinite(time) || !std::isfinite(value) || (count_ > 0 && !(time > newest(0).time))) forget();
  if (!std::isfinite(time) || !std::isfinite(value)) return;
  samples_[next_] = {time, value};
  next_ = (next_ + 1) % most;
  count_ = std::min(count_ + 1, most);
  while (count_ > 2 && newest(count_ - 1).time < time - window_) --count_;
}

double ApproachSpeed::speed() const noexcept {
  if (!known()) return 0.0;
  // About the newest sample, so that large times lose nothing.
  const Sample origin = newest(0);
  double t = 0.0, v = 0.0, tt = 0.0, tv = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double dt = newest(i).time - origin.time, dv = newest(i).value - origin.value;
    t += dt;
    v += dv;
    tt += dt * dt;
    tv += dt * dv;
  }
  const auto n = static_cast<double>(count_);
  const double spread = n * tt - t * t;
  return spread > 0.0 ? (n * tv - t * v) / spread : 0.0;
}

Approach ApproachSpeed::approach() const noexcept {
  if (!known()) return Approach::unknown;
  const double now = speed();
  if (now < -steady_) return Approach::approaching;
  return now > steady_ ? Approach::leaving : Approach::steady;
}

void HazardMemory::see(const DistanceThresholds& thresholds, const Speeds& speeds, double time) noexcept {
  const ThresholdState& state = thresholds.state();
  if (state.level == ThresholdLevel::unknown) return lose();
  if (reported_ && thresholds.level(reported_->hazard) == ThresholdLevel::clear) reported_.reset();
  if (std::isfinite(state.distance))
    last_ = {state.hazard, state.distance, speeds[static_cast<std::size_t>(state.hazard)], time};
}

void HazardMemory::lose() noexcept {
  if (last_) reported_ = last_;
}

}  // namespace parallel_aspects
