// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/present_points.h"

#include "parallel_aspects/kinematics/inverse.h"
#include "ros/pictures/robot_visuals.h"
#include "rviz/display/ogre_types.h"
#include "rviz/display/workspace_painter.h"

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double point_size = 0.035, tile_point_size = 0.018;  // of the picture's size

struct Dot {
  Vector3d at;
  bool in_tile;
};

void add_dots(const SurfacePicture& picture, const Manipulator& robot, const Vector3d& placement,
              const Pose& pose, const WorkingMode& mode, std::vector<Dot>& dots) {
  const Vector3d point = drawn_point(robot.task_space(), pose, picture.radian);
  dots.push_back({placement + point, false});
  for (const PoseTile& tile : picture.workspaces)
    if (tile.mode == mode) dots.push_back({tile.offset + tile.scale * point, true});
  const InverseSolution solution = inverse(robot, pose, mode);
  if (solution.q.size() == 0) return;
  for (const JointTile& tile : picture.joint_spaces)
    if (tile.mode == mode) dots.push_back({tile.drawn(solution.q), true});
}

}  // namespace

void PresentPoints::show(const SurfacePicture& picture, const Manipulator& robot, const Vector3d& placement,
                         const Configurations& configurations, const Place& place) {
  std::vector<Dot> dots;
  for (const auto& [pose, mode] : configurations) add_dots(picture, robot, placement, pose, mode, dots);
  while (points_.size() > dots.size()) points_.pop_back();
  while (points_.size() < dots.size()) {
    points_.push_back(std::make_unique<rviz::Shape>(rviz::Shape::Sphere, place.scene, place.node));
    points_.back()->setColor(0.05F, 0.05F, 0.05F, 1.0F);
  }
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const auto size = static_cast<float>((dots[i].in_tile ? tile_point_size : point_size) * picture.size);
    points_[i]->setScale({size, size, size});
    const Eigen::Vector3f at = dots[i].at.cast<float>();
    points_[i]->setPosition({at.x(), at.y(), at.z()});
  }
}

void PresentPoints::show_skeletons(const Manipulator& robot, double radius,
                                   const Configurations& configurations, const Place& place) {
  std::vector<Vector3d> ends;
  for (const auto& [pose, mode] : configurations) {
    const InverseSolution solution = inverse(robot, pose, mode);
    if (solution.q.size() == 0) continue;
    const std::vector<Vector3d> more = skeleton_of(robot, pose, solution.q, radius);
    ends.insert(ends.end(), more.begin(), more.end());
  }
  if (ends.empty()) return skeletons_.reset();
  if (!skeletons_) skeletons_ = std::make_unique<rviz::BillboardLine>(place.scene, place.node);
  skeletons_->setColor(0.05F, 0.05F, 0.05F, 1.0F);
  set_segments(ends, skeleton_width * robot.size(), *skeletons_);
}

}  // namespace parallel_aspects
