// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/correction.h"

#include "urdf/description/messages.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

constexpr double rounding = 1e-9;  // of the longest coordinate, which adding up rounded frames leaves

std::string listed(const Eigen::Vector3d& vector, const std::string& between) {
  const double least = rounding * vector.lpNorm<Eigen::Infinity>();
  std::string text;
  for (Eigen::Index k = 0; k < 3; ++k)
    text += (k == 0 ? "" : between) + coordinate_text(std::abs(vector[k]) < least ? 0.0 : vector[k]);
  return text;
}

}  // namespace

std::string as_attribute(const Eigen::Vector3d& vector) { return listed(vector, " "); }

std::string in_brackets(const Eigen::Vector3d& vector) { return "(" + listed(vector, ", ") + ")"; }

std::string as_list(const Eigen::Vector3d& vector) { return "[" + listed(vector, ", ") + "]"; }

Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation) {
  const double level = std::hypot(rotation(0, 0), rotation(1, 0));
  return {std::atan2(rotation(2, 1), rotation(2, 2)), std::atan2(-rotation(2, 0), level),
          std::atan2(rotation(1, 0), rotation(0, 0))};
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& roll_pitch_yaw) {
  return (Eigen::AngleAxisd(roll_pitch_yaw.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(roll_pitch_yaw.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll_pitch_yaw.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

namespace {

// Those nearer to the root first again.
void sort_joints(Tree& tree) {
  std::vector<bool> placed(tree.links.size(), false);
  placed.front() = true;
  std::vector<TreeJoint> joints;
  while (joints.size() < tree.joints.size())
    for (const TreeJoint& next : tree.joints) {
      if (!placed[next.parent] || placed[next.child]) continue;
      placed[next.child] = true;
      tree.joint_above[next.child] = joints.size();
      if (next.variable) tree.movable[*next.variable] = joints.size();
      joints.push_back(next);
    }
  tree.joints = std::move(joints);
}

// Between these links, the second of which it carries.
void add(Tree& tree, const NewJoint& added, std::size_t parent, std::size_t child) {
  TreeJoint joint;
  joint.name = added.name;
  joint.motion = added.motion;
  joint.axis = added.axis;
  joint.parent = parent;
  joint.child = child;
  joint.variable = tree.movable.size();
  tree.movable.push_back(tree.joints.size());
  tree.joints.push_back(joint);
}

std::size_t add_link(Tree& tree, const std::string& name) {
  tree.links.push_back(name);
  tree.joint_above.emplace_back();
  return tree.links.size() - 1;
}

}  // namespace

void hang(Tree& tree, std::size_t joint, std::size_t parent) {
  tree.joints[joint].parent = parent;
  sort_joints(tree);
}

void insert_before(Tree& tree, const std::string& joint, const NewJoint& added) {
  const std::size_t link = add_link(tree, added.name);
  TreeJoint& next = tree.joints[*tree.joint_named(joint)];
  const std::size_t parent = std::exchange(next.parent, link);
  add(tree, added, parent, link);
  sort_joints(tree);
}

void insert_after(Tree& tree, const std::string& joint, const NewJoint& added) {
  const std::size_t link = add_link(tree, added.name);
  TreeJoint& previous = tree.joints[*tree.joint_named(joint)];
  const std::size_t child = std::exchange(previous.child, link);
  add(tree, added, link, child);
  sort_joints(tree);
}

}  // namespace parallel_aspects
