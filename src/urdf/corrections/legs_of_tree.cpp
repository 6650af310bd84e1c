// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/legs_of_tree.h"

#include "urdf/closing/assembly.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace parallel_aspects {
namespace {

// Else the chain there is a passive one, no leg.
bool is_actuated_above(const Tree& tree, const ResolvedConfig& resolved, std::size_t link) {
  const auto& actuated = resolved.actuated_joints.variables;
  for (auto joint = tree.joint_above[link]; joint; joint = tree.joint_above[tree.joints[*joint].parent])
    if (const auto variable = tree.joints[*joint].variable;
        variable && std::find(actuated.begin(), actuated.end(), *variable) != actuated.end())
      return true;
  return false;
}

// Where joints and closures are on the body of the platform, in the frame of that body at zero.
std::vector<Eigen::Vector3d> anchors(const Tree& tree, const ResolvedConfig& resolved) {
  const std::size_t body = body_of(tree, resolved.actuated_joints.platform_link);
  const Poses poses = link_poses(tree, body, Eigen::VectorXd::Zero(tree.variables()));
  std::vector<Eigen::Vector3d> points;
  for (const Closure& closure : resolved.closures)
    for (const LinkFrame& frame : closure.frames)
      if (body_of(tree, frame.link) == body)
        points.push_back((poses[frame.link] * frame.in_link).translation());
  for (const TreeJoint& joint : tree.joints)
    if (joint.variable && ((joint.child == body && is_actuated_above(tree, resolved, body)) ||
                           body_of(tree, joint.parent) == body))
      points.push_back(poses[joint.child].translation());
  return points;
}

}  // namespace

bool legs_share_anchors(const Tree& tree, const ResolvedConfig& resolved, double size) {
  const std::vector<Eigen::Vector3d> points = anchors(tree, resolved);
  bool any_together = false, any_apart = false;
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t other = 0; other < k; ++other) {
      const bool together = (points[k] - points[other]).norm() < closing_tolerance * size;
      any_together = any_together || together;
      any_apart = any_apart || !together;
    }
  return any_together && any_apart;
}

namespace {

constexpr double usual_lengths =
    5.0;  // in the size of a robot, at most: base, crank, rod, platform and a tool

std::vector<bool> above(const Tree& tree, std::size_t link) {
  std::vector<bool> found(tree.joints.size(), false);
  for (auto joint = tree.joint_above[link]; joint; joint = tree.joint_above[tree.joints[*joint].parent])
    found[*joint] = true;
  return found;
}

std::vector<std::size_t> depths(const Tree& tree) {
  std::vector<std::size_t> result(tree.joints.size(), 0);
  for (std::size_t k = 0; k < tree.joints.size(); ++k)
    if (const auto parent = tree.joint_above[tree.joints[k].parent]) result[k] = result[*parent] + 1;
  return result;
}

}  // namespace

LoopJoints::LoopJoints(const Tree& tree, const std::vector<Closure>& closures, double size)
    : tree_(tree), size_(size), depth_(depths(tree)) {
  std::vector<bool> in_loop(tree.joints.size(), false);
  for (const Closure& closure : closures) {
    const std::vector<bool> one = above(tree, closure.frames[0].link);
    const std::vector<bool> other = above(tree, closure.frames[1].link);
    for (std::size_t k = 0; k < in_loop.size(); ++k) in_loop[k] = in_loop[k] || one[k] != other[k];
  }
  for (std::size_t k = 0; k < in_loop.size(); ++k)
    if (in_loop[k]) all_.push_back(k);
  // Whatever one that is in millimetres makes of it.
  if (const double usual = usual_length(); usual > 0.0) size_ = std::min(size_, usual_lengths * usual);
}

double LoopJoints::usual_length(std::optional<std::size_t> except) const {
  std::vector<double> lengths;
  for (const std::size_t joint : all_)
    if (const double length = tree_.joints[joint].origin.translation().norm();
        length > 0.0 && joint != except)
      lengths.push_back(length);
  if (lengths.empty()) return 0.0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

std::vector<std::size_t> LoopJoints::siblings(std::size_t joint) const {
  std::vector<std::size_t> result;
  for (const std::size_t other : all_)
    if (other != joint && depth_[other] == depth_[joint]) result.push_back(other);
  return result;
}

bool LoopJoints::same_motion(std::size_t one, std::size_t other) const {
  const TreeJoint &a = tree_.joints[one], &b = tree_.joints[other];
  return a.motion == b.motion &&
         (a.motion == JointMotion::fixed || a.axis.cross(b.axis).norm() < rank_tolerance);
}

bool LoopJoints::same_place(std::size_t one, std::size_t other) const {
  const Eigen::Vector3d between =
      tree_.joints[one].origin.translation() - tree_.joints[other].origin.translation();
  return between.norm() < closing_tolerance * size_;
}

bool LoopJoints::same_direction(std::size_t one, std::size_t other) const {
  const Eigen::Matrix3d between = tree_.joints[one].origin.linear() - tree_.joints[other].origin.linear();
  return between.norm() < rank_tolerance;
}

std::vector<UsualSibling> usual_siblings(const LoopJoints& loops, std::size_t joint,
                                         const std::function<bool(std::size_t, std::size_t)>& are_alike) {
  const std::vector<std::size_t> siblings = loops.siblings(joint);
  const auto like = [&](std::size_t one) {
    return std::count_if(siblings.begin(), siblings.end(),
                         [&](std::size_t other) { return are_alike(one, other); });
  };
  const auto own = like(joint) + 1;
  std::vector<UsualSibling> usual;
  for (const std::size_t sibling : siblings)
    if (const auto count = like(sibling); !are_alike(joint, sibling) && count >= own)
      usual.push_back({sibling, count > own && count > 1});
  return usual;
}

bool LoopJoints::is_like_others(std::size_t joint) const {
  const std::vector<std::size_t> others = siblings(joint);
  return std::count_if(others.begin(), others.end(), [&](std::size_t other) {
           return same_motion(joint, other) && same_place(joint, other) && same_direction(joint, other);
         }) >= 2;
}

}  // namespace parallel_aspects
