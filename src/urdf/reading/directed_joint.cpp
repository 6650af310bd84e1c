// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/reading/directed_joint.h"

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

// Of coordinates [m] and of products of unit vectors: no more than what sums of frames round.
constexpr double rounding = 1e-12;

}  // namespace

DirectedJoint directed(const GraphJoint& joint, bool reversed) {
  const std::size_t near = reversed ? 1 : 0, far = 1 - near;
  DirectedJoint result{joint.bodies[near], joint.bodies[far], joint.frames[near], joint.frames[far], {}};
  const auto add = [&](const Vector3d& axis, const JointLimits& limits) {
    const Vector3d turned = result.to.linear() * (reversed ? Vector3d(-axis) : axis);
    result.steps.insert(reversed ? result.steps.begin() : result.steps.end(),
                        DirectedStep{turned, joint.kind == GraphJointKind::prismatic, limits});
  };
  switch (joint.kind) {
    case GraphJointKind::fixed:
      break;
    case GraphJointKind::revolute:
    case GraphJointKind::prismatic:
      add(joint.axes[0], joint.limits[0]);
      break;
    case GraphJointKind::universal:
      for (std::size_t k = 0; k < 2; ++k) add(joint.axes[k], joint.limits[k]);
      break;
    case GraphJointKind::ball:  // about the child's own axes, as all do
      for (const Vector3d axis : {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()})
        result.steps.push_back({axis, false, JointLimits{}});
      break;
  }
  return result;
}

bool ends_in_origin(const DirectedJoint& joint) {
  const Vector3d away = joint.to.translation();
  if (joint.steps.size() != 1) return joint.steps.empty() || away.norm() < rounding;
  return joint.steps.front().slides || joint.steps.front().axis.cross(away).norm() < rounding;
}

}  // namespace parallel_aspects
