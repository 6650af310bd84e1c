// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/ros/joint_sample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

// Beyond this, angles are no longer exact to a ten-millionth of a degree; no drive gets there [rad or m].
constexpr double largest_position = 1e6;

JointSample invalid(std::string sentence) { return {SampleStatus::invalid, std::move(sentence), {}, {}}; }

// Fills `sample.q` from the message; leaves `count` at how many of the robot's drives it holds.
JointSample collect(const Manipulator& manipulator, const std::vector<std::string>& names,
                    const std::vector<double>& positions, std::size_t& count) {
  JointSample sample{SampleStatus::usable, {}, JointVector(manipulator.leg_count()), {}};
  std::string missing;
  count = 0;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const std::string& joint = manipulator.leg(j).driven_joint;
    const auto found = std::find(names.begin(), names.end(), joint);
    if (found == names.end()) {
      missing += (missing.empty() ? "" : ", ") + joint;
      continue;
    }
    ++count;
    if (std::find(found + 1, names.end(), joint) != names.end())
      return invalid("joint " + joint + " is there twice; publish each joint once.");
    const double value = positions[static_cast<std::size_t>(found - names.begin())];
    if (!std::isfinite(value)) return invalid("position of joint " + joint + " is not a finite number.");
    if (std::abs(value) > largest_position)
      return invalid("position of joint " + joint + " is beyond a million rad or m; check its unit.");
    sample.q[static_cast<Eigen::Index>(j)] = value;
  }
  if (!missing.empty())
    return invalid("actuated joint " + missing + " is missing; publish all of them in one message.");
  return sample;
}

bool fits(std::size_t size, std::size_t names) { return size == 0 || size == names; }

}  // namespace

JointSampleReader::JointSampleReader(std::shared_ptr<const Mechanism> mechanism)
    : mechanism_(std::move(mechanism)) {}

JointSample JointSampleReader::read(const sensor_msgs::JointState& message) const {
  const std::size_t names = message.name.size();
  if (names == 0) return invalid("it names no joint.");
  if (message.position.size() != names || !fits(message.velocity.size(), names) ||
      !fits(message.effort.size(), names))
    return invalid("it has " + std::to_string(names) + " names, but " +
                   std::to_string(message.position.size()) + " positions, " +
                   std::to_string(message.velocity.size()) + " velocities and " +
                   std::to_string(message.effort.size()) + " efforts.");
  std::size_t count = 0;
  JointSample sample = collect(*mechanism_->manipulator(), message.name, message.position, count);
  const auto& known = mechanism_->joint_names();
  const auto unknown = std::find_if(message.name.begin(), message.name.end(), [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) == known.end();
  });
  if (count == 0 && sample.status == SampleStatus::invalid && unknown != message.name.end())
    return {SampleStatus::foreign, "it holds none of the actuated joints.", {}, {}};
  if (sample.status == SampleStatus::usable && unknown != message.name.end())
    sample.sentence = "joint " + *unknown + " is not in the URDF and is ignored.";
  if (sample.status == SampleStatus::usable) sample.readings = joint_readings(*mechanism_, message);
  return sample;
}

Eigen::VectorXd joint_readings(const Mechanism& mechanism, const sensor_msgs::JointState& message) {
  const auto& names = mechanism.joint_names();
  Eigen::VectorXd readings = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(names.size()),
                                                       std::numeric_limits<double>::quiet_NaN());
  const std::size_t count = std::min(message.name.size(), message.position.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = std::find(names.begin(), names.end(), message.name[i]);
    if (found != names.end() && std::abs(message.position[i]) <= largest_position)
      readings[found - names.begin()] = message.position[i];
  }
  return readings;
}

JointSample actuated_values(const Manipulator& manipulator, const std::vector<std::string>& names,
                            const std::vector<double>& positions) {
  if (names.size() != positions.size())
    return invalid("there are " + std::to_string(names.size()) + " names, but " +
                   std::to_string(positions.size()) + " positions.");
  std::size_t count = 0;
  return collect(manipulator, names, positions, count);
}

}  // namespace parallel_aspects
