// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/log_queue.h"

#include <ros/console.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr std::size_t max_lines = 100;  // between two writes
constexpr std::size_t max_causes = 10;  // within the time below, whatever arrives
const ros::WallDuration between_warnings(5.0);

// The words that are no numbers.
std::string cause_of(const std::string& line) {
  std::istringstream words(line);
  std::string cause;
  for (std::string word; words >> word;)
    if (word.find_first_of("0123456789") > 1) cause += word + ' ';
  return cause;
}

}  // namespace

void LogQueue::say(std::string line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (lines_.size() < max_lines)
    lines_.push_back(std::move(line));
  else
    ++dropped_;
}

void LogQueue::warn(std::string line, const ros::SteadyTime& now) {
  const std::string cause = cause_of(line);
  const std::lock_guard<std::mutex> lock(mutex_);
  may_withdraw_ = true;
  const auto known = std::find_if(warnings_.begin(), warnings_.end(),
                                  [&](const Warning& warning) { return warning.cause == cause; });
  if (known != warnings_.end()) {
    known->line = std::move(line);
    known->due = known->due || now - known->written > between_warnings;
  } else if (warnings_.size() < max_causes) {
    warnings_.push_back({cause, std::move(line), {}, true});
  }
}

void LogQueue::withdraw() {
  if (!may_withdraw_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  may_withdraw_ = false;
  for (Warning& warning : warnings_)
    if (!warning.due) warning.line.clear();
}

std::vector<std::string> LogQueue::take_warnings(const ros::SteadyTime& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<std::string> due;
  const auto rests = [&](const Warning& warning) {
    return !warning.written.isZero() && now - warning.written <= between_warnings;
  };
  for (Warning& warning : warnings_) {
    if (rests(warning) || warning.line.empty()) continue;
    due.push_back(std::exchange(warning.line, {}));
    warning.written = now;
    warning.due = false;
  }
  warnings_.erase(std::remove_if(warnings_.begin(), warnings_.end(),
                                 [&](const Warning& warning) { return !rests(warning); }),
                  warnings_.end());
  return due;
}

void LogQueue::write() {
  std::vector<std::string> lines;
  std::size_t dropped = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    lines = std::exchange(lines_, {});
    dropped = std::exchange(dropped_, 0);
  }
  for (const std::string& line : take_warnings(ros::SteadyTime::now())) ROS_WARN_STREAM(line);
  for (const std::string& line : lines) ROS_INFO_STREAM(line);
  if (dropped > 0) ROS_INFO_STREAM("and " << dropped << " more transitions");
}

}  // namespace parallel_aspects
