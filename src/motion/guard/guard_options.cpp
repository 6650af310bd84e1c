// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/motion_guard.h"

#include <cmath>

namespace parallel_aspects {

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
