// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/description/closure.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {
namespace {

using Twists = Eigen::Matrix<double, 6, Eigen::Dynamic>;

constexpr std::array<std::pair<std::string_view, ClosureType>, 6> type_names{
    {{"point", ClosureType::point},
     {"revolute", ClosureType::revolute},
     {"universal", ClosureType::universal},
     {"fixed", ClosureType::fixed},
     {"auto", ClosureType::automatic},
     {"spherical", ClosureType::point}}};

Eigen::Index angular_rows(ClosureType type) {
  switch (type) {
    case ClosureType::revolute:
      return 2;
    case ClosureType::universal:
      return 1;
    case ClosureType::fixed:
      return 3;
    case ClosureType::point:
    case ClosureType::automatic:
      break;
  }
  return 0;
}

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

Eigen::Index rows_of(const std::vector<Closure>& closures) {
  Eigen::Index rows = 0;
  for (const Closure& closure : closures) rows += 3 + angular_rows(closure.type);
  return rows;
}

// Angle-like errors of a closure, and the direction along which each one feels the relative angular velocity.
struct Orientation {
  Eigen::VectorXd error;
  Eigen::Matrix<double, Eigen::Dynamic, 3> direction;
};

Orientation orientation(ClosureType type, const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const Eigen::Index rows = angular_rows(type);
  Orientation result{Eigen::VectorXd(rows), Eigen::Matrix<double, Eigen::Dynamic, 3>(rows, 3)};
  if (type == ClosureType::fixed) {
    result.error = rotation_vector(a * b.transpose());
    result.direction.setIdentity();
    return result;
  }
  const Eigen::Vector3d other = type == ClosureType::revolute ? b.col(2) : b.col(0);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const Eigen::Vector3d own = type == ClosureType::revolute ? a.col(row) : a.col(2);
    result.error[row] = own.dot(other);
    result.direction.row(row) = own.cross(other).transpose();
  }
  return result;
}

// Errors of axes are sines of angles.
double angle_apart(ClosureType type, const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const double error = orientation(type, a, b).error.norm();
  return type == ClosureType::fixed ? error : std::asin(std::min(error, 1.0));
}

Eigen::Isometry3d placed(const Poses& poses, const LinkFrame& frame) {
  return poses[frame.link] * frame.in_link;
}

std::vector<bool> above(const Tree& tree, std::size_t link) {
  std::vector<bool> result(static_cast<std::size_t>(tree.variables()), false);
  for (auto joint = tree.joint_above[link]; joint; joint = tree.joint_above[tree.joints[*joint].parent])
    if (tree.joints[*joint].variable) result[*tree.joints[*joint].variable] = true;
  return result;
}

// Joints above the base and the frames of the closures, those nearer to the root first. Others move nothing
// that the equations see, and a description may have thousands of them.
std::vector<std::size_t> joints_above(const Tree& tree, std::size_t base,
                                      const std::vector<Closure>& closures) {
  std::vector<bool> found(tree.joints.size(), false);
  const auto find = [&](std::size_t link) {
    for (auto joint = tree.joint_above[link]; joint && !found[*joint];
         joint = tree.joint_above[tree.joints[*joint].parent])
      found[*joint] = true;
  };
  find(base);
  for (const Closure& closure : closures)
    for (const LinkFrame& frame : closure.frames) find(frame.link);
  std::vector<std::size_t> result;
  for (std::size_t joint = 0; joint < found.size(); ++joint)
    if (found[joint]) result.push_back(joint);
  return result;
}

}  // namespace

std::string_view name(ClosureType type) noexcept {
  for (const auto& [text, value] : type_names)
    if (value == type) return text;
  return "unknown";
}

std::optional<ClosureType> closure_type_named(std::string_view text) noexcept {
  for (const auto& [known, value] : type_names)
    if (known == text) return value;
  return std::nullopt;
}

void place_at_zero(const Tree& tree, std::vector<Closure>& closures) {
  const auto is_given_at_zero = [](const Closure& closure) { return closure.at_zero.has_value(); };
  if (std::none_of(closures.begin(), closures.end(), is_given_at_zero)) return;
  const Poses poses = link_poses(tree, 0, Eigen::VectorXd::Zero(tree.variables()));
  for (Closure& closure : closures) {
    if (!closure.at_zero) continue;
    const Eigen::Isometry3d second = placed(poses, closure.frames[1]);
    closure.frames[0].in_link = poses[closure.frames[0].link].inverse() * second * *closure.at_zero;
  }
}

ClosureSystem::ClosureSystem(std::shared_ptr<const Tree> tree, std::size_t base,
                             std::vector<Closure> closures)
    : tree_(std::move(tree)),
      base_(base),
      closures_(std::move(closures)),
      joints_(joints_above(*tree_, base_, closures_)) {
  const auto count = static_cast<std::size_t>(tree_->variables());
  const Poses poses = link_poses(*tree_, base, Eigen::VectorXd::Zero(tree_->variables()));
  std::vector<Eigen::Vector3d> ends;
  for (const Closure& closure : closures_)
    for (const LinkFrame& frame : closure.frames) ends.push_back(placed(poses, frame).translation());
  size_ = mechanism_size(*tree_, base, poses, std::move(ends));
  in_loop_.assign(count, false);
  for (const Closure& closure : closures_) {
    const std::vector<bool> one = above(*tree_, closure.frames[0].link);
    const std::vector<bool> other = above(*tree_, closure.frames[1].link);
    for (std::size_t k = 0; k < count; ++k) in_loop_[k] = in_loop_[k] || one[k] != other[k];
  }
}

Eigen::VectorXd ClosureSystem::residual(const Eigen::VectorXd& values) const {
  const Poses poses = link_poses(*tree_, base_, values, joints_);
  Eigen::VectorXd result(rows_of(closures_));
  Eigen::Index row = 0;
  for (const Closure& closure : closures_) {
    const Eigen::Isometry3d a = placed(poses, closure.frames[0]);
    const Eigen::Isometry3d b = placed(poses, closure.frames[1]);
    result.segment<3>(row) = a.translation() - b.translation();
    const Orientation turned = orientation(closure.type, a.linear(), b.linear());
    result.segment(row + 3, turned.error.size()) = size_ * turned.error;
    row += 3 + turned.error.size();
  }
  return result;
}

Eigen::MatrixXd ClosureSystem::jacobian(const Eigen::VectorXd& values) const {
  const Poses poses = link_poses(*tree_, base_, values, joints_);
  Eigen::MatrixXd result(rows_of(closures_), tree_->variables());
  Eigen::Index row = 0;
  for (const Closure& closure : closures_) {
    const Eigen::Isometry3d a = placed(poses, closure.frames[0]);
    const Eigen::Isometry3d b = placed(poses, closure.frames[1]);
    const Twists apart = velocity_matrix(*tree_, base_, poses, closure.frames[0].link, a.translation()) -
                         velocity_matrix(*tree_, base_, poses, closure.frames[1].link, b.translation());
    const Orientation turned = orientation(closure.type, a.linear(), b.linear());
    result.middleRows(row, 3) = apart.bottomRows<3>();
    result.middleRows(row + 3, turned.error.size()) =
        size_ * turned.direction.lazyProduct(apart.topRows<3>());
    row += 3 + turned.error.size();
  }
  return result;
}

LoopGap LoopGap::with(const LoopGap& other) const noexcept {
  return {std::max(distance, other.distance), std::max(angle, other.angle)};
}

LoopGap ClosureSystem::widest_gaps(const Eigen::VectorXd& values) const {
  const Poses poses = link_poses(*tree_, base_, values, joints_);
  LoopGap widest;
  for (const Closure& closure : closures_) {
    const Eigen::Isometry3d a = placed(poses, closure.frames[0]), b = placed(poses, closure.frames[1]);
    widest = widest.with(
        {(a.translation() - b.translation()).norm(), angle_apart(closure.type, a.linear(), b.linear())});
  }
  return widest;
}

std::pair<double, std::size_t> ClosureSystem::widest_gap(const Eigen::VectorXd& values) const {
  const Poses poses = link_poses(*tree_, base_, values, joints_);
  std::pair<double, std::size_t> widest{0.0, 0};
  for (std::size_t k = 0; k < closures_.size(); ++k) {
    const double gap = (placed(poses, closures_[k].frames[0]).translation() -
                        placed(poses, closures_[k].frames[1]).translation())
                           .norm();
    if (gap > widest.first) widest = {gap, k};
  }
  return widest;
}

Twists velocity_matrix(const Tree& tree, std::size_t base, const Poses& poses, std::size_t link,
                       const Eigen::Vector3d& point) {
  Twists result = Twists::Zero(6, tree.variables());
  const auto add = [&](std::size_t from, double sense) {
    for (auto above = tree.joint_above[from]; above; above = tree.joint_above[tree.joints[*above].parent]) {
      const TreeJoint& joint = tree.joints[*above];
      if (!joint.variable) continue;
      const Eigen::Isometry3d& pose = poses[joint.child];
      const Eigen::Vector3d axis = pose.linear() * joint.axis;
      auto column = result.col(static_cast<Eigen::Index>(*joint.variable));
      if (joint.motion == JointMotion::prismatic) {
        column.tail<3>() += sense * axis;
      } else {
        column.head<3>() += sense * axis;
        column.tail<3>() += sense * axis.cross(point - pose.translation());
      }
    }
  };
  add(link, 1.0);
  add(base, -1.0);
  return result;
}

std::vector<Closure> with_type(std::vector<Closure> closures, ClosureType type) {
  for (Closure& closure : closures)
    if (closure.type == ClosureType::automatic) closure.type = type;
  return closures;
}

}  // namespace parallel_aspects
