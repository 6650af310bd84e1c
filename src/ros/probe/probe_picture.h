// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PROBE_PROBE_PICTURE_H
#define PARALLEL_ASPECTS_ROS_PROBE_PROBE_PICTURE_H

#include "parallel_aspects/urdf/mechanism.h"
#include "ros/pictures/robot_visuals.h"
#include "ros/pictures/scene.h"
#include "ros/probe/probe_solver.h"

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects {

/// The probe in rviz: a translucent robot in the colour of its aspect, the same pose in other working modes,
/// the nearest singularity with lines to it and the way out, where it is wanted, and words. Stamps are zero.
class ProbePicture {
 public:
  /// `urdf`: the text that the mechanism was loaded from.
  ProbePicture(std::shared_ptr<const Mechanism> mechanism, const std::string& urdf,
               const NodeOptions& options);

  /// All that is shown, and the removal of what was shown before and is no more: the array tells all of it to
  /// whoever sees it first. `extra`: markers of others that belong to it.
  visualization_msgs::MarkerArray of(const ProbeFinding& finding,
                                     std::vector<visualization_msgs::Marker> extra = {});

  /// Nothing is shown any more.
  visualization_msgs::MarkerArray none();

 private:
  using Markers = std::vector<visualization_msgs::Marker>;
  using Key = std::pair<std::string, int>;

  visualization_msgs::MarkerArray replaced_by(Markers markers);
  void draw_robots(const ProbeFinding& finding, Markers& markers) const;
  void draw_singularity(const ProbeFinding& finding, Markers& markers) const;
  void draw_escape(const Pose& pose, const BoundaryDistance& distance, const JointVector& q,
                   Markers& markers) const;
  void draw_wanted(const ProbeFinding& finding, Markers& markers) const;
  void draw_words(const ProbeFinding& finding, Markers& markers) const;
  visualization_msgs::Marker marker(const std::string& group, int type,
                                    const std_msgs::ColorRGBA& color) const;
  geometry_msgs::Point drawn(const Eigen::Vector3d& point) const;
  std::vector<Eigen::Vector3d> seen_points() const;

  const std::shared_ptr<const Mechanism> mechanism_;
  const Manipulator& robot_;
  RobotVisuals visuals_;
  Scene scene_;
  std::set<Key> shown_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PROBE_PROBE_PICTURE_H
