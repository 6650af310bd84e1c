// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_ROS_PICTURES_MARKER_GROUPS_H
#define PARALLEL_ASPECTS_TEST_ROS_PICTURES_MARKER_GROUPS_H

#include "ros/pictures/map_picture.h"

#include <string>
#include <vector>
#include <visualization_msgs/MarkerArray.h>

namespace parallel_aspects::test {

inline const MarkerFrames frames{"base_link", "robot/aspects", "robot/joint_space"};

inline std::vector<visualization_msgs::Marker> in_group(const visualization_msgs::MarkerArray& array,
                                                        const std::string& group) {
  std::vector<visualization_msgs::Marker> markers;
  for (const visualization_msgs::Marker& marker : array.markers)
    if (marker.ns == group) markers.push_back(marker);
  return markers;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_ROS_PICTURES_MARKER_GROUPS_H
