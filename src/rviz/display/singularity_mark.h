// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_SINGULARITY_MARK_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_SINGULARITY_MARK_H

#include "rviz/display/nearest_singularity.h"
#include "rviz/display/present_points.h"

#include <chrono>
#include <memory>
#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/ogre_helpers/shape.h>
#include <string>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// The way from the robot to the nearest singularity, with a dot at its end, before all that would hide it.
/// For rviz's own thread.
class SingularityMark {
 public:
  /// Looks for it where the robot has moved, ten times a second at most, which takes 2 ms at most.
  /// `placement`: of what moves with the robot.
  void show(const SurfacePicture& picture, const std::shared_ptr<const Manipulator>& robot,
            const Eigen::Vector3d& placement, const std::pair<Pose, WorkingMode>& present,
            const PresentPoints::Place& place);
  void clear();

  /// What it is, in one line; empty where none is shown.
  std::string words() const { return nearest_ ? words_of(*nearest_, DistanceUnit(*robot_)) : ""; }

 private:
  using Clock = std::chrono::steady_clock;

  bool is_due(const std::pair<Pose, WorkingMode>& present, double radian) const;
  void draw(double size, const PresentPoints::Place& place);
  void add_dot(double width, const Ogre::ColourValue& color, const PresentPoints::Place& place);

  std::shared_ptr<const Manipulator> robot_;
  std::unique_ptr<BoundaryDistanceMeter> meter_;          // of it
  std::optional<std::pair<Pose, WorkingMode>> measured_;  // last
  double radian_ = 0.0;                                   // then
  Clock::time_point at_;                                  // then
  std::optional<NearestSingularity> nearest_;
  std::unique_ptr<rviz::BillboardLine> line_;
  std::vector<std::unique_ptr<rviz::Shape>> dots_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_SINGULARITY_MARK_H
