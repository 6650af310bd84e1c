// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_DISPLAY_H
#define PARALLEL_ASPECTS_ROS_DISPLAY_H

#include "parallel_aspects/ros/load_options.h"
#include "parallel_aspects/ros/map_picture.h"
#include "parallel_aspects/ros/robot_monitor.h"

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace parallel_aspects {

/// Publishes the picture of the map, and keeps it up with the robot.
class Display {
 public:
  Display(const NodeSetup& setup, ros::NodeHandle private_nh);

  /// Works out a new picture; may take long. Call from any thread.
  void set_map(const std::shared_ptr<const AspectMap>& map);

  /// Draws what has changed since the last call.
  void show(const CurrentConfiguration& current);

 private:
  using Highlight = std::optional<std::pair<WorkingMode, int>>;

  MarkerFrames frames_;
  DisplayOptions options_;
  ros::Publisher markers_, position_markers_;
  tf2_ros::StaticTransformBroadcaster static_tf_;

  std::mutex mutex_;
  std::shared_ptr<const MapPicture> picture_;
  bool fresh_ = false;   // the picture has never been published
  Highlight highlight_;  // as published
  bool dot_ = false;     // whether a position is drawn
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_DISPLAY_H
