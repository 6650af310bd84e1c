// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/follower.h"

#include "model/linear_algebra.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace parallel_aspects {

Eigen::Vector3d directed_axis(const Pivot& pivot) { return pivot.sense * pivot.axis; }

Eigen::Isometry3d about(const Eigen::Vector3d& center, const Eigen::Matrix3d& turned) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = turned;
  motion.translation() = center - turned * center;
  return motion;
}

Eigen::Isometry3d motion_of(const Pivot& pivot, double step) {
  if (pivot.kind == PivotKind::revolute)
    return about(pivot.point, Eigen::AngleAxisd(step, directed_axis(pivot)).toRotationMatrix());
  return Eigen::Isometry3d(Eigen::Translation3d(step * directed_axis(pivot)));
}

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

using Twist = Eigen::Matrix<double, 6, 1>;  // (w, v) in the base frame

constexpr int parts_of_way = 16, most_corrections = 8;
constexpr double pursued = 1e-12, singular_share = 1e-6;

// A ball is three joints that no value is kept of.
Chain single_joints(const Chain& chain) {
  Chain joints;
  for (Pivot pivot : chain) {
    if (pivot.kind != PivotKind::ball) {
      joints.push_back(pivot);
      continue;
    }
    pivot.kind = PivotKind::revolute;
    for (const Eigen::Index k : {0, 1, 2}) {
      pivot.axis = Vector3d::Unit(k);
      joints.push_back(pivot);
    }
  }
  return joints;
}

Twist twist_of(const Pivot& joint, const Isometry3d& before) {
  const Vector3d axis = before.linear() * directed_axis(joint);
  Twist twist;
  if (joint.kind == PivotKind::prismatic)
    twist << Vector3d::Zero(), axis;
  else
    twist << axis, (before * joint.point).cross(axis);
  return twist;
}

// That takes one displacement to the other, as far as they are near.
Twist between(const Isometry3d& from, const Isometry3d& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  const Vector3d angle = turn.angle() * turn.axis();
  Twist twist;
  twist << angle, to.translation() - from.translation() - angle.cross(from.translation());
  return twist;
}

Isometry3d part_of(const Isometry3d& motion, double share) {
  const Eigen::AngleAxisd turn(motion.linear());
  Isometry3d part(Eigen::AngleAxisd(share * turn.angle(), turn.axis()));
  part.translation() = share * motion.translation();
  return part;
}

}  // namespace

std::vector<FollowerStep> steps_of_follower(const Chain& follower, const Eigen::Isometry3d& motion,
                                            double size) {
  const Chain joints = single_joints(follower);
  Eigen::VectorXd steps = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(joints.size()));
  for (int part = 1; part <= parts_of_way; ++part) {
    const Isometry3d target = part_of(motion, static_cast<double>(part) / parts_of_way);
    for (int correction = 0; correction < most_corrections; ++correction) {
      Eigen::MatrixXd twists(6, steps.size());
      Isometry3d reached = Isometry3d::Identity();
      for (std::size_t k = 0; k < joints.size(); ++k) {
        const auto index = static_cast<Eigen::Index>(k);
        twists.col(index) = twist_of(joints[k], reached);
        reached = reached * motion_of(joints[k], steps[index]);
      }
      const Twist left = between(reached, target);
      if (left.norm() < pursued * std::max(1.0, size)) break;
      steps += least_squares_solution(twists, left, singular_share);
    }
  }
  std::vector<FollowerStep> found;
  for (std::size_t k = 0; k < joints.size(); ++k)
    found.push_back({joints[k], steps[static_cast<Eigen::Index>(k)]});
  return found;
}

}  // namespace parallel_aspects
