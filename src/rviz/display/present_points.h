// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_PRESENT_POINTS_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_PRESENT_POINTS_H

#include "rviz/display/surface_picture.h"

#include <memory>
#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/ogre_helpers/shape.h>
#include <utility>
#include <vector>

namespace parallel_aspects {

/// Dots where the robot is, or may be, in every space of a picture, and its skeleton where nothing else shows
/// it.
class PresentPoints {
 public:
  struct Place {
    Ogre::SceneManager* scene;
    Ogre::SceneNode* node;
  };

  using Configurations = std::vector<std::pair<Pose, WorkingMode>>;

  /// `placement`: of what moves with the robot.
  void show(const SurfacePicture& picture, const Manipulator& robot, const Eigen::Vector3d& placement,
            const Configurations& configurations, const Place& place);

  /// `radius`: as in `skeleton_of`.
  void show_skeletons(const Manipulator& robot, double radius, const Configurations& configurations,
                      const Place& place);

  void clear() {
    points_.clear();
    skeletons_.reset();
  }

 private:
  std::vector<std::unique_ptr<rviz::Shape>> points_;
  std::unique_ptr<rviz::BillboardLine> skeletons_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_PRESENT_POINTS_H
