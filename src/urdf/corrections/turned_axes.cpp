// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/turned_axes.h"

#include "model/linear_algebra.h"
#include "urdf/corrections/anchors.h"

#include <Eigen/Geometry>

#include <optional>
#include <set>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

constexpr double nearly_half_a_turn = -0.999;  // cosine of a turn whose axis is not known

// The joint on the base that carries a joint, or is it.
std::optional<std::size_t> start_of_leg(const Tree& tree, std::size_t base, std::size_t joint) {
  for (std::optional<std::size_t> at = joint; at;
       at = tree.joint_above[body_of(tree, tree.joints[*at].parent)])
    if (body_of(tree, tree.joints[*at].parent) == base) return at;
  return std::nullopt;
}

struct Sibling {
  std::size_t joint = 0, start = 0;
};

// Those of other legs.
std::vector<Sibling> siblings_in_other_legs(const Tree& tree, std::size_t base, const LoopJoints& loops,
                                            std::size_t joint, std::size_t own_start) {
  std::vector<Sibling> found;
  for (const std::size_t sibling : loops.siblings(joint)) {
    const auto start = start_of_leg(tree, base, sibling);
    if (start && *start != own_start && tree.joints[sibling].motion == tree.joints[joint].motion)
      found.push_back({sibling, *start});
  }
  return found;
}

bool any_have_one_axis(const LoopJoints& loops, const std::vector<Sibling>& siblings) {
  for (const Sibling& one : siblings)
    for (const Sibling& other : siblings)
      if (one.start != other.start && loops.same_motion(one.joint, other.joint)) return true;
  return false;
}

}  // namespace

std::vector<Vector3d> turned_axes(const Tree& tree, const ResolvedConfig& resolved, const LoopJoints& loops,
                                  std::size_t joint) {
  const std::size_t base = body_of(tree, resolved.base);
  const auto own_start = start_of_leg(tree, base, joint);
  if (!own_start) return {};
  const std::vector<Sibling> siblings = siblings_in_other_legs(tree, base, loops, joint, *own_start);
  if (any_have_one_axis(loops, siblings)) return {};
  const Poses poses = link_poses(tree, resolved.base, Eigen::VectorXd::Zero(tree.variables()));
  const auto place = [&](std::size_t start) {
    return Vector3d(poses[tree.joints[start].child].translation());
  };
  std::set<std::size_t> starts{*own_start};
  for (const Sibling& sibling : siblings) starts.insert(sibling.start);
  Vector3d middle = Vector3d::Zero();
  for (const std::size_t start : starts) middle += place(start) / static_cast<double>(starts.size());
  const Vector3d own = (place(*own_start) - middle).normalized();
  std::vector<Vector3d> axes;
  for (const Sibling& sibling : siblings) {
    const Vector3d other = (place(sibling.start) - middle).normalized();
    if (!(other.dot(own) > nearly_half_a_turn)) continue;
    const Vector3d axis = poses[tree.joints[sibling.joint].child].linear() * tree.joints[sibling.joint].axis;
    axes.push_back(poses[tree.joints[joint].child].linear().transpose() *
                   (shortest_rotation(other, own) * axis));
  }
  return axes;
}

}  // namespace parallel_aspects
