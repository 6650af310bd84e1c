// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_CAPTION_H
#define PARALLEL_ASPECTS_ROS_PICTURES_CAPTION_H

#include "ros/pictures/scene.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// What rviz says about the robot, in lines that cover neither the robot nor the gallery: below a planar
/// robot, and above any other and its gallery.
struct Caption {
  static constexpr std::size_t max_lines = 4;
  static constexpr double letter_width = 0.45;  ///< on average, over the height of the text
  static constexpr double line_pitch = 1.2;     ///< from one line to the next, over the height of the text

  std::string words;         ///< with line breaks
  Eigen::Vector3d at;        ///< middle of the text, task frame [m]
  double text_height = 0.0;  ///< [m]
};

/// Each line of `words` is broken where it is too long; what does not fit into the lines there are ends in
/// dots.
Caption caption_of(const Scene& scene, const std::string& words);

/// Opposite corners of what the longest caption takes, in the task frame [m].
std::vector<Eigen::Vector3d> caption_corners(const Scene& scene);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_CAPTION_H
