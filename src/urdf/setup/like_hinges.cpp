// SPDX-License-Identifier: BSD-3-Clause
#include "model/linear_algebra.h"
#include "urdf/closing/assembly.h"
#include "urdf/closing/planar_layers.h"
#include "urdf/setup/open_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace parallel_aspects {
namespace {

using Eigen::Vector3d;

// Of the movable joints between the root and a link.
std::vector<JointMotion> motions_to(const Tree& tree, std::size_t link) {
  std::vector<JointMotion> motions;
  for (const std::size_t joint : movable_joints_to(tree, link)) motions.push_back(tree.joints[joint].motion);
  return motions;
}

constexpr double along_coordinate = 1e-4;  // what rounding of a file leaves of coordinates that are zero

// Without what rounded angles leave.
Vector3d tidied(const Vector3d& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  const Vector3d along = std::copysign(1.0, direction[largest]) * Vector3d::Unit(largest);
  return (direction - along).norm() < along_coordinate ? along : direction;
}

class LikeHinges {
 public:
  LikeHinges(const Tree& tree, const Bodies& bodies, const TreeJoint& hinge)
      : tree_(tree),
        bodies_(bodies),
        hinge_(hinge),
        poses_(link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()))),
        motions_(motions_to(tree, hinge.parent)) {
    const Eigen::Isometry3d in_body = in_own_body(hinge.parent) * hinge.origin;
    place_ = in_body.translation();
    axis_ = in_body.linear() * hinge.axis;
    tolerance_ = closing_tolerance * mechanism_size(tree, 0, poses_);
  }

  // Whether the chain ends as that of the hinge does, but for the hinge.
  bool ends_alike(std::size_t tip) const {
    return motions_to(tree_, tip) == motions_ &&
           (in_own_body(tip).translation() - place_).norm() < tolerance_;
  }

  std::array<Vector3d, 2> axes(const EndPair& pair) const {
    const Vector3d in_tip = in_own_body(pair.other).linear().transpose() * axis_;
    return {tidied(poses_[pair.one].linear().transpose() * poses_[pair.other].linear() * in_tip),
            tidied(in_tip)};
  }

 private:
  Eigen::Isometry3d in_own_body(std::size_t link) const {
    return poses_[bodies_.links(bodies_.of(link)).front()].inverse() * poses_[link];
  }

  const Tree& tree_;
  const Bodies& bodies_;
  const TreeJoint& hinge_;
  Poses poses_;                       // while all joints are zero
  std::vector<JointMotion> motions_;  // of the leg that carries the platform
  Vector3d place_, axis_;             // of the hinge, in the last body of that leg
  double tolerance_ = 0.0;            // [m]
};

// That carries the one body on which all anchors are.
const TreeJoint* hinge_of_platform(const Tree& tree, const Bodies& bodies, const Pairing& pairing) {
  const std::size_t platform = bodies.of(pairing.pairs.front().one);
  const bool is_one = std::all_of(pairing.pairs.begin(), pairing.pairs.end(),
                                  [&](const EndPair& pair) { return bodies.of(pair.one) == platform; });
  const auto joint = tree.joint_above[bodies.links(platform).front()];
  return is_one && joint && tree.joints[*joint].motion == JointMotion::revolute ? &tree.joints[*joint]
                                                                                : nullptr;
}

}  // namespace

std::optional<Pairing> like_hinges(const Tree& tree, const Bodies& bodies, const Pairing& pairing) {
  const TreeJoint* hinge = hinge_of_platform(tree, bodies, pairing);
  const Poses poses = link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()));
  // In the plane balls do as well, which need no axes.
  if (hinge == nullptr || common_normal(tree, poses, tree.movable)) return std::nullopt;
  const LikeHinges like(tree, bodies, *hinge);
  Pairing hinged{pairing.pairs,
                 "the legs are alike, and this is the hinge by which one of them carries the platform"};
  bool any_turned = false;
  for (EndPair& pair : hinged.pairs) {
    if (!like.ends_alike(pair.other)) return std::nullopt;
    const auto axes = like.axes(pair);
    for (const std::size_t end : {0, 1}) {
      any_turned = any_turned || axes[end].cross(Vector3d::UnitZ()).norm() > rank_tolerance;
      pair.in_link[end].linear() = shortest_rotation(Vector3d::UnitZ(), axes[end]).toRotationMatrix();
    }
  }
  return any_turned ? std::optional<Pairing>(hinged) : std::nullopt;
}

}  // namespace parallel_aspects
