// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_PRESENT_POINTS_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_PRESENT_POINTS_H

#include "rviz/display/surface_picture.h"

#include <memory>
#include <rviz/ogre_helpers/shape.h>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Dots where the robot is, or may be, in every space of a picture.
class PresentPoints {
 public:
  struct Place {
    Ogre::SceneManager* scene;
    Ogre::SceneNode* node;
  };

  /// `placement`: of what moves with the robot.
  void show(const SurfacePicture& picture, const Manipulator& robot, const Eigen::Vector3d& placement,
            const std::vector<std::pair<Pose, WorkingMode>>& configurations, const Place& place);
  void clear() { points_.clear(); }

 private:
  std::vector<std::unique_ptr<rviz::Shape>> points_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_PRESENT_POINTS_H
