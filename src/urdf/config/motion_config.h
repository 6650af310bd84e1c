// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CONFIG_MOTION_CONFIG_H
#define PARALLEL_ASPECTS_URDF_CONFIG_MOTION_CONFIG_H

#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/model/vectors.h"

#include <cstddef>
#include <string>

namespace parallel_aspects {

/// The `motion:` part of a robot's YAML file: what its actuators can do that the URDF does not say.
struct MotionConfig {
  /// The fastest change of velocity of each actuated joint, in the order of `mechanism.actuated_joints`
  /// [rad/s^2 or m/s^2]; positive. Empty where it is not stated.
  JointVector acceleration;
};

/// Reads it from the text of the whole file, of a robot with so many actuated joints. What is wrong is added
/// to `problems`, each a message that names `file` and the key. Text that is no YAML gives nothing:
/// `load_mechanism` tells of that.
MotionConfig read_motion_config(const std::string& text, const std::string& file, std::size_t joints,
                                Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CONFIG_MOTION_CONFIG_H
