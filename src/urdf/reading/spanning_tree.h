// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_SPANNING_TREE_H
#define PARALLEL_ASPECTS_URDF_READING_SPANNING_TREE_H

#include "urdf/reading/robot_graph.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace parallel_aspects {

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_SPANNING_TREE_H
