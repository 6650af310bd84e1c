// SPDX-License-Identifier: BSD-3-Clause
#include "ros/monitor/frame_watch.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

// A publisher that was heard so lately still publishes; static transforms come once, all of them where one
// connects.
const ros::WallDuration alive(2.0);

constexpr std::size_t most_frames = 100000;  // remembered

}  // namespace

std::string FrameWatch::hear(const std::string& name, const std::string& publisher, Topic topic,
                             const ros::WallTime& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (frames_.size() >= most_frames) frames_.clear();
  Frame& frame = frames_[name];
  const bool disputed =
      !frame.publisher.empty() && frame.publisher != publisher && now - frame.heard <= alive;
  const bool said = !frame.disputed.isZero();
  if (disputed) {
    frame.other = frame.publisher;
    frame.disputed = now;
    frame.disputed_for_good = topic == Topic::tf_static;
  }
  frame.publisher = publisher;
  frame.heard = now;
  return disputed && !said ? message(name, frame) : std::string();
}

std::string FrameWatch::message(const ros::WallTime& now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto is_disputed = [&](const auto& named) {
    const Frame& frame = named.second;
    return frame.disputed_for_good || (!frame.disputed.isZero() && now - frame.disputed <= alive + alive);
  };
  const auto first = std::find_if(frames_.begin(), frames_.end(), is_disputed);
  return first == frames_.end() ? std::string() : message(first->first, first->second);
}

std::string FrameWatch::message(const std::string& name, const Frame& frame) const {
  const auto& [one, two] = std::minmax(frame.publisher, frame.other);
  const bool is_own = name.compare(0, own_.size(), own_) == 0;
  return "Both " + one + " and " + two + " publish the tf frame " + name + "; " +
         (is_own ? "give one of them another frame_prefix."
                 : "stop one of them, or rename the links of one robot.");
}

}  // namespace parallel_aspects
