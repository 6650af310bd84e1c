// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_DISPLAY_H
#define PARALLEL_ASPECTS_ROS_PICTURES_DISPLAY_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "ros/monitor/robot_monitor.h"
#include "ros/parameters/load_options.h"
#include "ros/pictures/marker_batch.h"
#include "ros/pictures/picture.h"
#include "ros/pictures/robot_visuals.h"
#include "ros/pictures/scene.h"

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Publishes the picture of the map, or gauges while there is none, and keeps it up with the robot.
class Display {
 public:
  Display(const NodeSetup& setup, ros::NodeHandle private_nh);

  /// Works out a new picture; may take long. Call from any thread.
  void set_map(const std::shared_ptr<const AspectMap>& map);

  /// Draws what was found of uniqueness domains, and the curves of cusps, which takes some seconds; null
  /// deletes what was drawn. Call from any thread.
  void set_domains(const std::shared_ptr<const Uniqueness>& uniqueness, const MapControl& control = {});

  /// From now on; a picture that differs is worked out at once.
  void set_options(const DisplayOptions& options);

  /// Where the robot may be, while it is not known; each is drawn as a skeleton. Call from any thread.
  void set_candidates(const AssemblyCandidates& candidates);

  /// Draws what has changed since the last call. `map_message`: what there is to say about the map.
  void show(const CurrentConfiguration& current, const std::string& map_message);

  /// Which poses aspects are drawn at now, where those are a section of the map.
  std::optional<PoseSlice> section();

  /// Dots of another configuration than the robot's, in workspace and joint space, where there is a picture
  /// of the map.
  std::vector<visualization_msgs::Marker> dots_of(const DrawnConfiguration& other);

 private:
  void set_picture(const std::shared_ptr<const Picture>& picture);
  void publish_gallery(const Drawn& now);
  void publish_present(const Drawn& now);
  void publish_position(const Drawn& now, const std::string& words);
  void draw_robots(const Drawn& now, std::vector<visualization_msgs::Marker>& markers) const;
  void draw_candidates(std::vector<visualization_msgs::Marker>& markers) const;
  void draw_name(std::size_t candidate, const Eigen::Vector3d& at, MarkerBatch& batch) const;
  std::string caption(const CurrentConfiguration& current, const std::string& map_message) const;

  const std::shared_ptr<const Manipulator> manipulator_;
  const MarkerFrames frames_;
  const RobotVisuals visuals_;
  const Scene scene_;
  ros::Publisher markers_, present_markers_, position_markers_, uniqueness_markers_;
  tf2_ros::StaticTransformBroadcaster static_tf_;

  std::mutex mutex_;
  DisplayOptions options_;
  std::shared_ptr<const AspectMap> map_;  // that the picture is of
  std::shared_ptr<const Picture> picture_;
  bool mapped_ = false;                  // whether the picture is of a map
  bool fresh_ = true;                    // the picture has never been published
  Drawn drawn_gallery_, drawn_present_;  // as published
  ros::WallTime gallery_time_, present_time_;
  std::string caption_;
  std::vector<std::pair<Pose, JointVector>> candidates_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_DISPLAY_H
