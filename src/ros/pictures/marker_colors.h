// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_MARKER_COLORS_H
#define PARALLEL_ASPECTS_ROS_PICTURES_MARKER_COLORS_H

#include "aspects/pictures/palette.h"

#include <std_msgs/ColorRGBA.h>

namespace parallel_aspects {

/// Opaque.
std_msgs::ColorRGBA color(Rgb rgb);

/// Colour of an aspect, by its id (from 1): ten that people with any colour vision tell apart (after Paul
/// Tol's "muted" scheme), then the same again.
std_msgs::ColorRGBA aspect_color(int id);

/// `share` of the way to white, 0 to 1.
std_msgs::ColorRGBA lightened(const std_msgs::ColorRGBA& color, double share);

/// Black or white, whichever reads better on `background`.
std_msgs::ColorRGBA readable_on(const std_msgs::ColorRGBA& background);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_MARKER_COLORS_H
