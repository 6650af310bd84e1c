// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/setup/wrist_notes.h"

#include "parallel_aspects/model/constraints.h"
#include "urdf/description/command_options.h"

#include <array>
#include <optional>

namespace parallel_aspects {
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
