// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CONFIG_MECHANISM_CONFIG_H
#define PARALLEL_ASPECTS_URDF_CONFIG_MECHANISM_CONFIG_H

#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"
#include "urdf/config/constraints_config.h"
#include "urdf/description/closure.h"
#include "urdf/description/yaml_values.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A frame as it is written: the name of a link, or a place in its frame, so that a URDF of others
/// needs no edit.
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

/// A closure by the names of its frames.
struct ConfiguredClosure {
  std::array<ConfiguredFrame, 2> frames;
  ClosureType type = ClosureType::automatic;
};

/// The `mechanism:` and `constraints:` parts of a robot's YAML file; names are not yet looked up.
struct MechanismConfig {
  std::string name;          ///< empty: that of the URDF
  std::string base_link;     ///< empty: the root link
  std::string frame_prefix;  ///< of links in tf; not read from the file, empty for none
  ConfiguredFrame operational_point;
  std::vector<std::string> actuated_joints;
  bool lists_actuated_joints = false;  ///< otherwise the URDF may say them
  std::optional<TaskSpace> task_space;
  std::vector<ConfiguredClosure> closures;
  bool lists_closures = false;                    ///< otherwise the URDF or the rest of the file may say them
  std::vector<ConfiguredClosure> added_closures;  ///< besides those that the URDF says
  ConstraintsConfig constraints;
  std::optional<double> symmetrize;  ///< tolerance, in sizes of the robot and rad; none: off
  double tolerance = 0.0;            ///< of the robot as it is built, in sizes of it
  std::vector<double> start;         ///< start.pose, as far as it is a list of numbers; the node checks it
};

/// Whether the top of the file has the keys of a loop_closures.yaml of sw2robot.
bool is_loop_closures_file(const YAML::Node& root);

/// Reads it from the text of the whole file; other top-level keys are for the node. What is wrong is added to
/// `problems`, each a message that names `file` and the key.
MechanismConfig read_mechanism_config(const std::string& text, const std::string& file, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CONFIG_MECHANISM_CONFIG_H
