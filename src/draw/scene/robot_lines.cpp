// SPDX-License-Identifier: BSD-3-Clause
#include "draw/scene/robot_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parallel_aspects {

Eigen::Matrix3d drawing_axes(const Manipulator& robot) noexcept {
  return has_hinges(robot.task_space()) ? Eigen::Matrix3d(robot.task_frame().linear())
                                        : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

Eigen::Isometry3d drawing_frame(const Manipulator& robot) noexcept {
  Eigen::Isometry3d frame = robot.task_frame();
  frame.linear() = frame.linear() * drawing_axes(robot).transpose();
  return frame;
}

double turn_length(const Manipulator& manipulator) noexcept { return manipulator.size(); }

double drawn_size(const Manipulator& robot, double radius) noexcept {
  return robot.task_space() == TaskSpace::SO3 ? 2.0 * radius : robot.size();
}

double sphere_radius(const Manipulator& robot) noexcept {
  double farthest = 0.0;
  for (const Leg& leg : robot.legs())
    farthest = std::max(farthest, std::abs(robot.motions().hinges.offset) + leg.anchor.norm());
  return 1.4 * farthest;
}

namespace {

using Eigen::Vector3d;

class Skeleton {
 public:
  explicit Skeleton(const Eigen::Matrix3d& scale) : scale_(scale) {}

  void add(const Vector3d& from, const Vector3d& to) {
    if (from.isApprox(to) || !(from + to).allFinite()) return;
    ends_.push_back(scale_ * from);
    ends_.push_back(scale_ * to);
  }
  std::vector<Vector3d> take() { return std::move(ends_); }

 private:
  Eigen::Matrix3d scale_;
  std::vector<Vector3d> ends_;
};

// What carries the rod: a crank, or as much of a rail as the slider may take; a strut stands on the base.
void add_leg(const Leg& leg, const Vector3d& anchor, double q, Skeleton& skeleton) {
  const Vector3d proximal = leg.proximal_point(q);
  if (leg.kind().has_crank)
    skeleton.add(leg.base_point(), proximal);
  else
    skeleton.add(leg.proximal_point(leg.limits.lower), leg.proximal_point(leg.limits.upper));
  skeleton.add(proximal, anchor);
}

}  // namespace

std::vector<Vector3d> skeleton_of(const Manipulator& robot, const Pose& pose, const JointVector& q,
                                  double radius) {
  Skeleton skeleton((robot.task_space() == TaskSpace::SO3 ? radius : 1.0) * drawing_axes(robot));
  const Vector3d point = pose.transform(Vector3d::Zero());
  Vector3d before = pose.transform(robot.leg(robot.leg_count() - 1).anchor);
  for (std::size_t j = 0; j < robot.leg_count(); ++j) {
    const Vector3d anchor = pose.transform(robot.leg(j).anchor);
    add_leg(robot.leg(j), anchor, q[static_cast<Eigen::Index>(j)], skeleton);
    skeleton.add(before, anchor);  // the rim of the platform
    skeleton.add(anchor, point);
    before = anchor;
  }
  return skeleton.take();
}

}  // namespace parallel_aspects
