// SPDX-License-Identifier: BSD-3-Clause
#include "ros/joint_states/joint_sample.h"

#include "ros/messages/not_a_number.h"
#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

// Beyond this, angles are no longer exact to a ten-millionth of a degree; no actuated joint gets there [rad
// or m].
constexpr double largest_position = 1e6;

JointSample invalid(std::string message) { return {SampleStatus::invalid, std::move(message), {}, {}, {}}; }

JointSet actuated_joints_named(const Manipulator& manipulator, const std::vector<std::string>& names) {
  JointSet named_joints;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j)
    named_joints[j] = std::find(names.begin(), names.end(), manipulator.leg(j).actuated_joint) != names.end();
  return named_joints;
}

// What is wrong with the position of an actuated joint, or empty.
std::string fault_of(const std::string& joint, const std::vector<std::string>& names, double position) {
  if (std::count(names.begin(), names.end(), joint) > 1)
    return "joint " + joint + " is there twice; give each joint once.";
  if (!std::isfinite(position)) return "position of joint " + joint + " is not a finite number.";
  if (std::abs(position) > largest_position)
    return "position of joint " + joint + " is beyond a million rad or m; check its unit.";
  return {};
}

// The robot's actuated joints in the message.
JointSample collect(const Manipulator& manipulator, const std::vector<std::string>& names,
                    const std::vector<double>& positions) {
  JointSample sample{SampleStatus::usable, {}, {}, JointVector(manipulator.leg_count()), {}};
  std::string missing;
  int missed = 0;
  for (std::size_t j = 0; j < manipulator.leg_count(); ++j) {
    const std::string& joint = manipulator.leg(j).actuated_joint;
    double& value = sample.q[static_cast<Eigen::Index>(j)];
    const auto found = std::find(names.begin(), names.end(), joint);
    if (found == names.end()) {
      missing += (missed++ == 0 ? "" : ", ") + joint;
      value = not_a_number;
      continue;
    }
    value = positions[static_cast<std::size_t>(found - names.begin())];
    const std::string fault = fault_of(joint, names, value);
    if (!fault.empty()) return invalid(fault);
  }
  if (missing.empty()) return sample;
  sample.status = SampleStatus::partial;
  sample.message = missed == 1 ? "actuated joint " + missing + " is missing."
                               : "actuated joints " + missing + " are missing.";
  return sample;
}

// Which of the names may be meant by the actuated joints that are missing.
std::string guesses(const Manipulator& manipulator, const std::vector<std::string>& names) {
  std::vector<std::string> actuated;
  for (const Leg& leg : manipulator.legs()) actuated.push_back(leg.actuated_joint);
  std::string text;
  for (const MeantName& meant : meant_names(actuated, names, actuated))
    text += " Did you mean " + meant.name + " by " + meant.written + "?";
  return text;
}

bool fits(std::size_t size, std::size_t names) { return size == 0 || size == names; }

}  // namespace

JointSampleReader::JointSampleReader(std::shared_ptr<const Mechanism> mechanism)
    : mechanism_(std::move(mechanism)) {}

JointSample JointSampleReader::read(const sensor_msgs::JointState& message) const {
  const JointSet named_joints = actuated_joints_named(*mechanism_->manipulator(), message.name);
  JointSample sample = read(message, named_joints);
  sample.named_joints = named_joints;
  return sample;
}

JointSample JointSampleReader::read(const sensor_msgs::JointState& message,
                                    const JointSet& named_joints) const {
  const std::size_t names = message.name.size();
  if (names == 0) return invalid("it names no joint.");
  if (message.position.size() != names || !fits(message.velocity.size(), names) ||
      !fits(message.effort.size(), names))
    return invalid("its lists do not fit: name has length " + std::to_string(names) + ", position " +
                   std::to_string(message.position.size()) + ", velocity " +
                   std::to_string(message.velocity.size()) + ", effort " +
                   std::to_string(message.effort.size()) + ".");
  if (named_joints.none())
    return {SampleStatus::foreign, "it holds none of the actuated joints.", {}, {}, {}};
  JointSample sample = collect(*mechanism_->manipulator(), message.name, message.position);
  if (sample.status != SampleStatus::usable) return sample;
  const auto& known = mechanism_->joint_names();
  const auto unknown = std::find_if(message.name.begin(), message.name.end(), [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) == known.end();
  });
  if (unknown != message.name.end())
    sample.message = "joint " + *unknown + " is not in the URDF and is ignored.";
  sample.readings = joint_readings(*mechanism_, message);
  return sample;
}

Eigen::VectorXd joint_readings(const Mechanism& mechanism, const sensor_msgs::JointState& message) {
  const auto& names = mechanism.joint_names();
  Eigen::VectorXd readings = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(names.size()), not_a_number);
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
    return invalid("joint_names has length " + std::to_string(names.size()) + ", joint_positions " +
                   std::to_string(positions.size()) + "; give each name one position.");
  JointSample sample = collect(manipulator, names, positions);
  if (sample.status == SampleStatus::partial) sample.message += guesses(manipulator, names);
  return sample;
}

}  // namespace parallel_aspects
