// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ROS_PICTURES_MARKER_COLORS_H
#define PARALLEL_ASPECTS_ROS_PICTURES_MARKER_COLORS_H

#include "draw/plane/palette.h"
#include <cstddef>
#include <std_msgs/ColorRGBA.h>
#include <vector>

namespace parallel_aspects {

/// Opaque.
std_msgs::ColorRGBA color(Rgb rgb);

/// The colours of the aspects of one map, as in all other pictures (`aspect_colors`).
class AspectColors {
 public:
  explicit AspectColors(const AspectMap& map) : colors_(aspect_colors(map.aspects())) {}

  /// Of an aspect of that map, by its id.
  std_msgs::ColorRGBA of(int id) const { return color(colors_[static_cast<std::size_t>(id - 1)]); }

 private:
  std::vector<Rgb> colors_;
};

/// Of the skeletons of candidates, which differ from each other; they come again after `hue_count`.
Rgb candidate_rgb(std::size_t index);
std_msgs::ColorRGBA candidate_color(std::size_t index);

/// `share` of the way to white, 0 to 1.
std_msgs::ColorRGBA lightened(const std_msgs::ColorRGBA& color, double share);

/// Black or white, whichever reads better on `background`.
std_msgs::ColorRGBA readable_on(const std_msgs::ColorRGBA& background);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ROS_PICTURES_MARKER_COLORS_H
