// SPDX-License-Identifier: BSD-3-Clause
#include "ros/joint_states/joint_merger.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {

double seconds_between(const ros::Time& from, const ros::Time& to) noexcept {
  return static_cast<double>(to.sec) - static_cast<double>(from.sec) +
         1e-9 * (static_cast<double>(to.nsec) - static_cast<double>(from.nsec));
}

namespace {

// How far an actuated joint may be from the straight path between two values, so long after the one and
// before the other, where it is no faster than `fastest` [rad or m, and per s]. It is inside a cone from each
// value: below, with the slope of the straight path as `speed`, the nearer of the two on each side. None
// where the straight path itself is too fast, which is then the step that shows it.
double room_between(double speed, double fastest, double since, double until) {
  const double above = std::min(since * (fastest - speed), until * (fastest + speed));
  const double below = std::min(since * (fastest + speed), until * (fastest - speed));
  return std::max({0.0, above, below});
}

}  // namespace

// Of the step to the value numbered `newer` - 1 and the one before it; from rest where there is none.
double JointMerger::History::bend(std::size_t newer) const noexcept {
  const auto step = [&](std::size_t i) {
    return i < count ? values[i - 1].position - values[i].position : 0.0;
  };
  return std::abs(step(newer) - step(newer + 1));
}

void JointMerger::History::push(const Value& value) noexcept {
  std::copy_backward(values.begin(), values.end() - 1, values.end());
  values.front() = value;
  count = std::min(count + 1, values.size());
}

JointMerger::JointMerger(std::shared_ptr<const Manipulator> manipulator, const SampleOptions& options,
                         double window)
    : manipulator_(std::move(manipulator)), options_(options), window_(window) {}

void JointMerger::forget() noexcept {
  for (History& history : histories_) history.count = 0;
  last_ = ros::Time();
}

std::optional<MergedJoints> JointMerger::add(const ros::Time& stamp, const JointSet& named_joints,
                                             const JointVector& q) {
  remember(stamp, named_joints, q);
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j)
    if (histories_[j].count == 0) return std::nullopt;
  MergedJoints merged;
  merged.q = merged.uncertainty = JointVector::Zero(q.size());
  if (!bracketed(merged) || !(merged.stamp > last_)) return std::nullopt;
  last_ = merged.stamp;
  return merged;
}

// Angles go on from the value before, as between two samples.
void JointMerger::remember(const ros::Time& stamp, const JointSet& named_joints, const JointVector& q) {
  JointVector before = q;
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j)
    if (histories_[j].count > 0) before[static_cast<Eigen::Index>(j)] = histories_[j].values.front().position;
  const JointVector positions = options_.unwrap ? unwrapped(*manipulator_, before, q) : q;
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j) {
    History& history = histories_[j];
    if (!named_joints[j] || (history.count > 0 && !(stamp > history.values.front().stamp))) continue;
    history.push({stamp, positions[static_cast<Eigen::Index>(j)]});
  }
}

bool JointMerger::bracketed(MergedJoints& merged) const {
  merged.stamp = histories_[0].values.front().stamp;
  for (std::size_t j = 1; j < manipulator_->leg_count(); ++j)
    merged.stamp = std::min(merged.stamp, histories_[j].values.front().stamp);
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    if (!interpolate(histories_[j], fastest(j), merged.stamp, merged.q[i], merged.uncertainty[i]))
      return false;
  }
  return true;
}

double JointMerger::fastest(std::size_t leg) const {
  return options_.check_velocity
             ? manipulator_->leg(leg).limits.velocity * (1.0 + options_.velocity_tolerance)
             : std::numeric_limits<double>::infinity();
}

// Between the two values about that time; the newest is not earlier.
bool JointMerger::interpolate(const History& history, double fastest, const ros::Time& stamp,
                              double& position, double& uncertainty) const {
  const auto end = history.values.begin() + static_cast<std::ptrdiff_t>(history.count);
  const auto before =
      std::find_if(history.values.begin(), end, [&](const Value& value) { return !(value.stamp > stamp); });
  if (before == end) return false;
  position = before->position;
  uncertainty = 0.0;
  if (before->stamp == stamp) return true;
  const Value& after = *(before - 1);
  const double since = seconds_between(before->stamp, stamp), until = seconds_between(stamp, after.stamp);
  if (!(since + until <= window_)) return false;
  const double speed = (after.position - before->position) / (since + until);
  position += speed * since;
  const auto index = static_cast<std::size_t>(before - history.values.begin());
  const double bend = options_.path_bend / 8.0 * std::max(history.bend(index), history.bend(index + 1));
  uncertainty = std::min(bend, room_between(speed, fastest, since, until));
  return true;
}

}  // namespace parallel_aspects
