// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_MODE_IMAGES_H
#define PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_MODE_IMAGES_H

#include "aspects/map/map_contents.h"

#include <cstddef>
#include <map>
#include <vector>

namespace parallel_aspects {

/// A working mode of a map as the image of another one under a symmetry of the robot.
struct ModeImage {
  std::size_t representative = 0;  ///< the mode itself where it is no image
  std::map<int, int> aspects;      ///< its aspects by those of the representative; ids
};

/// The image of each mode. Images are leaf by leaf equal to their representatives, unresolved pairs included.
/// This is tested, since a map may have been computed without symmetries.
std::vector<ModeImage> find_mode_images(const AspectMap::Contents& map);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_PERSISTENCE_MODE_IMAGES_H
