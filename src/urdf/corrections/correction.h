// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_CORRECTIONS_CORRECTION_H
#define PARALLEL_ASPECTS_URDF_CORRECTIONS_CORRECTION_H

#include "urdf/closing/resolved_config.h"
#include "urdf/description/messages.h"
#include "urdf/description/tree.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects {

/// A change of one element of a description that may be what it needs. A guess: whether the element is at
/// fault shows where the corrected description is recognised.
struct Correction {
  std::string element;  ///< "joint 'a'", "closure 'a - b'"; corrections of one element exclude each other
  Note fault;           ///< "robot.urdf lets joint 'a' turn about (1, 0, 0)"
  std::string remedy;   ///< "write <axis xyz=\"0 0 1\"/> for joint 'a'"
  bool like_others = false;  ///< whether it makes the element what most others of its kind are
  std::function<void(Tree&, ResolvedConfig&)> apply;
  bool fixes_joint = false;  ///< whether it takes a joint out that may be one too many
};

using Corrections = std::vector<Correction>;

/// "1 0 0", as an attribute of a URDF has it.
std::string as_attribute(const Eigen::Vector3d& vector);

/// "(1, 0, 0)", for messages.
std::string in_brackets(const Eigen::Vector3d& vector);

/// "[1, 0, 0]", as a YAML has it.
std::string as_list(const Eigen::Vector3d& vector);

/// The rpy of a rotation, as a URDF has it [rad].
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation);

/// The inverse.
Eigen::Matrix3d rotation_of(const Eigen::Vector3d& roll_pitch_yaw);

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

#endif  // PARALLEL_ASPECTS_URDF_CORRECTIONS_CORRECTION_H
