// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/body_graph.h"

#include <algorithm>

namespace parallel_aspects {

Bodies::Bodies(const Tree& tree) : body_(tree.links.size(), 0), links_{{0}} {
  for (const TreeJoint& joint : tree.joints) {
    if (!joint.variable) {
      body_[joint.child] = body_[joint.parent];
    } else {
      body_[joint.child] = links_.size();
      links_.emplace_back();
    }
    links_[body_[joint.child]].push_back(joint.child);
  }
}

BodyGraph::BodyGraph(const Tree& tree, const Bodies& bodies, const std::vector<Closure>& closures)
    : bodies_(bodies), in_loop_(static_cast<std::size_t>(tree.variables()), false) {
  carrier_.assign(bodies.count(), 0);
  std::vector<int> crossings(bodies.count(), 0);
  for (const TreeJoint& joint : tree.joints)
    if (joint.variable) carrier_[bodies.of(joint.child)] = bodies.of(joint.parent);
  for (const Closure& closure : closures) {
    std::fill(crossings.begin(), crossings.end(), 0);
    for (const LinkFrame& frame : closure.frames)
      for (std::size_t body = bodies.of(frame.link); body != 0; body = carrier_[body]) ++crossings[body];
    for (const TreeJoint& joint : tree.joints)
      if (joint.variable && crossings[bodies.of(joint.child)] == 1) in_loop_[*joint.variable] = true;
    edges_.push_back({bodies.of(closure.frames[0].link), bodies.of(closure.frames[1].link)});
  }
  for (const TreeJoint& joint : tree.joints)
    if (joint.variable && in_loop_[*joint.variable])
      edges_.push_back({bodies.of(joint.parent), bodies.of(joint.child)});
}

bool BodyGraph::touches_loop(std::size_t body) const {
  return std::any_of(edges_.begin(), edges_.end(),
                     [body](const Edge& edge) { return edge.from == body || edge.to == body; });
}

std::optional<std::size_t> BodyGraph::base() const {
  // Bodies nearer to the root have lower numbers on each way.
  for (std::size_t body = 0; body < bodies_.count(); ++body)
    if (touches_loop(body)) return body;
  return std::nullopt;
}

std::vector<std::size_t> BodyGraph::moving_bodies(std::size_t base) const {
  std::vector<std::size_t> result;
  for (std::size_t body = 0; body < bodies_.count(); ++body)
    if (body != base && touches_loop(body)) result.push_back(body);
  return result;
}

std::vector<std::size_t> movable_joints_to(const Tree& tree, std::size_t link) {
  std::vector<std::size_t> joints;
  for (auto above = tree.joint_above[link]; above; above = tree.joint_above[tree.joints[*above].parent])
    if (tree.joints[*above].variable) joints.push_back(*above);
  std::reverse(joints.begin(), joints.end());
  return joints;
}

std::size_t closed_again(const Bodies& bodies, const std::vector<Closure>& closures,
                         const std::vector<Closure>& others) {
  const auto pair_of = [&](const Closure& closure) {
    return std::minmax({bodies.of(closure.frames[0].link), bodies.of(closure.frames[1].link)});
  };
  return static_cast<std::size_t>(std::count_if(closures.begin(), closures.end(), [&](const Closure& one) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Closure& other) { return pair_of(one) == pair_of(other); });
  }));
}

}  // namespace parallel_aspects
