// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_DOMAIN_PICTURE_H
#define PARALLEL_ASPECTS_ROS_PICTURES_DOMAIN_PICTURE_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/aspects/uniqueness.h"
#include "ros/pictures/scene.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {

/// Where the poses (x, y, phi) of an aspect of SE2 are drawn for their basic regions: in boxes to the left of
/// the robot, one an aspect in columns of up to two, each leaning back so that whoever looks from above sees
/// it from the front. A metre is a metre, and a turn is as long as `turn_length` says.
class DomainLayout {
 public:
  /// Of so many aspects, with positions in this box [m].
  DomainLayout(const Manipulator& manipulator, const Scene& scene, const Eigen::AlignedBox2d& positions,
               std::size_t aspects);

  /// Of the points of one box, in the task frame.
  Eigen::Isometry3d frame(std::size_t box) const;

  /// In the coordinates of a box: x, y, and phi by `radian` [m].
  const Eigen::AlignedBox3d& box() const noexcept { return box_; }
  double radian() const noexcept { return radian_; }  ///< how long a radian is drawn [m]

  /// All there is to see, with legends, in the task frame.
  Eigen::AlignedBox2d seen() const;

  /// The middle of the upper edge of a box as it is seen, in the task frame.
  Eigen::Vector2d top(std::size_t box) const;
  double text_height() const noexcept { return 0.045 * box_.sizes().x(); }

 private:
  Eigen::Vector2d pitch() const;

  double radian_;
  Eigen::AlignedBox3d box_;
  Eigen::Vector2d middle_;  // of the last column, in the task frame
  double height_;           // of a box, as it is seen from above
  std::size_t rows_, columns_;
};

/// The basic regions of a robot of SE2, as the outermost cubes of those whose middle is proved to lie in the
/// region, and the curves of cusps where they lie at an aspect. Each region has a namespace of its own. It
/// begins by deleting whatever its topic drew before. Cancelled, it has nothing more.
visualization_msgs::MarkerArray domain_markers(const Uniqueness& uniqueness, const CuspCurves& cusps,
                                               const Scene& scene, const MapControl& control = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_DOMAIN_PICTURE_H
