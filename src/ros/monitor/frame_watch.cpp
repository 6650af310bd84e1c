// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/frame_watch.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

// A publisher that was heard so lately still publishes; static transforms come once, all of them where one
// connects.
const ros::WallDuration alive(2.0);

const ros::WallDuration all_heard(1.0);  // by then each of two nodes has published all its frames

constexpr std::size_t max_frames = 1000, max_disputes = 20;  // remembered

}  // namespace

void FrameWatch::hear(const std::string& name, const std::string& publisher, Topic topic,
                      const ros::WallTime& now) {
  if (name.compare(0, own_.size(), own_) != 0 && links_.count(name) == 0) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (frames_.size() >= max_frames) frames_.clear();
  const Frame before = std::exchange(frames_[name], {publisher, now});
  if (before.publisher.empty() || before.publisher == publisher || now - before.heard > alive) return;
  const Nodes nodes = std::minmax(before.publisher, publisher);
  if (disputes_.size() >= max_disputes && disputes_.count(nodes) == 0) return;
  Dispute& dispute = disputes_[nodes];
  if (dispute.frames.empty()) dispute.first = now;
  if (dispute.frames.size() < max_frames) dispute.frames.insert(name);
  dispute.last = now;
  dispute.for_good = dispute.for_good || topic == Topic::tf_static;
}

std::vector<std::string> FrameWatch::news(const ros::WallTime& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::string> messages;
  for (auto& [nodes, dispute] : disputes_)
    if (!dispute.said && now - dispute.first >= all_heard &&
        (dispute.for_good || now - dispute.last <= all_heard)) {
      messages.push_back(message(nodes, dispute));
      dispute.said = true;
    }
  return messages;
}

std::string FrameWatch::message(const ros::WallTime& now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::string messages;
  for (const auto& [nodes, dispute] : disputes_)
    if (dispute.for_good || now - dispute.last <= alive + alive)
      messages += (messages.empty() ? "" : " ") + message(nodes, dispute);
  return messages;
}

std::string FrameWatch::message(const Nodes& nodes, const Dispute& dispute) {
  const std::string frame = *dispute.frames.begin();
  const std::size_t count = dispute.frames.size();
  return "Both " + nodes.first + " and " + nodes.second + " publish " +
         (count == 1 ? "the tf frame " + frame
                     : std::to_string(count) + " tf frames of this robot, such as " + frame) +
         "; stop one of them, or give one of the two robots another frame_prefix: an argument of "
         "aspects.launch, or ~frame_prefix of its monitor and tf_prefix of its robot_state_publisher.";
}

}  // namespace parallel_aspects
