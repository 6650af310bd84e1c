// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_XML_VALUES_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_XML_VALUES_H

#include <Eigen/Geometry>
#include <tinyxml2.h>

#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// The attribute, or an empty text where the element or the attribute does not exist.
std::string attribute(const tinyxml2::XMLElement* element, const char* name);

/// The text inside a child element, without blanks around it; empty where there is none.
std::string child_text(const tinyxml2::XMLElement& element, const char* child);

/// Finite numbers separated by blanks, whatever the locale; nothing for any other text.
std::optional<std::vector<double>> numbers(const std::string& text);

/// Three finite numbers; `absent` for an empty text, nothing for any other.
std::optional<Eigen::Vector3d> vector_or(const std::string& text, const Eigen::Vector3d& absent);

/// The frame of URDF's xyz [m] and rpy [rad] attributes, each zero where absent; nothing when one is no
/// vector.
std::optional<Eigen::Isometry3d> frame_of(const std::string& xyz, const std::string& rpy);

/// The rpy of a rotation, as a URDF has it [rad].
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& r);

/// The inverse.
Eigen::Matrix3d rotation_of(const Eigen::Vector3d& roll_pitch_yaw);

/// Axes with z along `axis` (not zero), the other two anyhow.
Eigen::Matrix3d axes_with_z(const Eigen::Vector3d& axis);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_XML_VALUES_H
