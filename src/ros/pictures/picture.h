// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_PICTURE_H
#define PARALLEL_ASPECTS_ROS_PICTURES_PICTURE_H

#include "draw/plane/map_pictures.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/messages/conversions.h"

#include <geometry_msgs/TransformStamped.h>
#include <optional>
#include <string>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {

/// Frames that markers are drawn in.
struct MarkerFrames {
  std::string base;
  std::string aspects;      ///< of the gallery, or of its upper row
  std::string joint_space;  ///< of its lower row
};

/// What the picture follows.
struct DrawnConfiguration {
  WorkingMode mode;
  int aspect = 0;  ///< id, or 0
  SolvedPose solved;
};

/// Empty while the robot is not tracked.
using Drawn = std::optional<DrawnConfiguration>;

/// The picture of one map, as three arrays for three topics: what changes seldom is not sent again with what
/// changes often. Stamps are zero, and every array begins by deleting what the last one drew. Immutable.
class Picture {
 public:
  virtual ~Picture() = default;

  /// Every working mode, beside the robot.
  virtual visualization_msgs::MarkerArray gallery(const Drawn& now) const = 0;

  /// The aspects of the present working mode at the robot, with the present one highlighted, here and in the
  /// gallery.
  virtual visualization_msgs::MarkerArray present(const Drawn& now) const = 0;

  /// Dots at the present configuration.
  virtual visualization_msgs::MarkerArray position(const Drawn& now) const = 0;

  /// Whether the gallery, or the present aspects, look different from what was drawn `before`.
  virtual bool gallery_differs(const Drawn& /*before*/, const Drawn& /*now*/) const { return false; }
  virtual bool present_differs(const Drawn& /*before*/, const Drawn& /*now*/) const { return false; }

  /// Which poses it has drawn aspects at, where those are a section of the map.
  virtual std::optional<PoseSlice> section(const Drawn&) const { return std::nullopt; }

  /// Where the frames of the gallery stand, in the base frame.
  virtual std::vector<geometry_msgs::TransformStamped> frames() const = 0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_PICTURE_H
