// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_LABELS_LABEL_ROOM_H
#define PARALLEL_ASPECTS_ROS_LABELS_LABEL_ROOM_H

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// One line of words, about its middle.
struct PlacedLabel {
  Eigen::Vector3d at;  ///< [m]
  std::size_t letters = 1;
};

/// Moves labels down so that none lies over one before it. `height`: of the letters [m]. `planar`: whether
/// they are seen along z, and down is -y; others are seen from any side and obliquely from above, and down is
/// -z.
void keep_apart(std::vector<PlacedLabel>& labels, double height, bool planar);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_LABELS_LABEL_ROOM_H
