// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/pose.h"

#include <cmath>
#include <sstream>

namespace parallel_aspects {
namespace {

double yaw(const Eigen::Quaterniond& orientation) {
  return 2.0 * std::atan2(orientation.z(), orientation.w());
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * EIGEN_PI); }

Eigen::Quaterniond rotation(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0.0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation_vector / angle));
}

std::optional<Eigen::Quaterniond> unit_quaternion(const Eigen::Vector4d& xyzw) {
  const double norm = xyzw.norm();
  if (!std::isfinite(norm) || norm == 0.0) return std::nullopt;
  return Eigen::Quaterniond(Eigen::Vector4d(xyzw / norm));
}

}  // namespace

PoseCoordinates pose_coordinates(TaskSpace space, const Pose& pose) {
  PoseCoordinates coordinates(static_cast<Eigen::Index>(coordinate_names(space).size()));
  switch (space) {
    case TaskSpace::T1:
      coordinates << pose.position.x();
      break;
    case TaskSpace::T2:
      coordinates << pose.position.head<2>();
      break;
    case TaskSpace::SE2:
      coordinates << pose.position.head<2>(), wrapped(yaw(pose.orientation));
      break;
    case TaskSpace::T3:
      coordinates << pose.position;
      break;
    case TaskSpace::SO3:
      coordinates << pose.orientation.coeffs();
      break;
    case TaskSpace::SE3:
      coordinates << pose.position, pose.orientation.coeffs();
      break;
  }
  return coordinates;
}

std::optional<Pose> pose_from_coordinates(TaskSpace space, const PoseCoordinates& coordinates) {
  const auto expected = static_cast<Eigen::Index>(coordinate_names(space).size());
  if (coordinates.size() != expected || !coordinates.allFinite()) return std::nullopt;
  Pose pose;
  if (space == TaskSpace::T1) pose.position.x() = coordinates[0];
  if (space == TaskSpace::T2 || space == TaskSpace::SE2) pose.position.head<2>() = coordinates.head<2>();
  if (space == TaskSpace::T3 || space == TaskSpace::SE3) pose.position = coordinates.head<3>();
  if (space == TaskSpace::SE2) pose.orientation = Eigen::AngleAxisd(coordinates[2], Eigen::Vector3d::UnitZ());
  if (space == TaskSpace::SO3 || space == TaskSpace::SE3) {
    const auto orientation = unit_quaternion(coordinates.tail<4>());
    if (!orientation) return std::nullopt;
    pose.orientation = *orientation;
  }
  return pose;
}

Pose displaced(TaskSpace space, const Pose& pose, const TaskVector& twist) {
  Pose moved = pose;
  switch (space) {
    case TaskSpace::T1:
      moved.position.x() += twist[0];
      break;
    case TaskSpace::T2:
      moved.position.head<2>() += twist.head<2>();
      break;
    case TaskSpace::SE2:
      moved.orientation = rotation(twist[0] * Eigen::Vector3d::UnitZ()) * pose.orientation;
      moved.position.head<2>() += twist.tail<2>();
      break;
    case TaskSpace::T3:
      moved.position += twist.head<3>();
      break;
    case TaskSpace::SO3:
      moved.orientation = rotation(twist.head<3>()) * pose.orientation;
      break;
    case TaskSpace::SE3:
      moved.orientation = rotation(twist.head<3>()) * pose.orientation;
      moved.position += twist.tail<3>();
      break;
  }
  moved.orientation.normalize();
  return moved;
}

Eigen::Vector4d nearer_quaternion(const Pose& from, const Pose& to) noexcept {
  const Eigen::Vector4d &first = from.orientation.coeffs(), &last = to.orientation.coeffs();
  return first.dot(last) < 0.0 ? Eigen::Vector4d(-last) : last;
}

Pose pose_between(const Pose& from, const Pose& to, double t) noexcept {
  const Eigen::Vector4d quaternion = (1.0 - t) * from.orientation.coeffs() + t * nearer_quaternion(from, to);
  Pose pose;
  pose.position = (1.0 - t) * from.position + t * to.position;
  pose.orientation = Eigen::Quaterniond(Eigen::Vector4d(quaternion.normalized()));
  return pose;
}

std::string to_string(TaskSpace space, const Pose& pose) {
  const PoseCoordinates coordinates = pose_coordinates(space, pose);
  const auto& names = coordinate_names(space);
  std::ostringstream text;
  for (Eigen::Index i = 0; i < coordinates.size(); ++i)
    text << (i == 0 ? "" : ", ") << names[static_cast<std::size_t>(i)] << ' ' << coordinates[i];
  return text.str();
}

}  // namespace parallel_aspects
