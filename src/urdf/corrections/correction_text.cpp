// SPDX-License-Identifier: BSD-3-Clause
#include "urdf/corrections/correction_text.h"

#include "urdf/description/command_options.h"

#include <Eigen/Geometry>

#include <cmath>

namespace parallel_aspects {
namespace {

constexpr double rounding = 1e-9;  // of the longest coordinate, which adding up rounded frames leaves

std::string listed(const Eigen::Vector3d& vector, const std::string& between) {
  const double least = rounding * vector.lpNorm<Eigen::Infinity>();
  std::string text;
  for (Eigen::Index k = 0; k < 3; ++k)
    text += (k == 0 ? "" : between) + coordinate_text(std::abs(vector[k]) < least ? 0.0 : vector[k]);
  return text;
}

}  // namespace

std::string as_attribute(const Eigen::Vector3d& vector) { return listed(vector, " "); }

std::string in_brackets(const Eigen::Vector3d& vector) { return "(" + listed(vector, ", ") + ")"; }

std::string as_list(const Eigen::Vector3d& vector) { return "[" + listed(vector, ", ") + "]"; }

Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation) {
  const double level = std::hypot(rotation(0, 0), rotation(1, 0));
  return {std::atan2(rotation(2, 1), rotation(2, 2)), std::atan2(-rotation(2, 0), level),
          std::atan2(rotation(1, 0), rotation(0, 0))};
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& roll_pitch_yaw) {
  return (Eigen::AngleAxisd(roll_pitch_yaw.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(roll_pitch_yaw.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll_pitch_yaw.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace parallel_aspects
