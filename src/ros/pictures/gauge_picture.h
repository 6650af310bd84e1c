// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_GAUGE_PICTURE_H
#define PARALLEL_ASPECTS_ROS_PICTURES_GAUGE_PICTURE_H

#include "parallel_aspects/model/manipulator.h"
#include "ros/pictures/picture.h"
#include "ros/pictures/scene.h"

#include <memory>

namespace parallel_aspects {

/// The picture while there is no map, and of robots that have none: a gauge for each index that vanishes at a
/// singularity, at the present configuration.
std::shared_ptr<const Picture> make_gauge_picture(std::shared_ptr<const Manipulator> manipulator,
                                                  MarkerFrames frames, const Scene& scene);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_GAUGE_PICTURE_H
