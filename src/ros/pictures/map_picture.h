// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_MAP_PICTURE_H
#define PARALLEL_ASPECTS_ROS_PICTURES_MAP_PICTURE_H

#include "parallel_aspects/aspects/aspect_map.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "ros/parameters/node_options.h"
#include "ros/pictures/picture.h"
#include "ros/pictures/plane_markers.h"

#include <Eigen/Geometry>

#include "draw/plane/map_pictures.h"
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

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

/// The picture of one two-dimensional map: the whole workspace and joint space of every working mode. Its
/// geometry is worked out once; what moves is cheap.
class MapPicture : public Picture {
 public:
  MapPicture(std::shared_ptr<const AspectMap> map, MarkerFrames frames, const DisplayOptions& options);

  visualization_msgs::MarkerArray gallery(const Drawn& now) const override;
  visualization_msgs::MarkerArray present(const Drawn& now) const override;
  visualization_msgs::MarkerArray position(const Drawn& now) const override;
  bool gallery_differs(const Drawn& before, const Drawn& now) const override;
  bool present_differs(const Drawn& before, const Drawn& now) const override;
  std::vector<geometry_msgs::TransformStamped> frames() const override;

 private:
  struct ModePicture {
    WorkingMode mode;
    PlaneScene at_robot, tile;  // in the workspace, finely and less so
    PlaneScene joints;          // in joint space
    bool overlaps = false;      // whether several aspects lie over the same joint values
  };

  std::optional<std::size_t> column_of(const WorkingMode& mode) const;
  ModePicture picture_of(const WorkingMode& mode) const;
  PlanePainter workspace(std::size_t column, MarkerBatch& batch) const;
  PlanePainter joint_space(std::size_t column, MarkerBatch& batch) const;
  Eigen::Vector2d label_point(const PlaneArea& area) const;
  void draw_workspace_tile(std::size_t column, MarkerBatch& batch) const;
  void draw_joint_tile(std::size_t column, MarkerBatch& batch) const;
  void draw_legend(MarkerBatch& batch) const;

  std::shared_ptr<const AspectMap> map_;
  MarkerFrames frames_;
  DisplayOptions options_;
  JointProjection projection_;
  GalleryLayout layout_;
  MarkerBatch::Plane at_robot_, workspaces_, joint_spaces_;
  std::vector<ModePicture> modes_;  // a column each
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_MAP_PICTURE_H
