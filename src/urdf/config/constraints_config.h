// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CONFIG_CONSTRAINTS_CONFIG_H
#define PARALLEL_ASPECTS_URDF_CONFIG_CONSTRAINTS_CONFIG_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/pose.h"
#include "parallel_aspects/model/problems.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace YAML {
class Node;
}

namespace parallel_aspects {

/// An obstacle as it is written: a ball with a radius, or a box with a size. How many numbers a point needs
/// shows when the task space is known.
struct ConfiguredObstacle {
  std::string key;  ///< where it stands in the file
  std::string name;
  std::vector<double> center;    ///< [m]
  std::optional<double> radius;  ///< [m]
  std::vector<double> size;      ///< [m]; empty for a ball
  std::vector<double> rotation;  ///< [rad]: about z in the plane, roll, pitch and yaw in space; may be empty
};

/// A cone as it is written.
struct ConfiguredCone {
  std::string key;      ///< where it stands in the file
  std::size_t leg = 0;  ///< index, from 0
  LegEnd end = LegEnd::base;
  std::vector<double> axis;  ///< not zero; of any length
  double angle = 0.0;        ///< [rad]
};

/// The `constraints:` part of a robot's YAML file.
struct ConstraintsConfig {
  bool actuated_limits = true;
  bool passive_limits = true;
  bool strict_limits = false;  ///< whether limits that leave nearly a full turn bound aspects, too
  LinkThickness thickness;
  std::vector<ConfiguredCone> cones;
  std::optional<SelfCollision> self_collision;
  std::vector<ConfiguredObstacle> obstacles;
  std::optional<std::array<std::vector<double>, 2>> workspace;  ///< lower, upper [m]
  Margins margins;
};

/// All keys of it.
const std::vector<std::string>& constraint_keys();

/// Reads it; `node` may be undefined. What is wrong is added to `problems`, each a message that names `file`
/// and the key.
ConstraintsConfig read_constraints_config(const YAML::Node& node, const std::string& file,
                                          Problems& problems);

/// What constraints are resolved for.
struct ConstrainedRobot {
  TaskSpace space = TaskSpace::T2;
  std::size_t legs = 0;
  bool point_platform = false;  ///< the link of the operational point turns as no pose tells
};

/// The constraints of this robot, without its joint limits. Points with too few or too many numbers, links
/// and cones of legs that are not there, and cones of a platform that is a point are added to `problems`.
Constraints resolve_constraints(const ConstraintsConfig& config, const ConstrainedRobot& robot,
                                const std::string& file, Problems& problems);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CONFIG_CONSTRAINTS_CONFIG_H
