// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/log_queue.h"

#include <ros/console.h>

#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t most_lines = 100;  // between two writes
const ros::WallDuration between_warnings(5.0);

}  // namespace

void LogQueue::say(std::string line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (lines_.size() < most_lines)
    lines_.push_back(std::move(line));
  else
    ++dropped_;
}

void LogQueue::warn(std::string line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  warning_ = std::move(line);
}

void LogQueue::write() {
  std::vector<std::string> lines;
  std::string warning;
  std::size_t dropped = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    lines = std::exchange(lines_, {});
    dropped = std::exchange(dropped_, 0);
    const ros::WallTime now = ros::WallTime::now();
    if (!warning_.empty() && now - warned_ > between_warnings) {
      warning = std::exchange(warning_, {});
      warned_ = now;
    }
  }
  for (const std::string& line : lines) ROS_INFO_STREAM(line);
  if (dropped > 0) ROS_INFO_STREAM("and " << dropped << " more transitions");
  if (!warning.empty()) ROS_WARN_STREAM(warning);
}

}  // namespace parallel_aspects
