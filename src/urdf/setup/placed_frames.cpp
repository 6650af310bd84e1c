// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/placed_frames.h"

#include "urdf/description/name_words.h"
#include "urdf/description/xml_values.h"

#include <algorithm>

namespace parallel_aspects {
namespace {

constexpr double same_length = 1e-6;  // to which an answer is typed [m]

// The joint that has the link of the other end in that place on a link of the same name but for its number.
const TreeJoint* lender_of(const Tree& tree, const std::string& end, const std::string& other) {
  const auto one = placed_frame(end), two = placed_frame(other);
  if (!one || !two || one->xyz.norm() <= same_length) return nullptr;
  for (const TreeJoint& joint : tree.joints) {
    const std::string& carrier = tree.links[joint.parent];
    if (!joint.variable && tree.links[joint.child] == two->link && carrier != one->link &&
        role_of(carrier) == role_of(one->link) &&
        (joint.origin.translation() - one->xyz).norm() <= same_length)
      return &joint;
  }
  return nullptr;
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

std::optional<std::string> note_on_borrowed_lengths(const Tree& tree,
                                                    std::vector<std::array<std::string, 2>> closures) {
  const TreeJoint* lender = nullptr;
  std::string option;
  for (auto& pair : closures) {
    for (const std::size_t k : {0, 1})
      if (const TreeJoint* joint = lender_of(tree, pair[k], pair[1 - k])) {
        lender = joint;
        pair[k] = placed_frame(pair[k])->link;
      }
    option += (option.empty() ? "" : " ") + pair[0] + "=" + pair[1];
  }
  if (lender == nullptr) return std::nullopt;
  const std::string &carrier = tree.links[lender->parent], &carried = tree.links[lender->child];
  return "These legs are not alike, which is perhaps not your robot: --closures ends some where link '" +
         carried + "' is on '" + carrier + "', by the length of joint '" + lender->name +
         "', while the leg of '" + carrier + "' ends at its origin; if all end so, write --closures '" +
         option + "'.";
}

}  // namespace parallel_aspects
