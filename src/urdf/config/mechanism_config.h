// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CONFIG_MECHANISM_CONFIG_H
#define PARALLEL_ASPECTS_URDF_CONFIG_MECHANISM_CONFIG_H

#include "parallel_aspects/model/problems.h"
#include "parallel_aspects/model/task_space.h"
#include "urdf/config/constraints_config.h"
#include "urdf/config/frame_config.h"
#include "urdf/description/closure.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

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

/// Reads it from the text of the whole file; other top-level keys are for the node. What is wrong is added to
/// `problems`, each a message that names `file` and the key.
MechanismConfig read_mechanism_config(const std::string& text, const std::string& file, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CONFIG_MECHANISM_CONFIG_H
