// SPDX-License-Identifier: BSD-3-Clause
#include "motion/rehearsal.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double slowest = 8.0;  // times the duration that was asked for

// How long the actuated joints need for a straight change at least [s].
double least_time(const Manipulator& manipulator, const JointVector& change) {
  double seconds = 0.0;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    seconds = std::max(seconds,
                       std::abs(change[static_cast<Eigen::Index>(j)]) / manipulator.leg(j).limits.velocity);
  return seconds;
}

}  // namespace

SampledMotion sampled(const Manipulator& manipulator, const std::vector<JointVector>& corners,
                      double duration, double interval) {
  double length = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).norm();
  SampledMotion motion;
  motion.gain = corners.back() - corners.front();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const JointVector change = corners[i] - corners[i - 1];
    if (!(change.norm() > 0.0)) continue;
    const double seconds = std::max(duration * change.norm() / length, least_time(manipulator, change));
    const double steps = std::max(1.0, std::ceil(seconds / interval));
    for (double step = 0.0; step < steps; ++step)
      motion.samples.push_back(corners[i - 1] + step / steps * change);
  }
  return motion;
}

Rehearsal::Rehearsal(std::shared_ptr<const Manipulator> manipulator, const TrackerOptions& options,
                     double interval)
    : manipulator_(std::move(manipulator)),
      tracker_(manipulator_, options),
      interval_(interval),
      offset_(JointVector::Zero(static_cast<Eigen::Index>(manipulator_->leg_count()))) {}

bool Rehearsal::start(const Pose& pose, const JointVector& q) {
  count_ = 0;
  offset_.setZero();
  tracker_.stop();
  return tracker_.start_near(0.0, q, pose, 1e-6 * manipulator_->size());
}

bool Rehearsal::play(const SampledMotion& motion) {
  Rehearsal attempt = *this;
  for (const JointVector& sample : motion.samples) {
    const double time = interval_ * static_cast<double>(++attempt.count_);
    if (!attempt.tracker_.update(time, sample + offset_).followed()) return false;
  }
  attempt.offset_ += motion.gain;
  *this = std::move(attempt);
  return true;
}

SampledMotion Rehearsal::slow_enough(const std::vector<JointVector>& corners, double duration) const {
  for (double factor = 1.0; factor <= slowest; factor *= 2.0) {
    SampledMotion motion = sampled(*manipulator_, corners, factor * duration, interval_);
    Rehearsal attempt = *this;
    if (attempt.play(motion) && attempt.play(motion)) return motion;
  }
  return {};
}

}  // namespace parallel_aspects
