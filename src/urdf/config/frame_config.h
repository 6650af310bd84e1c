// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CONFIG_FRAME_CONFIG_H
#define PARALLEL_ASPECTS_URDF_CONFIG_FRAME_CONFIG_H

#include "urdf/description/yaml_values.h"

#include <Eigen/Geometry>

#include <string>

namespace parallel_aspects {

/// A frame as it is written: the name of a link, or a place in its frame, so that nobody edits a URDF of
/// others.
struct ConfiguredFrame {
  std::string link;
  Eigen::Isometry3d in_link = Eigen::Isometry3d::Identity();  ///< [m]
  std::string name;                                           ///< for messages and tf; empty where unsaid
  bool is_link = true;                                        ///< written as the name of a link alone

  /// The name, or else that of the link.
  const std::string& label() const noexcept { return name.empty() ? link : name; }
};

/// Reads `link`, or `{link: NAME, xyz: [x, y, z], rpy: [roll, pitch, yaw], name: NAME}`. False, and a message
/// that names `where`, when it is neither.
bool read_frame(const YamlValues& yaml, const YAML::Node& node, const std::string& where,
                ConfiguredFrame& frame);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CONFIG_FRAME_CONFIG_H
