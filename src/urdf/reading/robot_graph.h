// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_ROBOT_GRAPH_H
#define PARALLEL_ASPECTS_URDF_READING_ROBOT_GRAPH_H

#include "parallel_aspects/model/manipulator.h"
#include "parallel_aspects/model/problems.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace parallel_aspects {

enum class GraphJointKind { fixed, revolute, prismatic, universal, ball };

/// A joint or a constraint between two bodies, whose frames coincide at value zero.
struct GraphJoint {
  std::string name;
  std::string element;  ///< for messages, as "<connect> 'loop'"
  GraphJointKind kind = GraphJointKind::fixed;
  std::array<std::size_t, 2> bodies{0, 0};  ///< parent and child
  std::array<Eigen::Isometry3d, 2> frames{Eigen::Isometry3d::Identity(),
                                          Eigen::Isometry3d::Identity()};  ///< in these bodies [m]
  std::array<Eigen::Vector3d, 2> axes{Eigen::Vector3d::UnitZ(),
                                      Eigen::Vector3d::UnitX()};  ///< in the joint frame; unit vectors
  std::array<JointLimits, 2> limits;                              ///< about or along these axes
  std::optional<double> effort;                                   ///< largest force or torque, where stated
  bool is_actuated = false;
  bool follows_another = false;  ///< a mimic joint
  /// A constraint, which holds two bodies and is no joint of the tree unless a body has no other.
  bool is_constraint = false;
};

/// A named place on a body.
struct GraphFrame {
  std::string name;
  std::size_t body = 0;
  Eigen::Isometry3d in_body = Eigen::Isometry3d::Identity();  ///< [m]
};

/// A robot as the formats have it that can describe loops: a graph, no tree. Body 0 is the world.
struct RobotGraph {
  std::string name;
  std::string closures_described_by;  ///< what a loop is written in, for messages
  std::vector<std::string> bodies;    ///< names
  std::vector<GraphJoint> joints;     ///< in the order of the file
  std::vector<GraphFrame> frames;
  std::vector<std::string> notes;  ///< what was not used, each a message without the name of the file
  Problems problems;               ///< each a message that names the file
};

/// That name, or with a number behind it where it is taken; it is then taken, too.
inline std::string new_name(const std::string& name, std::set<std::string>& taken) {
  std::string result = name;
  for (int k = 2; !taken.insert(result).second; ++k) result = name + "_" + std::to_string(k);
  return result;
}

/// Reads `file` into an empty graph; a library for each format has such a function.
using ReadRobotGraph = void (*)(const std::string& file, RobotGraph& graph);

/// The name of that function in the library. The number changes with the structs above.
inline constexpr const char* read_robot_graph_symbol = "parallel_aspects_read_robot_graph_1";

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_ROBOT_GRAPH_H
