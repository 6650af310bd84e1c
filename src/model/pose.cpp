// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/model/pose.h"

#include "model/task_space_traits.h"

#include <cmath>
#include <sstream>

namespace parallel_aspects {

std::size_t degrees_of_freedom(TaskSpace space) noexcept { return traits(space).degrees_of_freedom(); }

std::string_view name(TaskSpace space) noexcept { return traits(space).name; }

std::optional<TaskSpace> task_space_named(std::string_view text) noexcept {
  for (std::size_t i = 0; i < all_task_space_traits.size(); ++i)
    if (all_task_space_traits[i].name == text) return static_cast<TaskSpace>(i);
  return std::nullopt;
}

const std::vector<std::string>& coordinate_names(TaskSpace space) {
  static const std::array<std::vector<std::string>, all_task_space_traits.size()> names{
      {{"x"},
       {"x", "y"},
       {"x", "y", "phi"},
       {"x", "y", "z"},
       {"qx", "qy", "qz", "qw"},
       {"x", "y", "z", "qx", "qy", "qz", "qw"},
       {"theta"},
       {"theta1", "theta2"}}};
  return names[static_cast<std::size_t>(space)];
}

std::size_t rotational_degrees_of_freedom(TaskSpace space) noexcept { return traits(space).rotations; }

bool has_rotation(TaskSpace space) noexcept { return traits(space).rotations > 0; }

bool has_translation(TaskSpace space) noexcept { return traits(space).translations > 0; }

bool has_hinges(TaskSpace space) noexcept { return is_of_hinges(space); }

std::string_view measure_unit(TaskSpace space) noexcept { return traits(space).measure_unit; }

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

Eigen::Index moves(TaskSpace space) { return static_cast<Eigen::Index>(traits(space).translations); }
Eigen::Index turns(TaskSpace space) { return static_cast<Eigen::Index>(traits(space).rotations); }

// Rz(theta1) Rx(twist) Rz(theta2) has the quaternion (w, x, y, z) =
//   (cos h cos s, sin h cos e, sin h sin e, cos h sin s),  h = twist / 2, s and e = (theta1 +- theta2) / 2.
Eigen::Vector2d hinge_angles(const Eigen::Quaterniond& q) {
  const double sum = std::atan2(q.z(), q.w()), difference = std::atan2(q.y(), q.x());
  return {wrapped(sum + difference), wrapped(sum - difference)};
}

Pose at_hinge_angles(const HingePair& hinges, double first, double second) {
  const double c = std::cos(0.5 * hinges.twist), s = std::sin(0.5 * hinges.twist);
  const double sum = 0.5 * (first + second), difference = 0.5 * (first - second);
  Pose pose;
  pose.position << hinges.offset * std::cos(first), hinges.offset * std::sin(first), 0.0;
  pose.orientation = {c * std::cos(sum), s * std::cos(difference), s * std::sin(difference),
                      c * std::sin(sum)};
  pose.orientation.normalize();
  return pose;
}

std::optional<Eigen::Quaterniond> unit_quaternion(const Eigen::Vector4d& xyzw) {
  const double norm = xyzw.norm();
  if (!std::isfinite(norm) || norm == 0.0) return std::nullopt;
  return Eigen::Quaterniond(Eigen::Vector4d(xyzw / norm));
}

}  // namespace

Pose Pose::planar(double x, double y, double phi) {
  return {{x, y, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(phi, Eigen::Vector3d::UnitZ()))};
}

PoseCoordinates pose_coordinates(TaskSpace space, const Pose& pose) {
  PoseCoordinates coordinates(static_cast<Eigen::Index>(coordinate_names(space).size()));
  coordinates.head(moves(space)) = pose.position.head(moves(space));
  if (turns(space) == 1) coordinates[moves(space)] = wrapped(yaw(pose.orientation));
  if (turns(space) == 2) coordinates.tail<2>() = hinge_angles(pose.orientation);
  if (turns(space) == 3) coordinates.tail<4>() = pose.orientation.coeffs();
  return coordinates;
}

std::optional<Pose> pose_from_coordinates(const Motions& motions, const PoseCoordinates& coordinates) {
  const TaskSpace space = motions.space;
  const auto expected = static_cast<Eigen::Index>(coordinate_names(space).size());
  if (coordinates.size() != expected || !coordinates.allFinite()) return std::nullopt;
  if (turns(space) == 2) {
    if (!std::isfinite(motions.hinges.twist) || !std::isfinite(motions.hinges.offset)) return std::nullopt;
    return at_hinge_angles(motions.hinges, coordinates[0], coordinates[1]);
  }
  Pose pose;
  pose.position.head(moves(space)) = coordinates.head(moves(space));
  if (turns(space) == 1)
    pose.orientation = Eigen::AngleAxisd(coordinates[moves(space)], Eigen::Vector3d::UnitZ());
  if (turns(space) == 3) {
    const auto orientation = unit_quaternion(coordinates.tail<4>());
    if (!orientation) return std::nullopt;
    pose.orientation = *orientation;
  }
  return pose;
}

Pose displaced(const Motions& motions, const Pose& pose, const TaskVector& twist) {
  const TaskSpace space = motions.space;
  if (turns(space) == 2) {
    const Eigen::Vector2d angles = hinge_angles(pose.orientation) + twist.head<2>();
    return at_hinge_angles(motions.hinges, angles[0], angles[1]);
  }
  Pose moved = pose;
  if (turns(space) == 1) moved.orientation = rotation(twist[0] * Eigen::Vector3d::UnitZ()) * pose.orientation;
  if (turns(space) == 3) moved.orientation = rotation(twist.head<3>()) * pose.orientation;
  moved.position.head(moves(space)) += twist.segment(turns(space), moves(space));
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

Pose pose_between(const Motions& motions, const Pose& from, const Pose& to, double t) noexcept {
  if (motions.space != TaskSpace::R2) return pose_between(from, to, t);
  const Eigen::Vector2d first = hinge_angles(from.orientation);
  const Eigen::Vector2d way = (hinge_angles(to.orientation) - first).unaryExpr(&wrapped);
  return at_hinge_angles(motions.hinges, first[0] + t * way[0], first[1] + t * way[1]);
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
