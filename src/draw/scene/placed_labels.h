// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DRAW_SCENE_PLACED_LABELS_H
#define PARALLEL_ASPECTS_DRAW_SCENE_PLACED_LABELS_H

#include "draw/scene/robot_lines.h"
#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace parallel_aspects {

/// Half the width of a letter, on average, over its height.
inline constexpr double half_letter = 0.25;

/// One line of words, about its middle.
struct PlacedLabel {
  Eigen::Vector3d at;  ///< [m]
  std::size_t letters = 1;
};

/// Moves labels down so that none lies over one before it. `height`: of the letters [m]. `planar`: whether
/// they are seen along z, and down is -y; others are seen from any side and obliquely from above, and down is
/// -z.
void keep_apart(std::vector<PlacedLabel>& labels, double height, bool planar);

/// What a candidate is called in every picture, by its place in `~candidates`: A to Z, then AA, AB and so on.
/// Numbers are those of aspects.
std::string candidate_name(std::size_t index);

/// How high these names are, over the size of the robot as it is drawn.
inline constexpr double candidate_name_height = 0.06;

/// Where the names of candidates are written so that none lies over another: of planar robots above their
/// operational points; of others before the anchor that is nearest to whoever looks from the front, along y,
/// so that no rods hide them. In the task frame [m]. `radius`: as in `drawn_size`.
std::vector<Eigen::Vector3d> candidate_places(const Manipulator& robot, const std::vector<Pose>& poses,
                                              double radius);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DRAW_SCENE_PLACED_LABELS_H
