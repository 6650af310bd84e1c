// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/left_open.h"

#include "urdf/description/name_words.h"

#include <algorithm>
#include <map>

namespace parallel_aspects {

std::vector<bool> fittings(const Tree& tree) {
  std::vector<bool> marks(tree.links.size()), holds(tree.links.size(), false);
  for (std::size_t link = 0; link < marks.size(); ++link) marks[link] = says_fitting(tree.links[link]);
  for (auto joint = tree.joints.rbegin(); joint != tree.joints.rend(); ++joint) {
    if (holds[joint->child]) marks[joint->child] = false;
    if (!marks[joint->child]) holds[joint->parent] = true;
  }
  marks.front() = false;
  return marks;
}

std::vector<bool> with_fingers(const Tree& tree, const Bodies& bodies, std::vector<bool> left_open) {
  std::vector<bool> carries(bodies.count(), false);
  for (const TreeJoint& joint : tree.joints)
    if (joint.variable && !left_open[joint.child]) carries[bodies.of(joint.parent)] = true;
  std::map<std::size_t, std::vector<std::size_t>> ends_on;  // bodies, by the one that carries them
  for (const TreeJoint& joint : tree.joints) {
    const std::size_t body = bodies.of(joint.child), carrier = bodies.of(joint.parent);
    const auto& links = bodies.links(body);
    const bool named =
        std::any_of(links.begin(), links.end(), [&](std::size_t link) { return says_end(tree.links[link]); });
    if (joint.variable && !left_open[joint.child] && !carries[body] && carrier != 0 && !named)
      ends_on[carrier].push_back(body);
  }
  for (const auto& [carrier, ends] : ends_on)
    for (const std::size_t body : ends)
      for (const std::size_t link : bodies.links(body))
        if (ends.size() > 1) left_open[link] = true;
  return left_open;
}

}  // namespace parallel_aspects
