// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/left_open.h"

#include "parallel_aspects/model/manipulator.h"
#include "urdf/description/messages.h"
#include "urdf/description/name_words.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace parallel_aspects {
namespace {

constexpr std::size_t least_of_leg = 2;  // joints; a turntable has one

const SetupCandidate* taken_for(const std::string& key, const SetupResult& found) {
  for (const SetupChoice& choice : found.choices)
    if (choice.key == key) return &choice.taken;
  return nullptr;
}

bool any_says_base(const Tree& tree, const std::vector<std::size_t>& links) {
  return std::any_of(links.begin(), links.end(),
                     [&](std::size_t link) { return says_base(tree.links[link]); });
}

// Else it is on slides alone, as a platform that is hung on them.
bool turns_below(const Tree& tree, std::size_t link) {
  const std::vector<std::size_t> joints = movable_joints_to(tree, link);
  return std::any_of(joints.begin(), joints.end(),
                     [&](std::size_t joint) { return tree.joints[joint].motion == JointMotion::revolute; });
}

// Both links of each closure; nothing where one is a place.
std::vector<std::size_t> links_of_closures(const Tree& tree, const SetupCandidate& closures) {
  std::vector<std::size_t> links;
  for (const std::string& pair : closures.values) {
    const std::size_t middle = pair.find('=');
    for (const std::string& name : {pair.substr(0, middle), pair.substr(middle + 1)}) {
      const auto link = tree.link_named(name);
      if (!link) return {};
      if (std::find(links.begin(), links.end(), *link) == links.end()) links.push_back(*link);
    }
  }
  return links;
}

// Those that hold a last body, which is not named as an end, to one above the base.
std::vector<TreeJoint> joints_of_ends(const Tree& tree, const Bodies& bodies,
                                      const std::vector<bool>& left_open) {
  std::vector<bool> carries(bodies.count(), false);
  for (const TreeJoint& joint : tree.joints)
    if (joint.variable && !left_open[joint.child]) carries[bodies.of(joint.parent)] = true;
  std::vector<TreeJoint> joints;
  for (const TreeJoint& joint : tree.joints) {
    const std::size_t body = bodies.of(joint.child);
    const auto& links = bodies.links(body);
    const bool named =
        std::any_of(links.begin(), links.end(), [&](std::size_t link) { return says_end(tree.links[link]); });
    if (joint.variable && !left_open[joint.child] && !carries[body] && bodies.of(joint.parent) != 0 && !named)
      joints.push_back(joint);
  }
  return joints;
}

}  // namespace

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
  std::map<std::size_t, std::vector<std::size_t>> ends_on;  // bodies, by the one that carries them
  for (const TreeJoint& joint : joints_of_ends(tree, bodies, left_open))
    ends_on[bodies.of(joint.parent)].push_back(bodies.of(joint.child));
  for (const auto& [carrier, ends] : ends_on)
    for (const std::size_t body : ends)
      for (const std::size_t link : bodies.links(body))
        if (ends.size() > 1) left_open[link] = true;
  return left_open;
}

std::vector<bool> with_single_finger(const Tree& tree, const Bodies& bodies, std::vector<bool> left_open) {
  std::vector<std::size_t> fingers;  // links
  for (const TreeJoint& joint : joints_of_ends(tree, bodies, left_open))
    if (joint.motion == JointMotion::prismatic) fingers.push_back(joint.child);
  if (fingers.size() == 1 && turns_below(tree, fingers.front()) &&
      operational_point_likeness(tree.links[fingers.front()]) == 0)
    for (const std::size_t link : bodies.links(bodies.of(fingers.front()))) left_open[link] = true;
  return left_open;
}

std::optional<Pairing> ends_on_root(const Tree& tree, const Bodies& bodies, const SetupResult& found) {
  const SetupCandidate* base = taken_for("base_link", found);
  const SetupCandidate* closures = taken_for("closures", found);
  if (!found.mechanism || base == nullptr || closures == nullptr) return std::nullopt;
  const std::size_t link = *tree.link_named(base->values.front());
  if (!any_says_base(tree, bodies.links(0)) || any_says_base(tree, bodies.links(bodies.of(link))) ||
      movable_joints_to(tree, link).size() < least_of_leg)
    return std::nullopt;
  const Poses poses = link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()));
  Pairing on_root{{}, "where they are while all joints are zero, so that the chain is a leg"};
  for (const std::size_t end : links_of_closures(tree, *closures)) {
    on_root.pairs.push_back({0, end});
    on_root.pairs.back().in_link[0].translation() = poses[end].translation();
  }
  return on_root.pairs.empty() ? std::nullopt : std::optional<Pairing>(on_root);
}

SetupQuestion question_of_leg(const SetupResult& found, const SetupCandidate& on_root,
                              const std::string& urdf_name) {
  SetupCandidate without = *taken_for("closures", found);
  without.reason += ", and the chain is left out";
  return {"closures",
          urdf_name + " does not say whether the chain between the root and link '" +
              taken_for("base_link", found)->values.front() + "' is a leg, whose loops end on the root",
          {on_root, without},
          {}};
}

namespace {

constexpr double beside = 1e-9;  // an axis, of the distance along it

struct BeforeWrist {
  std::string joint, end;  // the first joint of the wrist; the link or place that it is on
};

// Where the joint is, on the link that carries it; along the axis does not matter in the plane.
std::string place_of(const Tree& tree, const TreeJoint& joint) {
  const Eigen::Vector3d place = joint.origin.translation();
  const double off = place.cross(joint.origin.linear() * joint.axis).norm();
  const std::string& parent = tree.links[joint.parent];
  return off <= beside * place.norm() ? parent : placed_name(parent, place);
}

// Slides after a joint that turns idly are part of the wrist as well.
std::optional<BeforeWrist> before_wrist(const Tree& tree, const Bodies& bodies, const std::string& end,
                                        const std::vector<bool>& is_idle) {
  std::optional<BeforeWrist> found;
  for (auto link = tree.link_named(end); link;) {
    const auto above = tree.joint_above[bodies.links(bodies.of(*link)).front()];
    if (!above) break;
    const TreeJoint& joint = tree.joints[*above];
    const bool slides = joint.motion == JointMotion::prismatic;
    if (slides ? !found : !is_idle[*joint.variable]) break;
    found = {joint.name, place_of(tree, joint)};
    link = joint.parent;
  }
  return found;
}

}  // namespace

std::vector<std::string> wrist_notes(const Tree& tree, const Bodies& bodies, const Mechanism& mechanism,
                                     const std::vector<std::string>& closures, const std::string& urdf_name) {
  if (!is_planar(mechanism.manipulator()->task_space())) return {};
  std::vector<bool> is_idle(static_cast<std::size_t>(tree.variables()), true);
  for (const PassiveJoint& joint : mechanism.determined_joints()) is_idle[joint.index] = false;
  for (const Leg& leg : mechanism.manipulator()->legs())
    if (const auto joint = tree.joint_named(leg.actuated_joint))
      is_idle[*tree.joints[*joint].variable] = false;
  std::vector<std::string> notes;
  for (const std::string& pair : closures) {
    const std::size_t middle = pair.find('=');
    const std::array<std::string, 2> ends{pair.substr(0, middle), pair.substr(middle + 1)};
    for (const std::size_t end : {0, 1}) {
      const auto before = before_wrist(tree, bodies, ends[end], is_idle);
      if (!before) continue;
      const std::string closed = end == 0 ? before->end + "=" + ends[1] : ends[0] + "=" + before->end;
      notes.push_back(
          "Joint '" + before->joint + "' of " + urdf_name +
          " is in a loop and turns there without moving anything else; where it is a wrist behind "
          "the platform, close the loop before it, by " +
          option_for("closures", {closed}) + (closures.size() > 1 ? " beside the others." : "."));
    }
  }
  return notes;
}

}  // namespace parallel_aspects
