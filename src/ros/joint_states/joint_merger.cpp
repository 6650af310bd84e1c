// SPDX-License-Identifier: BSD-3-Clause
#include "ros/joint_states/joint_merger.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {

double seconds_between(const ros::Time& from, const ros::Time& to) noexcept {
  return static_cast<double>(to.sec) - static_cast<double>(from.sec) +
         1e-9 * (static_cast<double>(to.nsec) - static_cast<double>(from.nsec));
}

void JointMerger::History::push(const Value& value) noexcept {
  std::copy_backward(values.begin(), values.end() - 1, values.end());
  values.front() = value;
  count = std::min(count + 1, values.size());
}

JointMerger::JointMerger(std::shared_ptr<const Manipulator> manipulator, const SampleOptions& options,
                         double window)
    : manipulator_(std::move(manipulator)),
      options_(options),
      window_(window),
      limited_(velocities_limited(*manipulator_, options)) {}

void JointMerger::forget() noexcept {
  for (History& actuation : joints_to_actuate_) actuation.count = 0;
  last_ = ros::Time();
}

std::optional<MergedJoints> JointMerger::add(const ros::Time& stamp, const JointSet& joint_values,
                                             const JointVector& q) {
  remember(stamp, joint_values, q);
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j)
    if (joints_to_actuate_[j].count == 0) return std::nullopt;
  MergedJoints merged;
  merged.q = merged.uncertainty = JointVector::Zero(q.size());
  const bool known = limited_ ? newest(merged) : bracketed(merged);
  if (!known || !(merged.stamp > last_)) return std::nullopt;
  last_ = merged.stamp;
  return merged;
}

// Angles go on from the value before, as between two samples.
void JointMerger::remember(const ros::Time& stamp, const JointSet& joint_values, const JointVector& q) {
  JointVector before = q;
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j)
    if (joints_to_actuate_[j].count > 0)
      before[static_cast<Eigen::Index>(j)] = joints_to_actuate_[j].values.front().position;
  const JointVector positions = options_.unwrap ? unwrapped(*manipulator_, before, q) : q;
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j) {
    History& actuation = joints_to_actuate_[j];
    if (!joint_values[j] || (actuation.count > 0 && !(stamp > actuation.values.front().stamp))) continue;
    actuation.push({stamp, positions[static_cast<Eigen::Index>(j)]});
  }
}

bool JointMerger::newest(MergedJoints& merged) const {
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j)
    merged.stamp = std::max(merged.stamp, joints_to_actuate_[j].values.front().stamp);
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    const Value& value = joints_to_actuate_[j].values.front();
    const double age = seconds_between(value.stamp, merged.stamp);
    if (!(age <= window_)) return false;
    merged.q[i] = value.position;
    merged.uncertainty[i] = manipulator_->leg(j).limits.velocity * (1.0 + options_.velocity_tolerance) * age;
  }
  return true;
}

bool JointMerger::bracketed(MergedJoints& merged) const {
  merged.stamp = joints_to_actuate_[0].values.front().stamp;
  for (std::size_t j = 1; j < manipulator_->leg_count(); ++j)
    merged.stamp = std::min(merged.stamp, joints_to_actuate_[j].values.front().stamp);
  for (std::size_t j = 0; j < manipulator_->leg_count(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    if (!interpolate(joints_to_actuate_[j], merged.stamp, merged.q[i], merged.uncertainty[i])) return false;
  }
  return true;
}

// Between the two values about that time; the newest is not earlier.
bool JointMerger::interpolate(const History& history, const ros::Time& stamp, double& position,
                              double& uncertainty) const {
  const auto end = history.values.begin() + static_cast<std::ptrdiff_t>(history.count);
  const auto before =
      std::find_if(history.values.begin(), end, [&](const Value& value) { return !(value.stamp > stamp); });
  if (before == end) return false;
  position = before->position;
  uncertainty = 0.0;
  if (before->stamp == stamp) return true;
  const Value& after = *(before - 1);
  const double interval = seconds_between(before->stamp, after.stamp);
  if (!(interval <= window_)) return false;
  const double step = after.position - before->position;
  const double last_step = before + 1 == end ? 0.0 : before->position - (before + 1)->position;
  position += step * seconds_between(before->stamp, stamp) / interval;
  uncertainty = options_.path_bend / 8.0 * std::abs(step - last_step);
  return true;
}

}  // namespace parallel_aspects
