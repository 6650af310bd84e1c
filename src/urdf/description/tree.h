// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_URDF_DESCRIPTION_TREE_H
#define PARALLEL_ASPECTS_URDF_DESCRIPTION_TREE_H

#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace parallel_aspects {

enum class JointMotion { fixed, revolute, prismatic };

/// A joint of the tree. Its frame is that of the child link at value zero.
struct TreeJoint {
  std::string name;
  JointMotion motion = JointMotion::fixed;
  std::size_t parent = 0;                                    ///< index of a link
  std::size_t child = 0;                                     ///< index of a link
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  ///< joint frame in the parent link's [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();           ///< unit vector in the joint frame
  JointLimits limits;                                        ///< rad or m
  std::optional<std::size_t> variable;  ///< index into the joint values; none for a fixed joint
  bool mimics = false;                  ///< whether the URDF lets it follow another joint
  /// Roll, pitch and yaw of the origin as written, where one is beyond a full turn [rad].
  std::optional<Eigen::Vector3d> wide_angles = std::nullopt;
};

/// Whether a joint turns all the way round: its limits, if any, lack no more of a full turn than rounding
/// does, and hold modulo a turn.
bool turns_freely(const TreeJoint& joint) noexcept;

/// Links and joints of a URDF, as it says them: open where the mechanism is closed.
struct Tree {
  std::string name;
  std::vector<std::string> links;    ///< the root first
  std::vector<TreeJoint> joints;     ///< those nearer to the root first
  std::vector<std::size_t> movable;  ///< indices of the movable joints, in the order of the file
  std::vector<std::optional<std::size_t>> joint_above;  ///< of each link; none for the root

  std::optional<std::size_t> link_named(const std::string& name) const;
  std::optional<std::size_t> joint_named(const std::string& name) const;

  /// Number of joint values.
  Eigen::Index variables() const noexcept { return static_cast<Eigen::Index>(movable.size()); }

  const TreeJoint& joint_of(std::size_t variable) const { return joints[movable[variable]]; }
};

/// Whether a joint hangs on this link.
bool has_child(const Tree& tree, std::size_t link);

/// The link above that a movable joint carries, or the root: the same for all links of a body.
std::size_t body_of(const Tree& tree, std::size_t link);

using Poses = std::vector<Eigen::Isometry3d>;

/// Frame of every link in the frame of link `base` [m], for these joint values.
Poses link_poses(const Tree& tree, std::size_t base, const Eigen::VectorXd& values);

/// The same of the root and of the links below these joints alone, which hold all joints above each and above
/// the base, those nearer to the root first.
Poses link_poses(const Tree& tree, std::size_t base, const Eigen::VectorXd& values,
                 const std::vector<std::size_t>& joints);

/// What tolerances of lengths are shares of [m]: the widest distance between the origins of links that
/// movable joints move against the base, and these points of the robot. Where the base has its own origin
/// does not matter. 1 where all are in one point.
double mechanism_size(const Tree& tree, std::size_t base, const Poses& poses,
                      std::vector<Eigen::Vector3d> points = {});

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_URDF_DESCRIPTION_TREE_H
