// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_FRAME_WATCH_H
#define PARALLEL_ASPECTS_ROS_MONITOR_FRAME_WATCH_H

#include <ros/time.h>

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Notices that two nodes say where the same tf frame of this robot is. Whoever asks tf then gets now this
/// answer, now that. Frames of other robots are theirs to watch. Nodelets of one manager cannot be determined
/// apart: they publish under its name. Thread-safe.
class FrameWatch {
 public:
  /// `own`: begin of the names of the frames that this node adds. `links`: frames of the robot besides.
  FrameWatch(std::string own, const std::vector<std::string>& links)
      : own_(std::move(own)), links_(links.begin(), links.end()) {}

  enum class Topic { tf, tf_static };

  /// A node says where `frame` is.
  void hear(const std::string& frame, const std::string& publisher, Topic topic, const ros::WallTime& now);

  /// A message for each two nodes that were first heard of the same frame a short while ago, so that the
  /// number of such frames is known by now. Each two once.
  std::vector<std::string> news(const ros::WallTime& now);

  /// A message for each two nodes while they contradict each other; otherwise empty. On tf_static it
  /// cannot be seen that a node has stopped.
  std::string message(const ros::WallTime& now) const;

 private:
  struct Frame {
    std::string publisher;  // the last one
    ros::WallTime heard;
  };
  struct Dispute {
    std::set<std::string> frames;
    ros::WallTime first, last;
    bool for_good = false;  // static transforms are sent once
    bool said = false;
  };
  using Nodes = std::pair<std::string, std::string>;  // in the order of their names
  static std::string message(const Nodes& nodes, const Dispute& dispute);

  const std::string own_;
  const std::set<std::string> links_;
  mutable std::mutex mutex_;
  std::map<std::string, Frame> frames_;
  std::map<Nodes, Dispute> disputes_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_FRAME_WATCH_H
