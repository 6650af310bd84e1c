// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/arms/serial_arm.h"

#include "parallel_aspects/model/problems.h"

#include "arms/ideal_chain.h"
#include <algorithm>
#include <cmath>

namespace parallel_aspects {
namespace {

constexpr double least_turn = 2.0 * half_turn - 0.01;  // limits that leave as much are written for none
constexpr double rounding_of_limits = 1e-9;

// Angles are written with fewer digits than lengths, as 1.57 for a quarter turn.
constexpr double angle_tolerance_by_length = 10.0;

double size_of(const ArmDescription& description) {
  double size = 0.0;
  Eigen::Vector3d before = description.axes.front().point;
  for (const ArmAxis& axis : description.axes) {
    size += (axis.point - before).norm();
    before = axis.point;
  }
  return size + (description.tip.translation() - before).norm();
}

bool are_parallel(const ArmDescription& description) {
  const Eigen::Vector3d first = description.axes.front().direction;
  return std::all_of(description.axes.begin(), description.axes.end(), [&](const ArmAxis& axis) {
    return axis.direction.cross(first).norm() < angle_tolerance_by_length * description.tolerance;
  });
}

// Turning joints about one direction, and slides across it.
bool is_planar(const ArmDescription& description, const Eigen::Vector3d& normal) {
  return std::all_of(description.axes.begin(), description.axes.end(), [&](const ArmAxis& axis) {
    const double tolerance = angle_tolerance_by_length * description.tolerance;
    return axis.turns ? axis.direction.cross(normal).norm() < tolerance
                      : std::abs(axis.direction.dot(normal)) < tolerance;
  });
}

Eigen::Vector3d direction_of_turns(const ArmDescription& description) {
  for (const ArmAxis& axis : description.axes)
    if (axis.turns) return axis.direction;
  const Eigen::Vector3d across =
      description.axes.size() < 2 ? Eigen::Vector3d::Zero().eval()
                                  : description.axes[0].direction.cross(description.axes[1].direction).eval();
  return across.norm() > 1e-6 ? across.normalized() : Eigen::Vector3d::UnitZ().eval();
}

ArmTask usual_task(const ArmDescription& description) {
  const bool planar = is_planar(description, direction_of_turns(description));
  switch (description.axes.size()) {
    case 2:
      return planar ? ArmTask::plane_position : ArmTask::direction;
    case 3:
      return planar ? ArmTask::plane_pose : ArmTask::position;
    case 4:
      return ArmTask::position_and_turn;
    case 5:
      return ArmTask::position_and_direction;
    default:
      return ArmTask::pose;
  }
}

bool is_of_plane(ArmTask task) { return task == ArmTask::plane_position || task == ArmTask::plane_pose; }

LastAxis last_axis_of(ArmTask task) {
  if (task == ArmTask::pose || task == ArmTask::orientation) return LastAxis::of_last_joint;
  if (task == ArmTask::direction || task == ArmTask::position_and_direction) return LastAxis::of_tip;
  return LastAxis::parallel_to_it;
}

std::string count_problem(const ArmDescription& description, ArmTask task) {
  const std::size_t joints = description.axes.size(), coordinates = coordinate_count(task);
  const std::string counts = "'" + description.name + "' has " + std::to_string(joints) + " joints for the " +
                             std::to_string(coordinates) + " coordinates of " + name(task);
  if (joints > coordinates)
    return counts +
           ", so that it is redundant: J is not square, and det J and the aspects are not defined; "
           "hold " +
           std::to_string(joints - coordinates) + (joints - coordinates == 1 ? " joint" : " joints") +
           " still by leaving them out of mechanism.actuated_joints and making them fixed in the URDF, or "
           "state another task.";
  return counts + "; state a mechanism.task with as many coordinates as it has joints.";
}

Eigen::Isometry3d link_transform(const ArmJoint& joint, double q) {
  const double turn = joint.turn.value() + (joint.turns ? q : 0.0);
  const double offset = 1e-9 * static_cast<double>(joint.offset) + (joint.turns ? 0.0 : q);
  return Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
         Eigen::Translation3d(1e-9 * static_cast<double>(joint.length), 0.0, offset) *
         Eigen::AngleAxisd(joint.twist.value(), Eigen::Vector3d::UnitX());
}

}  // namespace

double RationalAngle::value() const noexcept {
  return 0.5 * half_turn * quarters + 2.0 * std::atan(1e-12 * static_cast<double>(half_tangent));
}

const char* name(ArmTask task) {
  switch (task) {
    case ArmTask::plane_position:
      return "plane_position";
    case ArmTask::plane_pose:
      return "plane_pose";
    case ArmTask::position:
      return "position";
    case ArmTask::direction:
      return "direction";
    case ArmTask::orientation:
      return "orientation";
    case ArmTask::position_and_turn:
      return "position_and_turn";
    case ArmTask::position_and_direction:
      return "position_and_direction";
    case ArmTask::pose:
      break;
  }
  return "pose";
}

std::size_t coordinate_count(ArmTask task) {
  switch (task) {
    case ArmTask::plane_position:
    case ArmTask::direction:
      return 2;
    case ArmTask::plane_pose:
    case ArmTask::position:
    case ArmTask::orientation:
      return 3;
    case ArmTask::position_and_turn:
      return 4;
    case ArmTask::position_and_direction:
      return 5;
    case ArmTask::pose:
      break;
  }
  return 6;
}

std::vector<std::string> coordinate_names(ArmTask task) {
  switch (task) {
    case ArmTask::plane_position:
      return {"x", "y"};
    case ArmTask::plane_pose:
      return {"x", "y", "phi"};
    case ArmTask::position:
      return {"x", "y", "z"};
    case ArmTask::direction:
      return {"ux", "uy", "uz"};
    case ArmTask::orientation:
      return {"roll", "pitch", "yaw"};
    case ArmTask::position_and_turn:
      return {"x", "y", "z", "phi"};
    case ArmTask::position_and_direction:
      return {"x", "y", "z", "ux", "uy", "uz"};
    case ArmTask::pose:
      break;
  }
  return {"x", "y", "z", "roll", "pitch", "yaw"};
}

SerialArm::SerialArm(const ArmDescription& description)
    : name_(description.name),
      base_link_(description.base_link),
      tip_link_(description.tip_link),
      notes_(description.notes) {
  if (description.axes.empty()) throw InvalidDescription({"'" + name_ + "' has no joints; list some."});
  choose_task(description);
  choose_plane(description);
  const double size = size_of(description);
  const IdealChain chain =
      ideal_chain(description, last_axis_of(task_), description.tolerance * (size > 0.0 ? size : 1.0),
                  angle_tolerance_by_length * description.tolerance);
  joints_ = chain.joints;
  tip_height_ = chain.tip_height;
  base_ = chain.base;
  notes_.insert(notes_.end(), chain.notes.begin(), chain.notes.end());
  for (const ArmJoint& joint : joints_)
    reach_ += 1e-9 * static_cast<double>(joint.length + std::abs(joint.offset));
  reach_ += 1e-9 * static_cast<double>(std::abs(tip_height_));
  const Eigen::Isometry3d last =
      frames(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(joints_.size()))).back();
  tool_ = last.inverse() * description.tip;
  tip_at_zero_ = description.tip;
}

void SerialArm::choose_task(const ArmDescription& description) {
  task_ = description.task.value_or(usual_task(description));
  if (description.axes.size() != coordinate_count(task_))
    throw InvalidDescription({count_problem(description, task_)});
  const bool planar = is_planar(description, direction_of_turns(description));
  if (is_of_plane(task_) && !planar)
    throw InvalidDescription({"'" + name_ + "' has joints that leave the plane, and its task is " +
                              parallel_aspects::name(task_) +
                              "; state mechanism.task: position, or direction for two joints."});
  if (task_ == ArmTask::position_and_turn && !are_parallel(description))
    throw InvalidDescription(
        {"'" + name_ +
         "' has four joints whose axes are not all parallel, so that they turn the operational "
         "point about no one direction; hold a joint still by making it fixed in the URDF, and state "
         "mechanism.task: position."});
}

void SerialArm::choose_plane(const ArmDescription& description) {
  Eigen::Vector3d normal = direction_of_turns(description);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  if (normal.cross(up).norm() < angle_tolerance_by_length * description.tolerance) normal = up;
  Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  if (std::abs(x.dot(normal)) > 0.9) x = Eigen::Vector3d::UnitY();
  x = (x - x.dot(normal) * normal).normalized();
  plane_.col(0) = x;
  plane_.col(1) = normal.cross(x);
  plane_.col(2) = normal;
}

bool SerialArm::turns_freely(std::size_t i) const noexcept {
  const JointLimits& limits = joints_[i].limits;
  return joints_[i].turns && !(limits.upper - limits.lower < least_turn);
}

std::vector<Eigen::Isometry3d> SerialArm::frames(const Eigen::VectorXd& q) const {
  std::vector<Eigen::Isometry3d> frames{base_};
  for (std::size_t i = 0; i < joints_.size(); ++i)
    frames.push_back(frames.back() * link_transform(joints_[i], q[static_cast<Eigen::Index>(i)]));
  return frames;
}

Eigen::Isometry3d SerialArm::tip(const Eigen::VectorXd& q) const { return frames(q).back() * tool_; }

Eigen::MatrixXd SerialArm::jacobian(const Eigen::VectorXd& q) const {
  const auto all = frames(q);
  const Eigen::Isometry3d tip = all.back() * tool_;
  Eigen::Matrix<double, 6, Eigen::Dynamic> full(6, q.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const Eigen::Isometry3d& frame = all[static_cast<std::size_t>(i)];
    const Eigen::Vector3d z = frame.linear().col(2);
    const bool turns = joints_[static_cast<std::size_t>(i)].turns;
    full.col(i) << (turns ? z.cross(tip.translation() - frame.translation()).eval() : z),
        (turns ? z : Eigen::Vector3d::Zero().eval());
  }
  const auto velocity = full.topRows<3>(), angular = full.bottomRows<3>();
  Eigen::MatrixXd result(static_cast<Eigen::Index>(coordinate_count(task_)), q.size());
  switch (task_) {
    case ArmTask::plane_position:
      return plane_.leftCols<2>().transpose() * velocity;
    case ArmTask::plane_pose:
      result << plane_.leftCols<2>().transpose() * velocity, plane_.col(2).transpose() * angular;
      return result;
    case ArmTask::position:
      return velocity;
    case ArmTask::orientation:
      return angular;
    case ArmTask::direction:
      return tip.linear().leftCols<2>().transpose() * angular;
    case ArmTask::position_and_turn:
      result << velocity, plane_.col(2).transpose() * angular;
      return result;
    case ArmTask::position_and_direction:
      result << velocity, tip.linear().leftCols<2>().transpose() * angular;
      return result;
    case ArmTask::pose:
      break;
  }
  return full;
}

Eigen::VectorXd SerialArm::task_coordinates(const Eigen::Isometry3d& tip) const {
  const Eigen::Vector3d p = tip.translation(), in_plane = plane_.transpose() * p, z = tip.linear().col(2);
  const Eigen::Matrix3d turned =
      plane_.transpose() * tip.linear() * tip_at_zero_.linear().transpose() * plane_;
  const double phi = std::atan2(turned(1, 0), turned(0, 0));
  const Eigen::Matrix3d& r = tip.linear();
  const Eigen::Vector3d angles(std::atan2(r(2, 1), r(2, 2)),
                               std::atan2(-r(2, 0), std::hypot(r(2, 1), r(2, 2))),
                               std::atan2(r(1, 0), r(0, 0)));
  Eigen::VectorXd result(static_cast<Eigen::Index>(coordinate_names(task_).size()));
  switch (task_) {
    case ArmTask::plane_position:
      return in_plane.head<2>();
    case ArmTask::plane_pose:
      result << in_plane.head<2>(), phi;
      return result;
    case ArmTask::position:
      return p;
    case ArmTask::orientation:
      return angles;
    case ArmTask::direction:
      return z;
    case ArmTask::position_and_turn:
      result << p, phi;
      return result;
    case ArmTask::position_and_direction:
      result << p, z;
      return result;
    case ArmTask::pose:
      break;
  }
  result << p, angles;
  return result;
}

bool SerialArm::within_limits(const Eigen::VectorXd& q) const noexcept {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const JointLimits& limits = joints_[i].limits;
    const double value = q[static_cast<Eigen::Index>(i)];
    if (turns_freely(i)) continue;
    if (!(limits.lower - rounding_of_limits <= value && value <= limits.upper + rounding_of_limits))
      return false;
  }
  return true;
}

}  // namespace parallel_aspects
