// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PROBE_ROBOT_VISUALS_H
#define PARALLEL_ASPECTS_ROS_PROBE_ROBOT_VISUALS_H

#include "parallel_aspects/urdf/mechanism.h"
#include "urdf/description/tree.h"

#include <cstddef>
#include <std_msgs/ColorRGBA.h>
#include <string>
#include <vector>
#include <visualization_msgs/Marker.h>

namespace parallel_aspects {

/// The visuals of a robot's URDF as markers, of those links that move. All links of a configuration are in
/// one message, so that the robot is drawn closed at all times. Immutable.
class RobotVisuals {
 public:
  /// `urdf`: the text that the mechanism was loaded from. Without visuals nothing is drawn.
  RobotVisuals(const Mechanism& mechanism, const std::string& urdf);

  /// The links at these values of all `Mechanism::joint_names()`, in the base frame and in one colour, as the
  /// markers of a namespace.
  std::vector<visualization_msgs::Marker> at(const Eigen::VectorXd& positions, const std::string& group,
                                             const std_msgs::ColorRGBA& color) const;

 private:
  struct Visual {
    std::size_t link = 0;
    Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  // in the frame of the link
    visualization_msgs::Marker shape;
  };

  void read_visuals(const std::string& urdf);
  bool moves(std::size_t link) const;

  Tree tree_;
  std::size_t base_ = 0;
  std::string base_frame_;
  std::vector<std::size_t> sources_;  // of the values of `tree_`, in those of the mechanism
  std::vector<Visual> visuals_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PROBE_ROBOT_VISUALS_H
