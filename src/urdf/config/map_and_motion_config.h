// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CONFIG_MAP_AND_MOTION_CONFIG_H
#define PARALLEL_ASPECTS_URDF_CONFIG_MAP_AND_MOTION_CONFIG_H

#include "parallel_aspects/aspects/map_slice.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The `map:` part of a robot's YAML file: how its map is computed. What is not there has its default.
struct MapConfig {
  std::optional<double> resolution;  ///< [m or rad]; positive
  std::optional<unsigned> threads;   ///< 0 to 1024
  std::optional<int> extra_levels;   ///< 0 to 20

  /// Lower and upper corner of the positions to search [m]; how many numbers they need shows when the task
  /// space is known.
  std::optional<std::array<std::vector<double>, 2>> region;
};

/// Reads it from the text of the whole file. What is wrong is added to `problems`, each a message that names
/// `file` and the key. Text that is no YAML gives nothing: `load_mechanism` tells of that.
MapConfig read_map_config(const std::string& text, const std::string& file, Problems& problems);

/// The region as a box of positions of this task space; nothing, with a message, where it has other numbers
/// than that needs.
std::optional<Box> resolve_region(const MapConfig& config, TaskSpace space, const std::string& file,
                                  Problems& problems);

/// `motion.acceleration` of a robot's YAML file, what its actuators can do that the URDF does not say: the
/// fastest change of velocity of each of so many actuated joints, in the order of `mechanism.actuated_joints`
/// [rad/s^2 or m/s^2]; positive, and empty where it is not stated. Reads it from the text of the whole file,
/// as `read_map_config` does.
JointVector read_acceleration(const std::string& text, const std::string& file, std::size_t joints,
                              Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CONFIG_MAP_AND_MOTION_CONFIG_H
