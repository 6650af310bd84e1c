// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_SPANNING_TREE_H
#define PARALLEL_ASPECTS_URDF_READING_SPANNING_TREE_H

#include "urdf/reading/robot_graph.h"

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_READING_SPANNING_TREE_H
