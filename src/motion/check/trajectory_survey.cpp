// SPDX-License-Identifier: BSD-3-Clause
#include "motion/check/trajectory_survey.h"

#include "interval/interval.h"
#include "parallel_aspects/singularity/indices.h"
#include "tracking/leg_enclosure.h"

#include <cmath>
#include <optional>

namespace parallel_aspects {
namespace {

void lower(SampledLeast& least, double value, double time, std::optional<std::size_t> leg) {
  if (value < least.value) least = {value, time, leg};
}

}  // namespace

// |Dp_j| is at most sqrt(1 + (|a_j| / L)^2), with L^2 the mean of |a_j|^2 where the platform turns; in R2
// what `anchor_bounds` has.
TrajectorySurvey::TrajectorySurvey(const Manipulator& manipulator, bool keep_samples, TrajectoryCheck& check)
    : manipulator_(manipulator), keep_samples_(keep_samples), check_(check) {
  check_.speeds.assign(manipulator.leg_count(), {});
  const RoundingUpward upward;
  const double length = manipulator.characteristic_length();
  double squared = 0.0;
  for (const Leg& leg : manipulator.legs()) squared += leg.anchor.squaredNorm() / length / length;
  squared /= static_cast<double>(manipulator.leg_count());
  lever_ = std::sqrt(1.0 + (has_rotation(manipulator.task_space()) ? squared : 0.0));
  if (manipulator.task_space() != TaskSpace::R2) return;
  const AnchorBounds bounds = anchor_bounds(manipulator);
  lever_ = std::sqrt(0.5 * (bounds.lever[0] * bounds.lever[0] + bounds.lever[1] * bounds.lever[1]));
}

void TrajectorySurvey::add(double time, const Pose& pose, const JointVector& q, double radius) {
  const double parallel = parallel_index(manipulator_, pose, q);
  const TaskVector serial = serial_indices(manipulator_, pose, q);
  lower(check_.parallel_index, parallel, time, std::nullopt);
  for (std::size_t j = 0; j < manipulator_.leg_count(); ++j)
    lower(check_.serial_index, serial[static_cast<Eigen::Index>(j)], time, j);
  if (!keep_samples_) return;
  const RoundingUpward upward;
  travel_ += lever_ * radius;
  check_.samples.push_back({time, pose, q, parallel, serial, travel_});
}

}  // namespace parallel_aspects
