// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_MONITOR_FRAME_WATCH_H
#define PARALLEL_ASPECTS_ROS_MONITOR_FRAME_WATCH_H

#include <ros/time.h>

#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace parallel_aspects {

/// Notices that two nodes say where the same tf frame is. Whoever asks tf then gets now this answer, now
/// that. Nodelets of one manager cannot be distinguished: they publish under its name. Thread-safe.
class FrameWatch {
 public:
  /// `own`: begin of the names of the frames that this node adds.
  explicit FrameWatch(std::string own) : own_(std::move(own)) {}

  enum class Topic { tf, tf_static };

  /// A node says where `frame` is. A message where another one did so a short while ago, and that was not
  /// said yet of this frame; otherwise empty.
  std::string hear(const std::string& frame, const std::string& publisher, Topic topic,
                   const ros::WallTime& now);

  /// A message while there are such frames; otherwise empty. Of tf_static nobody hears that a node has
  /// stopped.
  std::string message(const ros::WallTime& now) const;

 private:
  struct Frame {
    std::string publisher, other;    // the last one, and one that was heard beside it
    ros::WallTime heard, disputed;   // zero for never
    bool disputed_for_good = false;  // static transforms are said once
  };
  std::string message(const std::string& name, const Frame& frame) const;

  const std::string own_;
  mutable std::mutex mutex_;
  std::map<std::string, Frame> frames_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_MONITOR_FRAME_WATCH_H
