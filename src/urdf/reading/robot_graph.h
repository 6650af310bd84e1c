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

/// Which joints of a graph form the tree, and which close its loops.
struct SpanningTree {
  enum class Role { tree, reversed, closure, left_out };

  std::size_t base = 0;            ///< body
  std::vector<Role> roles;         ///< of each joint; reversed: the child is nearer to the base
  std::vector<bool> is_connected;  ///< each body, to the base by joints
};

/// Slides are in the tree, as no closure can slide; then actuated joints, whose values are to be known; then
/// joints in the order of the file, and constraints last. The base is the world or, where the robot floats,
/// the first body of the largest part.
SpanningTree spanning_tree(const RobotGraph& graph);

/// One axis of a joint.
struct DirectedStep {
  Eigen::Vector3d axis;  ///< unit vector, as the child is turned at zero
  bool slides = false;   ///< along the axis; else it turns about it
  JointLimits limits;    ///< rad or m
};

/// A joint as seen from the base, whose bodies it joins one axis after the other.
struct DirectedJoint {
  std::size_t parent = 0, child = 0;
  Eigen::Isometry3d from, to;  ///< the joint frame in parent and child, which coincide at zero [m]
  std::vector<DirectedStep> steps;
};

/// `reversed`: the child of the graph is nearer to the base. A ball turns about the axes x, y and z of the
/// body that it carries.
DirectedJoint directed(const GraphJoint& joint, bool reversed);

/// Whether the last axis may be taken through the origin of the body that it carries.
bool ends_in_origin(const DirectedJoint& joint);

/// The graph as a URDF of its spanning tree, with elements of this package for what a URDF cannot express:
/// <loop_closure>, which `dialects::equality` and `dialects::sdf_joint` read, <actuated_joint name/> and
/// <reader_note text/>. What these cannot express either is added to the graph's problems. A joint of several
/// axes becomes revolute joints, about fixed axes of the child one after the other.
std::string urdf_text(RobotGraph& graph, const std::string& file);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_ROBOT_GRAPH_H
