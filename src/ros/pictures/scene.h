// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_SCENE_H
#define PARALLEL_ASPECTS_ROS_PICTURES_SCENE_H

#include "draw/scene/robot_lines.h"
#include "parallel_aspects/urdf/mechanism.h"
#include "ros/parameters/load_options.h"
#include "ros/parameters/node_options.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The tiles of a gallery, one a working mode, in rows of at most four: x to the right, y up, the origin at
/// the upper left corner [m].
class TileLayout {
 public:
  TileLayout() = default;

  /// Fits `tiles` into this height; at least one.
  TileLayout(std::size_t tiles, double height);

  Eigen::Vector2d center(std::size_t tile) const;
  double side() const noexcept { return side_; }
  double text_height() const noexcept { return 0.085 * side_; }
  double width() const noexcept { return pitch_.x() * static_cast<double>(columns_); }
  double height() const noexcept { return pitch_.y() * static_cast<double>(rows_); }

 private:
  std::size_t columns_ = 1, rows_ = 1;
  double side_ = 1.0;
  Eigen::Vector2d pitch_ = Eigen::Vector2d::Ones();
};

/// Where things stand in rviz, derived from the robot alone, before there is a map. The gallery stands to the
/// right of the robot: in its plane for planar robots, upright and leaning back towards the viewer for
/// others.
struct Scene {
  /// What the robot takes with all its assembly modes about the start, and what a planar one can reach, in
  /// the drawing frame [m].
  Eigen::AlignedBox3d robot;
  Eigen::AlignedBox3d reach;  ///< `reach_box` about the start
  double radius = 0.0;        ///< of the sphere that a robot of SO3 takes, whose model has no size [m]
  bool planar = true;
  TileLayout tiles;
  Eigen::Isometry3d gallery =
      Eigen::Isometry3d::Identity();  ///< x right, y up, z to the viewer, in the drawing frame
};

/// For the words of the probe, above a planar robot and what it reaches: of their height together.
inline constexpr double words_room = 0.15;

/// How high about the robot and what it reaches are in a window that they fill, of SO3 the robot and its ball
/// of rotations [m].
double seen_height(const Scene& scene);

/// Lines of the display's legend that there is room for.
inline constexpr double legend_lines = 5.0;

/// `still`: what is drawn of the base, as `RobotVisuals::still` says.
Scene scene_of(const Mechanism& mechanism, const NodeOptions& options, const Eigen::AlignedBox3d& still = {});

/// With the base as the URDF draws it.
Scene scene_of(const NodeSetup& setup);

/// About the positions that the operational point comes to in some working mode within its limits, in the
/// task frame [m]: of a grid, for the eye alone, but the same in every process. In SE2 at any angle, in SE3
/// at the orientation of `start`. Empty where nothing bounds them, and where the robot only turns.
Eigen::AlignedBox3d reach_box(const Manipulator& robot, const Pose& start);

/// The pose that the parameters say, or the one that the mechanism was recognised in.
Pose start_pose(const Mechanism& mechanism, const StartOptions& start);

/// What rviz says about the robot, in lines that cover neither the robot nor the gallery: below a planar
/// robot, and above any other and its gallery.
struct Caption {
  static constexpr std::size_t max_lines = 4;
  static constexpr double letter_width = 0.45;  ///< on average, over the height of the text
  static constexpr double line_pitch = 1.2;     ///< from one line to the next, over the height of the text

  std::string words;         ///< with line breaks
  Eigen::Vector3d at;        ///< middle of the text, drawing frame [m]
  double text_height = 0.0;  ///< [m]
};

/// Each line of `words` is broken where it is too long; what does not fit into the lines there are ends in
/// dots.
Caption caption_of(const Scene& scene, const std::string& words);

/// Opposite corners of what the longest caption takes, in the drawing frame [m].
std::vector<Eigen::Vector3d> caption_corners(const Scene& scene);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_SCENE_H
