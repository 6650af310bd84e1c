// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_TREE_CHANGES_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_TREE_CHANGES_H

#include "urdf/description/tree.h"

#include <cstddef>

namespace parallel_aspects {

/// Hangs what joint `joint` carries on link `parent`; the joint stays as it is in its own frames.
void hang(Tree& tree, std::size_t joint, std::size_t parent);

/// A movable joint that is to come in, its name that of the link that it brings; the axis in its frame.
struct NewJoint {
  std::string name;
  JointMotion motion = JointMotion::prismatic;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
};

/// Puts a joint between the parent of joint `joint` and that joint, and its link after it.
void insert_before(Tree& tree, const std::string& joint, const NewJoint& added);

/// Puts a joint between joint `joint` and its child, and its link before it.
void insert_after(Tree& tree, const std::string& joint, const NewJoint& added);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_TREE_CHANGES_H
