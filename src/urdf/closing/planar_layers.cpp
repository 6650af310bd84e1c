// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/closing/planar_layers.h"

#include "model/message_text.h"
#include "urdf/closing/assembly.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

std::vector<bool> joints_above(const Tree& tree, std::size_t link) {
  std::vector<bool> above(tree.joints.size(), false);
  for (auto joint = tree.joint_above[link]; joint; joint = tree.joint_above[tree.joints[*joint].parent])
    above[*joint] = true;
  return above;
}

class Layers {
 public:
  Layers(const Tree& tree, const Closure& closure)
      : tree_(tree), closure_(closure), poses_(link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()))) {
    const auto one = joints_above(tree, closure.frames[0].link),
               other = joints_above(tree, closure.frames[1].link);
    for (std::size_t k = 0; k < tree.joints.size(); ++k)
      if (one[k] != other[k] && tree.joints[k].variable) joints_.push_back(k);
  }

  /// From the first frame to the second across the planes, in the frame of the root at zero [m]; zero where
  /// the joints have no planes.
  Vector3d offset() const {
    const auto normal = common_normal(tree_, poses_, joints_);
    if (!normal || !turns_about(*normal)) return Vector3d::Zero();
    return *normal * normal->dot(origin(1) - origin(0));
  }

  LinkFrame moved(std::size_t end, const Vector3d& by) const {
    LinkFrame frame = closure_.frames[end];
    frame.in_link.translation() += poses_[frame.link].linear().transpose() * by;
    return frame;
  }

  double size() const { return mechanism_size(tree_, 0, poses_); }

 private:
  Vector3d origin(std::size_t end) const {
    return (poses_[closure_.frames[end].link] * closure_.frames[end].in_link).translation();
  }

  // A closure that would turn about another axis is wrong in more than its layer.
  bool turns_about(const Vector3d& normal) const {
    if (closure_.type != ClosureType::revolute) return true;
    return std::all_of(closure_.frames.begin(), closure_.frames.end(), [&](const LinkFrame& frame) {
      const Vector3d z = poses_[frame.link].linear() * frame.in_link.linear().col(2);
      return normal.cross(z).norm() < rank_tolerance;
    });
  }

  const Tree& tree_;
  const Closure& closure_;
  Poses poses_;
  std::vector<std::size_t> joints_;
};

bool may_be_layered(const Closure& closure) {
  return closure.weld == Weld::none && closure.type != ClosureType::fixed &&
         closure.type != ClosureType::universal;
}

}  // namespace

// Rotations about it and slides across it keep both as they are.
std::optional<Vector3d> common_normal(const Tree& tree, const Poses& poses,
                                      const std::vector<std::size_t>& joints) {
  const auto axis = [&](std::size_t joint) -> Vector3d {
    return poses[tree.joints[joint].child].linear() * tree.joints[joint].axis;
  };
  std::optional<Vector3d> normal;
  for (const std::size_t joint : joints) {
    if (tree.joints[joint].motion != JointMotion::revolute) continue;
    if (!normal) normal = axis(joint);
    if (normal->cross(axis(joint)).norm() > rank_tolerance) return std::nullopt;
  }
  for (const std::size_t joint : joints)
    if (normal && tree.joints[joint].motion == JointMotion::prismatic &&
        std::abs(normal->dot(axis(joint))) > rank_tolerance)
      return std::nullopt;
  return normal;
}

std::vector<std::string> join_layers(const Tree& tree, std::size_t platform, const SourceNames& files,
                                     std::vector<Closure>& closures) {
  std::vector<std::string> notes;
  for (Closure& closure : closures) {
    if (!may_be_layered(closure)) continue;
    const Layers layers(tree, closure);
    const Vector3d offset = layers.offset();
    if (!(offset.norm() > closing_tolerance * layers.size())) continue;
    const bool second_stays = closure.frames[1].link == platform;
    const LinkFrame moved = second_stays ? layers.moved(0, offset) : layers.moved(1, -offset);
    closure.frames[second_stays ? 0 : 1] = moved;
    notes.push_back(
        files.urdf + " has the frames of closure '" + closure.name + "' " + number_text(offset.norm(), 3) +
        " m apart along the axes of its loop, which all are parallel; they are taken as layers of "
        "one planar mechanism.");
  }
  return notes;
}

}  // namespace parallel_aspects
