// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/recognition/rotation_subproblems.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

Eigen::Matrix3d rotation(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

double angle_about(const Eigen::Vector3d& axis, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d flat_from = from - axis * axis.dot(from);
  const Eigen::Vector3d flat_to = to - axis * axis.dot(to);
  return std::atan2(axis.dot(flat_from.cross(flat_to)), flat_from.dot(flat_to));
}

std::optional<std::array<double, 2>> angles_about(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                                                  const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                  int branch) {
  const Eigen::Vector3d normal = first.cross(second);
  const double squared_sine = normal.squaredNorm();
  if (squared_sine < 1e-8) return std::nullopt;
  const double cosine = first.dot(second);
  const double along_first = (first.dot(to) - cosine * second.dot(from)) / squared_sine;
  const double along_second = (second.dot(from) - cosine * first.dot(to)) / squared_sine;
  const Eigen::Vector3d in_plane = along_first * first + along_second * second;
  const double height =
      std::sqrt(std::max(0.0, (from.squaredNorm() - in_plane.squaredNorm()) / squared_sine));
  const Eigen::Vector3d between = in_plane + branch * height * normal;
  return std::array<double, 2>{angle_about(first, between, to), angle_about(second, from, between)};
}

}  // namespace parallel_aspects
