// SPDX-License-Identifier: BSD-3-Clause
#include "ros/joint_states/joint_name_watch.h"

#include "urdf/description/nearest_name.h"

#include <algorithm>
#include <string_view>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_names = 20;
constexpr std::size_t longest_name = 80;  // kept of each [characters]

using Names = std::vector<std::string>;

std::string listed(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

JointNameWatch::JointNameWatch(const Mechanism& mechanism) : own_(mechanism.joint_names()) {
  for (const Leg& leg : mechanism.manipulator()->legs()) expected_.push_back(leg.actuated_joint);
}

bool JointNameWatch::hear(const sensor_msgs::JointState& message) {
  bool heard = false;
  for (std::size_t i = 0; i < message.name.size() && !more_arrive_; ++i) {
    const std::string_view name = std::string_view(message.name[i]).substr(0, longest_name);
    if (contains(arriving_, name)) continue;
    heard = true;
    if (arriving_.size() < max_names)
      arriving_.emplace_back(name);
    else
      more_arrive_ = true;
  }
  return heard;
}

std::string JointNameWatch::guess() const {
  Names meant, written;
  for (const MeantName& each : meant_names(expected_, arriving_, own_)) {
    meant.push_back(each.name);
    written.push_back(each.written);
  }
  return meant.empty() ? "" : "did you mean " + listed(meant) + " by " + listed(written) + "?";
}

std::string JointNameWatch::with_guess(const std::string& message) const {
  const std::string meant = guess();
  return meant.empty() ? message : message + " Or " + meant;
}

void JointNameWatch::forget() noexcept {
  arriving_.clear();
  more_arrive_ = false;
}

bool JointNameWatch::lacks_an_actuated_joint() const {
  const auto arrives = [&](const std::string& name) { return contains(arriving_, name); };
  return !arriving_.empty() && !more_arrive_ && !std::all_of(expected_.begin(), expected_.end(), arrives);
}

std::string JointNameWatch::expectation() const {
  return (expected_.size() == 1 ? "joint " + listed(expected_) + " is"
                                : "joints " + listed(expected_) + " are") +
         " expected";
}

std::string JointNameWatch::comparison() const {
  const std::string found = guess();
  const bool one = arriving_.size() == 1 && !more_arrive_;
  return expectation() + ", and " + listed(arriving_) + (more_arrive_ ? " and others" : "") +
         (one ? " arrives" : " arrive") +
         (found.empty() ? "; remap joint_states, or correct mechanism/actuated_joints." : "; " + found);
}

}  // namespace parallel_aspects
