// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/anchors.h"

#include "urdf/closing/assembly.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace parallel_aspects {
namespace {

// Else the chain there is a passive one, no leg.
bool is_actuated_above(const Tree& tree, const ResolvedConfig& resolved, std::size_t link) {
  const auto& actuated = resolved.actuated_joints.variables;
  for (auto joint = tree.joint_above[link]; joint; joint = tree.joint_above[tree.joints[*joint].parent])
    if (const auto variable = tree.joints[*joint].variable;
        variable && std::find(actuated.begin(), actuated.end(), *variable) != actuated.end())
      return true;
  return false;
}

// Where joints and closures are on the body of the platform, in the frame of that body at zero.
std::vector<Eigen::Vector3d> anchors(const Tree& tree, const ResolvedConfig& resolved) {
  const std::size_t body = body_of(tree, resolved.actuated_joints.platform_link);
  const Poses poses = link_poses(tree, body, Eigen::VectorXd::Zero(tree.variables()));
  std::vector<Eigen::Vector3d> points;
  for (const Closure& closure : resolved.closures)
    for (const LinkFrame& frame : closure.frames)
      if (body_of(tree, frame.link) == body)
        points.push_back((poses[frame.link] * frame.in_link).translation());
  for (const TreeJoint& joint : tree.joints)
    if (joint.variable && ((joint.child == body && is_actuated_above(tree, resolved, body)) ||
                           body_of(tree, joint.parent) == body))
      points.push_back(poses[joint.child].translation());
  return points;
}

}  // namespace

std::size_t body_of(const Tree& tree, std::size_t link) {
  for (auto joint = tree.joint_above[link]; joint && !tree.joints[*joint].variable;
       joint = tree.joint_above[link])
    link = tree.joints[*joint].parent;
  return link;
}

bool legs_share_anchors(const Tree& tree, const ResolvedConfig& resolved, double size) {
  const std::vector<Eigen::Vector3d> points = anchors(tree, resolved);
  bool any_together = false, any_apart = false;
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t other = 0; other < k; ++other) {
      const bool together = (points[k] - points[other]).norm() < closing_tolerance * size;
      any_together = any_together || together;
      any_apart = any_apart || !together;
    }
  return any_together && any_apart;
}

}  // namespace parallel_aspects
