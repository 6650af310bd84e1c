// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/trajectory_survey.h"

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

}  // namespace parallel_aspects
