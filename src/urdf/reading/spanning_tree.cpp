// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/reading/robot_graph.h"

#include <algorithm>
#include <numeric>

namespace parallel_aspects {
namespace {

// Sets of bodies that joints connect.
class Parts {
 public:
  explicit Parts(std::size_t bodies) : above_(bodies) { std::iota(above_.begin(), above_.end(), 0); }

  std::size_t of(std::size_t body) const {
    while (above_[body] != body) body = above_[body];
    return body;
  }

  // The first body stands for the set; false where both are in one.
  bool join(std::size_t one, std::size_t other) {
    one = of(one);
    other = of(other);
    above_[std::max(one, other)] = std::min(one, other);
    return one != other;
  }

 private:
  std::vector<std::size_t> above_;
};

int rank(const GraphJoint& joint, bool has_parent) {
  if (joint.kind == GraphJointKind::prismatic) return 0;
  if (joint.is_actuated) return 1;
  if (joint.is_constraint) return 4;
  return has_parent ? 3 : 2;
}

// Those that go into the tree first come first.
std::vector<std::size_t> by_rank(const RobotGraph& graph) {
  std::vector<int> ranks;
  std::vector<bool> has_parent(graph.bodies.size(), false);
  for (const GraphJoint& joint : graph.joints) {
    ranks.push_back(rank(joint, has_parent[joint.bodies[1]]));
    has_parent[joint.bodies[1]] = true;
  }
  std::vector<std::size_t> order(graph.joints.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t one, std::size_t other) { return ranks[one] < ranks[other]; });
  return order;
}

// The part with the most joints that move; of several that with the first body.
std::size_t base_of(const RobotGraph& graph, const Parts& parts) {
  std::vector<std::size_t> moving(graph.bodies.size(), 0);
  for (const GraphJoint& joint : graph.joints)
    if (joint.kind != GraphJointKind::fixed) ++moving[parts.of(joint.bodies[0])];
  return static_cast<std::size_t>(std::max_element(moving.begin(), moving.end()) - moving.begin());
}

using Role = SpanningTree::Role;

// Walks from the base outwards.
void find_reversed(const RobotGraph& graph, SpanningTree& tree) {
  std::vector<std::size_t> reached{tree.base};
  std::vector<bool> is_done(graph.joints.size(), false);
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (std::size_t joint = 0; joint < graph.joints.size(); ++joint) {
      const auto& bodies = graph.joints[joint].bodies;
      const bool is_child = bodies[1] == reached[k];
      if (tree.roles[joint] != Role::tree || is_done[joint] || (!is_child && bodies[0] != reached[k]))
        continue;
      is_done[joint] = true;
      if (is_child) tree.roles[joint] = Role::reversed;
      reached.push_back(bodies[is_child ? 0 : 1]);
    }
}

}  // namespace

SpanningTree spanning_tree(const RobotGraph& graph) {
  Parts parts(graph.bodies.size());
  SpanningTree tree{0, std::vector<Role>(graph.joints.size(), Role::closure), {}};
  for (const std::size_t joint : by_rank(graph)) {
    const auto& [parent, child] = graph.joints[joint].bodies;
    if (parts.join(parent, child)) tree.roles[joint] = Role::tree;
  }
  tree.base = base_of(graph, parts);
  for (std::size_t body = 0; body < graph.bodies.size(); ++body)
    tree.is_connected.push_back(parts.of(body) == parts.of(tree.base));
  for (std::size_t joint = 0; joint < graph.joints.size(); ++joint)
    if (!tree.is_connected[graph.joints[joint].bodies[0]]) tree.roles[joint] = Role::left_out;
  find_reversed(graph, tree);
  return tree;
}
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
