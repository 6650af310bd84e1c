// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plane/map_pictures.h"

#include "model/angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace parallel_aspects {
namespace {

using Eigen::Vector2d;

// The rotation about z that a rotation ends with when it begins with one about a horizontal axis.
double torsion(const Eigen::Quaterniond& rotation) {
  return std::remainder(2.0 * std::atan2(rotation.z(), rotation.w()), 2.0 * EIGEN_PI);
}

Eigen::Quaterniond about_z(double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
}

constexpr double rounding = 1e-9;  // of half a turn [rad]

Pose pose_in(const MapSlice& slice, const Vector2d& point) {
  Pose pose = slice.held;
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < slice.moves.size(); ++i)
    if (slice.moves[i]) pose.position[static_cast<Eigen::Index>(i)] = point[next++];
  if (slice.rotation == MapSlice::Rotation::about_axis)
    pose.orientation =
        Eigen::Quaterniond(Eigen::AngleAxisd(point[next], slice.axis.normalized())) * slice.held.orientation;
  return pose;
}

}  // namespace

PoseSlice::PoseSlice(const Manipulator& manipulator, const MapSlice& slice)
    : motions_(manipulator.motions()), slice_(slice) {
  if (slice.joint) circle_ = circle_of_anchor(manipulator, *slice.joint);
}

PoseSlice PoseSlice::through(const Motions& motions, const Pose& pose) noexcept {
  if (motions.space == TaskSpace::T3) return {motions, pose.position.z()};
  const bool turns = has_rotation(motions.space) && !has_hinges(motions.space);
  return {motions, turns ? torsion(pose.orientation) : 0.0};
}

Pose PoseSlice::pose(const Vector2d& point) const noexcept {
  if (circle_) return circle_->pose(point.x(), point.y());
  if (slice_) return pose_in(*slice_, point);
  if (motions_.space == TaskSpace::R2) return pose_from_coordinates(motions_, point).value_or(Pose{});
  Pose pose;
  if (motions_.space == TaskSpace::SO3) {
    const double tilt = point.norm();
    const Eigen::Vector3d axis =
        tilt > 0.0 ? Eigen::Vector3d(-point.y() / tilt, point.x() / tilt, 0.0) : Eigen::Vector3d::UnitY();
    pose.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(tilt, axis)) * about_z(level_);
    return pose;
  }
  pose.position << point, motions_.space == TaskSpace::T3 ? level_ : 0.0;
  if (motions_.space == TaskSpace::SE2) pose.orientation = about_z(level_);
  return pose;
}

Vector2d PoseSlice::point(TaskSpace space, const Pose& pose) noexcept {
  if (space == TaskSpace::R2) return pose_coordinates(space, pose);
  if (space != TaskSpace::SO3) return pose.position.head<2>();
  const Eigen::AngleAxisd tilt(pose.orientation * about_z(torsion(pose.orientation)).conjugate());
  const double angle = std::remainder(tilt.angle(), 2.0 * EIGEN_PI);
  return angle * Vector2d(tilt.axis().y(), -tilt.axis().x());
}

bool PoseSlice::turns(std::size_t coordinate) const noexcept {
  if (!slice_) return motions_.space == TaskSpace::R2;
  return slice_->joint || coordinate >= slice_->free_positions();
}

bool PoseSlice::holds(const Vector2d& point) const noexcept {
  for (const int i : {0, 1})
    if (turns(static_cast<std::size_t>(i)) && !(std::abs(point[i]) <= pi + rounding)) return false;
  return slice_ || motions_.space != TaskSpace::SO3 || point.norm() <= EIGEN_PI;
}

std::string PoseSlice::text() const {
  if (slice_) return to_string(*slice_);
  char text[48] = "";
  if (motions_.space == TaskSpace::SE2) std::snprintf(text, sizeof text, "phi = %.2f rad", level_);
  if (motions_.space == TaskSpace::T3) std::snprintf(text, sizeof text, "z = %.3g m", level_);
  if (motions_.space == TaskSpace::SO3) std::snprintf(text, sizeof text, "torsion = %.2f rad", level_);
  return text;
}

Eigen::AlignedBox2d slice_bounds(const AspectMap& map) {
  Eigen::AlignedBox2d bounds;
  if (map.manipulator()->task_space() == TaskSpace::SO3)
    return Eigen::AlignedBox2d(Vector2d::Constant(-EIGEN_PI), Vector2d::Constant(EIGEN_PI));
  for (const Aspect& aspect : map.aspects()) {
    bounds.extend(Vector2d(aspect.bounds.lower[0], aspect.bounds.lower[1]));
    bounds.extend(Vector2d(aspect.bounds.upper[0], aspect.bounds.upper[1]));
  }
  if (bounds.isEmpty()) bounds.extend(Vector2d::Zero());
  // Slivers reach a little farther than the boxes inside.
  const Vector2d margin = Vector2d::Constant(2.0 * map.resolution());
  bounds = {bounds.min() - margin, bounds.max() + margin};
  if (map.manipulator()->task_space() == TaskSpace::R2)
    bounds.clamp(Eigen::AlignedBox2d(Vector2d::Constant(-pi), Vector2d::Constant(pi)));
  return bounds;
}

Eigen::AlignedBox2d slice_bounds(const AspectMap& map, const MapSlice& slice) {
  const std::vector<std::string> names = coordinate_names(slice), all = map.coordinates();
  Eigen::AlignedBox2d bounds(Vector2d::Constant(-pi), Vector2d::Constant(pi));
  if (slice.joint) return bounds;
  for (std::size_t i = 0; i < slice.free_positions(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const auto of_map = static_cast<std::size_t>(std::find(all.begin(), all.end(), names[i]) - all.begin());
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;
    for (const Aspect& aspect : map.aspects()) {
      lower = std::min(lower, aspect.bounds.lower[of_map]);
      upper = std::max(upper, aspect.bounds.upper[of_map]);
    }
    const bool is_empty = map.aspects().empty();
    bounds.min()[axis] = (is_empty ? 0.0 : lower) - 2.0 * map.resolution();
    bounds.max()[axis] = (is_empty ? 0.0 : upper) + 2.0 * map.resolution();
  }
  return bounds;
}

double level_difference(TaskSpace space, double a, double b) noexcept {
  return std::abs(has_rotation(space) ? std::remainder(a - b, 2.0 * EIGEN_PI) : a - b);
}

}  // namespace parallel_aspects
