// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_NODE_LOG_QUEUE_H
#define PARALLEL_ASPECTS_ROS_NODE_LOG_QUEUE_H

#include <ros/time.h>

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Takes lines for the log from a thread that must not wait for a terminal, and writes them from another.
class LogQueue {
 public:
  void say(std::string line);

  /// Warnings are written at most every five seconds, the newest one then.
  void warn(std::string line);

  /// Writes what has come in since.
  void write();

 private:
  std::mutex mutex_;
  std::vector<std::string> lines_;
  std::size_t dropped_ = 0;  // lines that there was no room for
  std::string warning_;
  ros::WallTime warned_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_NODE_LOG_QUEUE_H
