// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_MODEL_TASK_SPACE_H
#define PARALLEL_ASPECTS_MODEL_TASK_SPACE_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parallel_aspects {

/// The motions that the platform can make, as a subgroup of rigid motions in the task frame.
enum class TaskSpace {
  T1,   ///< translations along the x axis: x
  T2,   ///< translations in the x-y plane: x, y
  SE2,  ///< motions of the x-y plane: x, y, phi about z
  T3,   ///< translations in space: x, y, z
  SO3,  ///< rotations about the origin of the task frame
  SE3,  ///< all rigid motions
};

/// Number of degrees of freedom: 1, 2, 3, 3, 3, 6. Equals the number of legs of a fully parallel manipulator.
std::size_t degrees_of_freedom(TaskSpace space) noexcept;

/// "T1", "T2", "SE2", "T3", "SO3" or "SE3".
std::string_view name(TaskSpace space) noexcept;

/// The task space of that name; nothing for any other text.
std::optional<TaskSpace> task_space_named(std::string_view text) noexcept;

/// Names of the pose coordinates, in the order of `pose_coordinates`: x, y, z [m], phi [rad], qx, qy, qz, qw.
const std::vector<std::string>& coordinate_names(TaskSpace space);

/// How many of the degrees of freedom are rotations; they come first in a twist and in the columns of A.
std::size_t rotational_degrees_of_freedom(TaskSpace space) noexcept;

/// Whether the platform can turn (SE2, SO3, SE3).
bool has_rotation(TaskSpace space) noexcept;

/// Whether the platform can move away (all but SO3).
bool has_translation(TaskSpace space) noexcept;

/// Unit of a volume in the space of poses: "m", "m^2", "m^2 rad", "m^3", "rad^3" or "m^3 rad^3".
std::string_view measure_unit(TaskSpace space) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_MODEL_TASK_SPACE_H
