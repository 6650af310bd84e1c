// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_LOG_QUEUE_H
#define PARALLEL_ASPECTS_ROS_NODE_LOG_QUEUE_H

#include <ros/time.h>

#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Takes lines for the log from a thread that must not wait for a terminal, and writes them from another.
class LogQueue {
 public:
  void say(std::string line);

  /// A warning with another cause than those of the last five seconds is written at once; one cause is
  /// written at most every five seconds, the newest line of it then. Lines that differ in numbers alone have
  /// one cause.
  void warn(std::string line, const ros::SteadyTime& now = ros::SteadyTime::now());

  /// All is well: what was still to be written five seconds after the last of its cause is not true any more.
  /// Takes no lock where no warning came since the last time, so that it may be called at every sample.
  void withdraw();

  /// Writes what has come in since, warnings first: what a transition ended is not the last that is read.
  void write();

  /// The warnings that `write` would write at this time; none comes twice.
  std::vector<std::string> take_warnings(const ros::SteadyTime& now);

 private:
  struct Warning {
    std::string cause, line;  // the line is empty once it is written
    ros::SteadyTime written;  // zero for never
    bool due = true;          // came when the cause was new, or five seconds old
  };

  std::mutex mutex_;
  std::vector<std::string> lines_;
  std::size_t dropped_ = 0;  // lines that there was no room for
  std::vector<Warning> warnings_;
  std::atomic<bool> may_withdraw_{false};  // a warning came since the last withdrawal
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_LOG_QUEUE_H
