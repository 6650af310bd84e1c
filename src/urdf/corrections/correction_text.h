// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_CORRECTION_TEXT_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_CORRECTION_TEXT_H

#include <Eigen/Core>

#include <string>

namespace parallel_aspects {

/// "1 0 0", as an attribute of a URDF has it.
std::string as_attribute(const Eigen::Vector3d& vector);

/// "(1, 0, 0)", for messages.
std::string in_brackets(const Eigen::Vector3d& vector);

/// "[1, 0, 0]", as a YAML has it.
std::string as_list(const Eigen::Vector3d& vector);

/// The rpy of a rotation, as a URDF has it [rad].
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation);

/// The inverse.
Eigen::Matrix3d rotation_of(const Eigen::Vector3d& roll_pitch_yaw);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_CORRECTION_TEXT_H
