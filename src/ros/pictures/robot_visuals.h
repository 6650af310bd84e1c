// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_ROBOT_VISUALS_H
#define PARALLEL_ASPECTS_ROS_PICTURES_ROBOT_VISUALS_H

#include "parallel_aspects/urdf/mechanism.h"
#include "urdf/description/tree.h"

#include <cstddef>
#include <memory>
#include <std_msgs/ColorRGBA.h>
#include <string>
#include <vector>
#include <visualization_msgs/Marker.h>

namespace parallel_aspects {

/// The visuals of a robot's URDF as markers, of those links that move; its skeleton where there are none. All
/// links of a configuration are in one message, so that the robot is drawn closed at all times. Immutable.
class RobotVisuals {
 public:
  /// `urdf`: the text that the mechanism was loaded from. `radius`: as in `skeleton_of`.
  RobotVisuals(std::shared_ptr<const Mechanism> mechanism, const std::string& urdf, double radius);

  /// Whether no link that moves has visuals.
  bool empty() const noexcept { return visuals_.empty(); }

  /// What is drawn of the links that do not move, but for meshes, in the task frame [m]; empty where nothing
  /// is.
  Eigen::AlignedBox3d still() const { return still_; }

  /// The links at a configuration, in the base frame and in one colour, as the markers of a namespace. Left
  /// out where its loops do not close, so that it is never drawn open.
  std::vector<visualization_msgs::Marker> at(const Pose& pose, const JointVector& q, const std::string& group,
                                             const std_msgs::ColorRGBA& color) const;

  /// The skeleton alone, likewise.
  std::vector<visualization_msgs::Marker> skeleton_at(const Pose& pose, const JointVector& q,
                                                      const std::string& group,
                                                      const std_msgs::ColorRGBA& color) const;

 private:
  struct Visual {
    std::size_t link = 0;
    Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  // in the frame of the link
    visualization_msgs::Marker shape;
  };

  void read_visuals(const std::string& urdf);
  void add_still(std::size_t link, const Eigen::Isometry3d& origin, const visualization_msgs::Marker& shape);
  bool moves(std::size_t link) const;

  std::shared_ptr<const Mechanism> mechanism_;
  double radius_;
  Tree tree_;
  std::size_t base_ = 0;
  std::string base_frame_;
  std::vector<std::size_t> sources_;  // of the values of `tree_`, in those of the mechanism
  std::vector<Visual> visuals_;
  Eigen::AlignedBox3d still_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_ROBOT_VISUALS_H
