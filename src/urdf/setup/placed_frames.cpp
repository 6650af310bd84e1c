// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/placed_frames.h"

#include "model/number_text.h"
#include "urdf/description/name_words.h"
#include "urdf/description/xml_values.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double same_place = 1e-6;  // [m]

std::vector<std::vector<std::size_t>> joints_below(const Tree& tree) {
  std::vector<std::vector<std::size_t>> below(tree.links.size());
  for (std::size_t joint = 0; joint < tree.joints.size(); ++joint)
    below[tree.joints[joint].parent].push_back(joint);
  return below;
}

// Of a link that something else than its own joint is on: where that is.
std::optional<Eigen::Vector3d> far_end(const Tree& tree, const std::vector<std::size_t>& below) {
  if (below.size() != 1) return std::nullopt;
  const Eigen::Vector3d end = tree.joints[below.front()].origin.translation();
  return end.norm() > same_place ? std::optional<Eigen::Vector3d>(end) : std::nullopt;
}

}  // namespace

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

bool add_far_ends(Tree& tree) {
  const auto below = joints_below(tree);
  std::map<std::string, std::vector<std::size_t>> alike;
  for (const TreeJoint& joint : tree.joints)
    if (joint.motion == JointMotion::revolute) alike[role_of(tree.links[joint.child])].push_back(joint.child);
  std::vector<std::string> frames;
  for (const auto& [role, links] : alike) {
    std::optional<Eigen::Vector3d> place;
    bool agree = true;
    for (const std::size_t link : links) {
      const auto end = far_end(tree, below[link]);
      if (end && place) agree = agree && (*end - *place).norm() < same_place;
      if (end) place = end;
    }
    for (const std::size_t link : links)
      if (agree && place && below[link].empty()) frames.push_back(placed_name(tree.links[link], *place));
  }
  for (const std::string& frame : frames) add_placed_frame(tree, frame);
  return !frames.empty();
}

}  // namespace parallel_aspects
