// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/hazard_watch.h"

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/motion/motion_guard.h"
#include "ros/messages/hazard_messages.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double speed_window = 0.2;  // over which approach is examined [s]

}  // namespace

HazardWatch::HazardWatch(std::shared_ptr<const Manipulator> manipulator,
                         const DistanceThresholds::Options& thresholds)
    : manipulator_(std::move(manipulator)), unit_(*manipulator_), thresholds_(thresholds) {
  speeds_.fill(ApproachSpeed(speed_window));
  findings_.distances.fill(unknown_distance());
}

void HazardWatch::take(MeasuredHazards measured, double time) {
  if (measured_ && !(measured_->mode == measured.mode))
    for (ApproachSpeed& speed : speeds_) speed.forget();
  for (std::size_t i = 0; i < hazard_count; ++i) {
    DistanceBounds& bounds = measured.bounds[i];
    speeds_[i].add(time, std::isfinite(bounds.upper) ? bounds.upper : bounds.lower);
    if (speeds_[i].known()) bounds.speed = speeds_[i].speed();
  }
  measured_ = std::move(measured);
}

// Distances to boundaries of another working mode say nothing here, but for that to serial singularities,
// which are the same poses in every mode.
void HazardWatch::bound_distances(const TrackedState& tracked) {
  findings_.distances.fill(unknown_distance());
  findings_.stand_off = std::numeric_limits<double>::quiet_NaN();
  if (!measured_) return;
  const double by = anchor_distance(*manipulator_, measured_->pose, tracked.pose) + tracked.spread;
  const bool same = measured_->mode == tracked.mode;
  if (same) findings_.stand_off = measured_->stand_off;
  for (std::size_t i = 0; i < hazard_count; ++i)
    if (same || i == static_cast<std::size_t>(Hazard::serial_singularity))
      findings_.distances[i] = after_motion(measured_->bounds[i], by, manipulator_->size());
}

void HazardWatch::judge(const TrackedState& tracked, double residual, const ros::Time& epoch,
                        AspectState& state) {
  bound_distances(tracked);
  DistanceThresholds::Distances lower;
  HazardMemory::Speeds speeds;
  for (std::size_t i = 0; i < hazard_count; ++i) {
    lower[i] = findings_.distances[i].lower;
    speeds[i] = findings_.distances[i].speed;
  }
  findings_.threshold = thresholds_.update(lower);
  findings_.residual = residual;
  memory_.see(thresholds_, speeds, tracked.time);
  state.parallel_distance = findings_.distances[0];
  state.stand_off = findings_.stand_off;
  state.serial_distance = findings_.distances[1];
  state.limit_distance = findings_.distances[2];
  state.level = level_message(findings_.threshold.level);
  state.reason = reason_of(findings_.threshold, unit_);
  state.last_hazard = hazard_message(memory_.reported(), epoch);
  state.residual = residual;
  show_escape(tracked, state);
}

void HazardWatch::show_escape(const TrackedState& tracked, AspectState& state) const {
  if (!measured_ || !(measured_->mode == tracked.mode)) return;
  const TaskVector& towards = measured_->towards[static_cast<std::size_t>(findings_.threshold.hazard)];
  if (towards.size() == 0) return;
  const JointVector rates = joint_velocities(*manipulator_, tracked.pose, tracked.q, -towards);
  state.escape_twist.resize(static_cast<std::size_t>(towards.size()));
  std::transform(towards.data(), towards.data() + towards.size(), state.escape_twist.begin(),
                 std::negate<double>());
  if (rates.allFinite()) state.escape_joint_velocities.assign(rates.data(), rates.data() + rates.size());
}

ProvedDistances HazardWatch::proved() const noexcept {
  ProvedDistances proved;
  if (!measured_) return proved;
  proved.pose = measured_->pose;
  proved.mode = measured_->mode;
  for (std::size_t i = 0; i < hazard_count; ++i) proved.lower[i] = measured_->bounds[i].lower;
  return proved;
}

void HazardWatch::lose(const ros::Time& epoch, AspectState& state) {
  findings_.threshold = thresholds_.lose();
  memory_.lose();
  state.last_hazard = hazard_message(memory_.reported(), epoch);
  state.reason = reason_of(memory_.reported(), unit_);
}

void HazardWatch::forget_measured() {
  measured_.reset();
  for (ApproachSpeed& speed : speeds_) speed.forget();
}

void HazardWatch::forget() {
  forget_measured();
  memory_.forget();
  findings_.distances.fill(unknown_distance());
}

}  // namespace parallel_aspects
