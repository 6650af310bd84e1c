// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/serial_arm.h"

#include <algorithm>
#include <vector>

namespace parallel_aspects {
namespace {

// Of each link: the joints that its body carries, each with how many are in the longest chain from it on.
struct Carried {
  std::size_t joint = 0, chain = 0;
};

std::size_t body_link(const Tree& tree, std::size_t link) {
  for (auto joint = tree.joint_above[link]; joint && !tree.joints[*joint].variable;
       joint = tree.joint_above[link])
    link = tree.joints[*joint].parent;
  return link;
}

std::vector<std::vector<Carried>> carried_joints(const Tree& tree) {
  std::vector<std::vector<Carried>> carried(tree.links.size());
  for (std::size_t k = tree.joints.size(); k-- > 0;) {
    const TreeJoint& joint = tree.joints[k];
    if (!joint.variable) continue;
    std::size_t chain = 1;
    for (const Carried& next : carried[joint.child]) chain = std::max(chain, next.chain + 1);
    carried[body_link(tree, joint.parent)].push_back({k, chain});
  }
  return carried;
}

}  // namespace

std::optional<std::string> serial_arm_text(const Tree& tree, const std::string& urdf_name) {
  const std::vector<std::vector<Carried>> carried = carried_joints(tree);
  std::size_t link = 0, joints = 0;
  while (!carried[link].empty()) {
    const auto chains = std::count_if(carried[link].begin(), carried[link].end(),
                                      [](const Carried& each) { return each.chain > 1; });
    const bool is_hand = chains == 0 && carried[link].size() > 1;
    if (chains > 1 || (link == 0 && carried[link].size() > 1)) return std::nullopt;
    if (is_hand) break;
    const auto longest =
        std::max_element(carried[link].begin(), carried[link].end(),
                         [](const Carried& one, const Carried& other) { return one.chain < other.chain; });
    link = tree.joints[longest->joint].child;
    ++joints;
  }
  if (joints == 0) return std::nullopt;
  return urdf_name + " is a serial arm, one chain of " + std::to_string(joints) +
         (joints == 1 ? " joint" : " joints") + " from link '" + tree.links.front() + "' to link '" +
         tree.links[link] +
         "' without a loop; there is nothing to close, and only parallel robots are treated.";
}

}  // namespace parallel_aspects
