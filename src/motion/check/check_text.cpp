// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/check_text.h"

#include "model/message_text.h"
#include "parallel_aspects/singularity/indices.h"

#include <cmath>

namespace parallel_aspects {
namespace {

// Of times, lengths and angles; products of a few of them are finite [s, m, rad].
constexpr double largest_number = 1e12;

}  // namespace

std::string violation_text(const Manipulator& manipulator, const TrajectoryViolation& violation) {
  const std::string leg = violation.leg ? "leg '" + manipulator.leg(*violation.leg).name + "'" : "a leg";
  switch (violation.kind) {
    case Violation::out_of_reach:
      return leg + " gets stretched or folded (B_jj = 0) or cannot reach";
    case Violation::joint_limit:
      return "the actuated joint of " + leg + " leaves its limits (constraint actuated_limits)";
    case Violation::constraint:
      return "the constraint " + std::string(name(violation.constraint.value_or(ConstraintKind::workspace))) +
             " is violated";
    case Violation::singularity:
    case Violation::none:
      break;
  }
  return "det A vanishes";
}

std::string safe_text() {
  return "Proved: no singularity is met, every leg reaches and all constraints hold, at every time.";
}

std::string passed_text() {
  return "Proved: det A does not vanish, every leg reaches and all limits hold, at every time; legs pass "
         "serial singularities, as listed.";
}

std::array<std::string, 2> bracket_text(double after, double before) {
  constexpr int fewest_digits = 9, most_digits = 17;
  std::array<std::string, 2> text;
  for (int digits = fewest_digits; digits <= most_digits && text[0] == text[1]; ++digits)
    text = {number_text(after, digits), number_text(before, digits)};
  return after == before ? std::array{number_text(after, fewest_digits), number_text(before, fewest_digits)}
                         : text;
}

std::string unsafe_text(const Manipulator& manipulator, const TrajectoryViolation& violation) {
  const std::string what = "Proved: " + violation_text(manipulator, violation);
  const auto [after, before] = bracket_text(violation.after, violation.before);
  return after == before ? what + " at " + before + " s."
                         : what + " between " + after + " s and " + before + " s.";
}

bool is_usable_number(double value) noexcept { return std::abs(value) <= largest_number; }

std::string missed_at_start(const Manipulator& manipulator, const Pose& pose, const JointVector& q) {
  const bool asked = manipulator.constraints().margins.any() &&
                     manipulator.constraint_kinds()[index_of(ConstraintKind::margins)];
  const std::string missed = asked ? missed_margins(manipulator, pose, q) : "";
  return missed.empty() ? ""
                        : "The start does not keep the margins: " + missed +
                              "; start farther from singularities, or lower the margin.";
}

std::string undecided_text(double free_until, const std::string& why) {
  return "Proved free until " + number_text(free_until, 9) + " s; just after it " + why + ".";
}

std::string not_followed_text(double followed_until, const std::string& why) {
  return "Not followed further than " + number_text(followed_until, 9) + " s, since there " + why + ".";
}

std::string near_something_text() { return "it comes too near to a singularity or a limit to be determined"; }

std::string waypoint_text(std::size_t index) { return "Waypoint " + std::to_string(index + 1); }

bool is_crossing(Violation kind) { return kind == Violation::singularity || kind == Violation::out_of_reach; }

TrajectoryCheck refused(const Problems& problems) {
  TrajectoryCheck check;
  check.reason = problems.front();
  check.refused = true;
  return check;
}

std::string exceeded_speeds(const Manipulator& manipulator, const TrajectoryCheck& check, bool proved) {
  std::string text;
  for (std::size_t j = 0; j < check.speeds.size(); ++j) {
    const Leg& leg = manipulator.leg(j);
    const FastestMotion& speed = check.speeds[j];
    const bool exceeds = speed.value > leg.limits.velocity;
    if (speed.bound <= leg.limits.velocity || exceeds != proved) continue;
    text += (text.empty() ? "" : ", ") + std::string("'") + leg.actuated_joint + "' at " +
            (exceeds ? "" : "up to ") + number_text(exceeds ? speed.value : speed.bound) +
            (leg.actuated_by_angle() ? " rad/s" : " m/s") + ", limit " + number_text(leg.limits.velocity);
  }
  return text;
}

}  // namespace parallel_aspects
