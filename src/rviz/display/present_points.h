// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_RVIZ_DISPLAY_PRESENT_POINTS_H
#define PARALLEL_ASPECTS_RVIZ_DISPLAY_PRESENT_POINTS_H

#include "draw/scene/surface_picture.h"

#include "rviz/shapes/ogre_shapes.h"
#include <cstddef>
#include <memory>
#include <optional>
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

  /// Where the robot is, or may be then as the candidate at this place of `~candidates`.
  struct Configuration {
    Pose pose;
    WorkingMode mode;
    std::optional<std::size_t> candidate = std::nullopt;
  };
  using Configurations = std::vector<Configuration>;

  /// `placement`: of what moves with the robot.
  void show(const SurfacePicture& picture, const Manipulator& robot, const Eigen::Vector3d& placement,
            const Configurations& configurations, const Place& place);

  /// Candidates have colours of their own and names. `radius`: as in `skeleton_of`.
  void show_skeletons(const Manipulator& robot, double radius, const Configurations& configurations,
                      const Place& place);

  void clear_dots() { points_.clear(); }

  void clear() {
    clear_dots();
    skeletons_.clear();
    names_.clear();
    named_.clear();
  }

 private:
  std::vector<std::unique_ptr<rviz::Shape>> points_;
  std::vector<std::unique_ptr<rviz::BillboardLine>> skeletons_;
  std::vector<std::unique_ptr<HaloedText>> names_;
  std::vector<std::pair<std::size_t, Eigen::Vector3d>> named_;  // the candidates whose names are there

  void show_names(const Manipulator& robot, double radius, const Configurations& configurations,
                  const Place& place);
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_RVIZ_DISPLAY_PRESENT_POINTS_H
