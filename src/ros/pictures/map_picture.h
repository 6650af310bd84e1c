// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_MAP_PICTURE_H
#define PARALLEL_ASPECTS_ROS_PICTURES_MAP_PICTURE_H

#include "draw/plane/map_pictures.h"
#include "parallel_aspects/aspects/aspect_map.h"
#include "ros/parameters/node_options.h"
#include "ros/pictures/picture.h"
#include "ros/pictures/scene.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <memory>

namespace parallel_aspects {

/// Where the tiles of the gallery stand: to the right of the robot one column a working mode, its workspace
/// above and its joint space below. Everything lies in the plane of the robot.
class GalleryLayout {
 public:
  /// `scale`: size of the gallery's workspaces against the robot.
  GalleryLayout(const AspectMap& map, const JointWindow& window, double scale);

  /// Frames of the two rows, in the task frame of the robot; their origins are the centers of the first tiles
  /// [m].
  const Eigen::Vector2d& aspects_origin() const noexcept { return aspects_origin_; }
  const Eigen::Vector2d& joint_space_origin() const noexcept { return joint_space_origin_; }

  /// A point of the workspace in the tile of a column, in the frame of the upper row [m].
  Eigen::Vector2d in_workspace_tile(const Eigen::Vector2d& point, std::size_t column) const;

  /// Joint values in the tile of a column, in the frame of the lower row [m].
  Eigen::Vector2d in_joint_tile(const Eigen::Vector2d& q, std::size_t column) const;

  Eigen::Vector2d workspace_tile_center(std::size_t column) const {
    return {pitch_ * static_cast<double>(column), 0.0};
  }
  Eigen::Vector2d joint_tile_center(std::size_t column) const { return workspace_tile_center(column); }

  const Eigen::Vector2d& workspace_tile_size() const noexcept { return workspace_tile_size_; }  ///< [m]
  const Eigen::Vector2d& joint_tile_size() const noexcept { return joint_tile_size_; }          ///< [m]
  double text_height() const noexcept { return text_height_; }                                  ///< [m]
  const Eigen::AlignedBox2d& workspace() const noexcept { return workspace_; }  ///< encloses all aspects [m]

 private:
  double scale_, pitch_, text_height_;
  Eigen::AlignedBox2d workspace_;
  Eigen::Vector2d window_center_, joint_scale_;
  Eigen::Vector2d workspace_tile_size_, joint_tile_size_;
  Eigen::Vector2d aspects_origin_, joint_space_origin_;
};

/// The picture of one two-dimensional map: the whole workspace and joint space of every working mode.
std::shared_ptr<const Picture> make_map_picture(const std::shared_ptr<const AspectMap>& map,
                                                const MarkerFrames& frames, const DisplayOptions& options);

/// The picture of a three-dimensional map: slices at the present phi, z or torsion (see `PoseSlice`), one of
/// every working mode in the gallery, and that of the present mode at the robot where poses are positions.
std::shared_ptr<const Picture> make_slice_picture(const std::shared_ptr<const AspectMap>& map,
                                                  const MarkerFrames& frames, const Scene& scene,
                                                  const DisplayOptions& options);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_MAP_PICTURE_H
