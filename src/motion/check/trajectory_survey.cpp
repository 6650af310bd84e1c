// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/trajectory_survey.h"

#include "model/number_text.h"
#include "motion/roadmap.h"
#include "parallel_aspects/singularity/indices.h"

#include <cmath>

namespace parallel_aspects {
namespace {

void lower(SampledLeast& least, double value, double time, std::size_t leg) {
  if (value < least.value) least = {value, time, leg};
}

}  // namespace

TrajectorySurvey::TrajectorySurvey(const Manipulator& manipulator, TrajectoryCheck& check)
    : manipulator_(manipulator), check_(check) {
  check_.speeds.assign(manipulator.leg_count(), {});
}

void TrajectorySurvey::add(double time, const Pose& pose, const JointVector& q) {
  lower(check_.parallel_index, parallel_index(manipulator_, pose, q), time, 0);
  const TaskVector serial = serial_indices(manipulator_, pose, q);
  for (std::size_t j = 0; j < manipulator_.leg_count(); ++j)
    lower(check_.serial_index, serial[static_cast<Eigen::Index>(j)], time, j);
  if (last_.size() > 0 && time > last_time_) add_speeds(time, q);
  last_time_ = time;
  last_ = q;
}

void TrajectorySurvey::add_speeds(double time, const JointVector& q) {
  const JointVector change = joint_change(manipulator_, last_, q);
  for (std::size_t j = 0; j < manipulator_.leg_count(); ++j) {
    const double speed = std::abs(change[static_cast<Eigen::Index>(j)]) / (time - last_time_);
    if (speed > check_.speeds[j].value) check_.speeds[j] = {speed, time};
  }
}

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

std::string unsafe_text(const Manipulator& manipulator, const TrajectoryViolation& violation) {
  return "Proved: " + violation_text(manipulator, violation) + " between " + number_text(violation.after, 9) +
         " s and " + number_text(violation.before, 9) + " s.";
}

std::string exceeded_speeds(const Manipulator& manipulator, const TrajectoryCheck& check) {
  std::string text;
  for (std::size_t j = 0; j < check.speeds.size(); ++j) {
    const Leg& leg = manipulator.leg(j);
    if (!(check.speeds[j].value > leg.limits.velocity)) continue;
    text += (text.empty() ? "" : ", ") + std::string("'") + leg.actuated_joint + "' at " +
            number_text(check.speeds[j].value) + (leg.actuated_by_angle() ? " rad/s" : " m/s") + ", limit " +
            number_text(leg.limits.velocity);
  }
  return text;
}

}  // namespace parallel_aspects
