// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/tree.h"

#include <algorithm>
#include <numeric>

namespace parallel_aspects {
namespace {

Eigen::Isometry3d motion_of(const TreeJoint& joint, double value) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (joint.motion == JointMotion::revolute) motion.linear() = Eigen::AngleAxisd(value, joint.axis).matrix();
  if (joint.motion == JointMotion::prismatic) motion.translation() = value * joint.axis;
  return motion;
}

}  // namespace

std::optional<std::size_t> Tree::link_named(const std::string& wanted) const {
  const auto found = std::find(links.begin(), links.end(), wanted);
  if (found == links.end()) return std::nullopt;
  return static_cast<std::size_t>(found - links.begin());
}

std::optional<std::size_t> Tree::joint_named(const std::string& wanted) const {
  const auto found = std::find_if(joints.begin(), joints.end(),
                                  [&](const TreeJoint& joint) { return joint.name == wanted; });
  if (found == joints.end()) return std::nullopt;
  return static_cast<std::size_t>(found - joints.begin());
}

Poses link_poses(const Tree& tree, std::size_t base, const Eigen::VectorXd& values) {
  std::vector<std::size_t> all(tree.joints.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return link_poses(tree, base, values, all);
}

Poses link_poses(const Tree& tree, std::size_t base, const Eigen::VectorXd& values,
                 const std::vector<std::size_t>& joints) {
  Poses poses(tree.links.size(), Eigen::Isometry3d::Identity());
  for (const std::size_t index : joints) {
    const TreeJoint& joint = tree.joints[index];
    poses[joint.child] = poses[joint.parent] * joint.origin;
    if (joint.variable)
      poses[joint.child] =
          poses[joint.child] * motion_of(joint, values[static_cast<Eigen::Index>(*joint.variable)]);
  }
  if (base == 0) return poses;
  const Eigen::Isometry3d to_base = poses[base].inverse();
  poses.front() = to_base * poses.front();
  for (const std::size_t index : joints) {
    Eigen::Isometry3d& pose = poses[tree.joints[index].child];
    pose = to_base * pose;
  }
  return poses;
}

bool has_child(const Tree& tree, std::size_t link) {
  return std::any_of(tree.joints.begin(), tree.joints.end(),
                     [link](const TreeJoint& joint) { return joint.parent == link; });
}

}  // namespace parallel_aspects
