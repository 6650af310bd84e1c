// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display/present_points.h"

#include "draw/scene/placed_labels.h"
#include "draw/scene/workspace_bodies.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include "rviz/shapes/ogre_shapes.h"

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double point_size = 0.035, tile_point_size = 0.018;  // of the picture's size

struct Dot {
  Vector3d at;
  bool in_tile;
  Ogre::ColourValue color;
};

Ogre::ColourValue color_of(const PresentPoints::Configuration& configuration) {
  if (!configuration.candidate) return Ogre::ColourValue(0.05F, 0.05F, 0.05F, 1.0F);
  return ogre_color(candidate_color(*configuration.candidate));
}

void add_dots(const SurfacePicture& picture, const Manipulator& robot, const Vector3d& placement,
              const PresentPoints::Configuration& configuration, std::vector<Dot>& dots) {
  const auto& [pose, mode, candidate] = configuration;
  const Ogre::ColourValue color = color_of(configuration);
  const Vector3d point = drawn_point(robot, pose, picture.radian);
  dots.push_back({placement + point, false, color});
  for (const PoseTile& tile : picture.workspaces)
    if (tile.mode == mode) dots.push_back({tile.offset + tile.scale * point, true, color});
  const InverseSolution solution = inverse(robot, pose, mode);
  if (solution.q.size() == 0) return;
  for (const JointTile& tile : picture.joint_spaces)
    if (tile.mode == mode) dots.push_back({tile.drawn(solution.q), true, color});
}

}  // namespace

void PresentPoints::show(const SurfacePicture& picture, const Manipulator& robot, const Vector3d& placement,
                         const Configurations& configurations, const Place& place) {
  std::vector<Dot> dots;
  for (const Configuration& each : configurations) add_dots(picture, robot, placement, each, dots);
  while (points_.size() > dots.size()) points_.pop_back();
  while (points_.size() < dots.size())
    points_.push_back(std::make_unique<rviz::Shape>(rviz::Shape::Sphere, place.scene, place.node));
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const auto size = static_cast<float>((dots[i].in_tile ? tile_point_size : point_size) * picture.size);
    points_[i]->setScale({size, size, size});
    points_[i]->setColor(dots[i].color);
    const Eigen::Vector3f at = dots[i].at.cast<float>();
    points_[i]->setPosition({at.x(), at.y(), at.z()});
  }
}

void PresentPoints::show_skeletons(const Manipulator& robot, double radius,
                                   const Configurations& configurations, const Place& place) {
  std::size_t drawn = 0;
  for (const Configuration& each : configurations) {
    const InverseSolution solution = inverse(robot, each.pose, each.mode);
    if (solution.q.size() == 0) continue;
    if (skeletons_.size() == drawn)
      skeletons_.push_back(std::make_unique<rviz::BillboardLine>(place.scene, place.node));
    const Ogre::ColourValue color = color_of(each);
    skeletons_[drawn]->setColor(color.r, color.g, color.b, 1.0F);
    set_segments(skeleton_of(robot, each.pose, solution.q, radius),
                 skeleton_width * drawn_size(robot, radius), *skeletons_[drawn]);
    show_through(*skeletons_[drawn]);  // it is inside of aspects
    ++drawn;
  }
  skeletons_.resize(drawn);
  show_names(robot, radius, configurations, place);
}

// Made anew where they differ, as words are costly and candidates stand still.
void PresentPoints::show_names(const Manipulator& robot, double radius, const Configurations& configurations,
                               const Place& place) {
  std::vector<Pose> poses;
  std::vector<std::size_t> candidates;
  for (const Configuration& each : configurations) {
    if (!each.candidate) continue;
    poses.push_back(each.pose);
    candidates.push_back(*each.candidate);
  }
  const std::vector<Vector3d> places = candidate_places(robot, poses, radius);
  std::vector<std::pair<std::size_t, Vector3d>> named;
  for (std::size_t i = 0; i < places.size(); ++i) named.emplace_back(candidates[i], places[i]);
  if (named == named_) return;
  named_ = std::move(named);
  names_.clear();
  const auto height = static_cast<float>(candidate_name_height * drawn_size(robot, radius));
  for (const auto& [candidate, at] : named_)
    names_.push_back(std::make_unique<HaloedText>(candidate_name(candidate), candidate_color(candidate),
                                                  ogre_vector(at), height, true, place.node));
}

}  // namespace parallel_aspects
