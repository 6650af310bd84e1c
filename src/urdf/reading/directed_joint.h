// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_READING_DIRECTED_JOINT_H
#define PARALLEL_ASPECTS_URDF_READING_DIRECTED_JOINT_H

#include "urdf/reading/robot_graph.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_URDF_READING_DIRECTED_JOINT_H
