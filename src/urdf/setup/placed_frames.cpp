// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/placed_frames.h"

#include "urdf/description/xml_values.h"

#include <algorithm>

namespace parallel_aspects {

std::optional<PlacedFrame> placed_frame(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos || at == 0) return std::nullopt;
  std::string coordinates = text.substr(at + 1);
  if (std::count(coordinates.begin(), coordinates.end(), ':') != 2) return std::nullopt;
  std::replace(coordinates.begin(), coordinates.end(), ':', ' ');
  const auto xyz = numbers(coordinates);
  if (!xyz || xyz->size() != 3) return std::nullopt;
  return PlacedFrame{text.substr(0, at), {(*xyz)[0], (*xyz)[1], (*xyz)[2]}};
}

void add_placed_frame(Tree& tree, const std::string& text) {
  const auto frame = placed_frame(text);
  const auto parent = frame ? tree.link_named(frame->link) : std::nullopt;
  if (!parent || tree.link_named(text)) return;
  TreeJoint joint;
  joint.name = text;
  joint.parent = *parent;
  joint.child = tree.links.size();
  joint.origin.translation() = frame->xyz;
  tree.joint_above.emplace_back(tree.joints.size());
  tree.joints.push_back(joint);
  tree.links.push_back(text);
}

}  // namespace parallel_aspects
