// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr double rounding = 1e-12;      // of sums of distances, as a share
constexpr double turn_rounding = 1e-5;  // [rad], as of 6.28318
constexpr double one_point = 1e-5;      // [m] that CAD leaves between frames which are in one point

Eigen::Isometry3d motion_of(const TreeJoint& joint, double value) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (joint.motion == JointMotion::revolute) motion.linear() = Eigen::AngleAxisd(value, joint.axis).matrix();
  if (joint.motion == JointMotion::prismatic) motion.translation() = value * joint.axis;
  return motion;
}

// Links by the first of those that fixed joints hold together, the root first.
std::vector<std::size_t> rigid_bodies(const Tree& tree) {
  std::vector<std::size_t> bodies(tree.links.size(), 0);
  for (const TreeJoint& joint : tree.joints)
    bodies[joint.child] = joint.variable ? joint.child : bodies[joint.parent];
  return bodies;
}

// The largest distance between two points. Those far from the first come first, so that most pairs are known
// to be nearer.
double spread(const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::pair<double, Eigen::Vector3d>> far;
  for (const auto& point : points) far.emplace_back((point - points.front()).norm(), point);
  std::sort(far.begin(), far.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  double widest = 0.0;
  for (std::size_t i = 0; i < far.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      if ((far[i].first + far[k].first) * (1.0 + rounding) < widest) break;
      widest = std::max(widest, (far[i].second - far[k].second).norm());
    }
  return widest;
}

}  // namespace

std::optional<std::size_t> Tree::link_named(const std::string& wanted) const {
  const auto found = std::find(links.begin(), links.end(), wanted);
  if (found == links.end()) return std::nullopt;
  return static_cast<std::size_t>(found - links.begin());
}

std::optional<std::size_t> Tree::joint_named(const std::string& wanted) const {
  const auto found = std::find_if(joints.begin(), joints.end(),
                                  [&](const TreeJoint& joint) { return joint.name == wanted; });
  if (found == joints.end()) return std::nullopt;
  return static_cast<std::size_t>(found - joints.begin());
}

Poses link_poses(const Tree& tree, std::size_t base, const Eigen::VectorXd& values) {
  std::vector<std::size_t> all(tree.joints.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return link_poses(tree, base, values, all);
}

Poses link_poses(const Tree& tree, std::size_t base, const Eigen::VectorXd& values,
                 const std::vector<std::size_t>& joints) {
  Poses poses(tree.links.size(), Eigen::Isometry3d::Identity());
  for (const std::size_t index : joints) {
    const TreeJoint& joint = tree.joints[index];
    poses[joint.child] = poses[joint.parent] * joint.origin;
    if (joint.variable)
      poses[joint.child] =
          poses[joint.child] * motion_of(joint, values[static_cast<Eigen::Index>(*joint.variable)]);
  }
  if (base == 0) return poses;
  const Eigen::Isometry3d to_base = poses[base].inverse();
  poses.front() = to_base * poses.front();
  for (const std::size_t index : joints) {
    Eigen::Isometry3d& pose = poses[tree.joints[index].child];
    pose = to_base * pose;
  }
  return poses;
}

double mechanism_size(const Tree& tree, std::size_t base, const Poses& poses,
                      std::vector<Eigen::Vector3d> points) {
  const std::vector<std::size_t> bodies = rigid_bodies(tree);
  for (std::size_t link = 0; link < poses.size(); ++link)
    if (bodies[link] != bodies[base]) points.push_back(poses[link].translation());
  const double size = spread(points);
  return size > one_point ? size : 1.0;
}

bool turns_freely(const TreeJoint& joint) noexcept {
  return joint.motion == JointMotion::revolute &&
         joint.limits.upper - joint.limits.lower > 2.0 * EIGEN_PI - turn_rounding;
}

std::size_t body_of(const Tree& tree, std::size_t link) {
  for (auto joint = tree.joint_above[link]; joint && !tree.joints[*joint].variable;
       joint = tree.joint_above[link])
    link = tree.joints[*joint].parent;
  return link;
}

bool has_child(const Tree& tree, std::size_t link) {
  return std::any_of(tree.joints.begin(), tree.joints.end(),
                     [link](const TreeJoint& joint) { return joint.parent == link; });
}

}  // namespace parallel_aspects
