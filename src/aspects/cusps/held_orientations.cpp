// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/cusps/held_orientations.h"

#include "interval/scalar_range.h"
#include "legs/determinant.h"
#include "legs/held_point.h"
#include "model/angles.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace parallel_aspects {
namespace {

Spatial<Interval> unit(const Spatial<Interval>& v) {
  return scaled(reciprocal(square_root(squared_norm(v))), v);
}

/// A right-handed orthonormal frame whose third axis has this direction.
RotationRows<Interval> frame_along(const Spatial<Interval>& direction) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(middle_of(direction[i])) < std::abs(middle_of(direction[least]))) least = i;
  Spatial<Interval> other{0.0, 0.0, 0.0};
  other[least] = 1.0;
  const Spatial<Interval> third = unit(direction), first = unit(cross(other, direction));
  return {first, cross(third, first), third};
}

}  // namespace

HeldOrientations::HeldOrientations(const Leg& leg, double q) {
  const HeldPoint held(leg, q);
  const Spatial<Interval> anchor = enclosed(leg.anchor);
  base_ = frame_along(held.c);
  platform_ = frame_along(anchor);
  const Interval squares = squared_norm(held.c) + squared_norm(anchor) - held.squared_rod;
  cosine_ = Interval(0.5) * squares * reciprocal(square_root(squared_norm(held.c) * squared_norm(anchor)));
  sine_ = square_root(not_negative_part(Interval(1.0) - square(cosine_)));
  slope_ = held.slope;
  along_slope_ = dot(held.c, held.slope);
  anchor_ = anchor;
}

// With E^T m = (m1, m2, m3) and F^T b = (b1, b2, b3), and U and V the first two coordinates of Rz(-a) E^T m,
// X and Y those of Rz(phi) F^T b, it is  cos U X + V Y + sin (b3 U - m3 X) + cos m3 b3;  U X + V Y is a
// cosine of a + phi, U X - V Y one of phi - a.
CosineSum HeldOrientations::along(const Spatial<Interval>& m, const Spatial<Interval>& b) const noexcept {
  const Interval m1 = dot(base_[0], m), m2 = dot(base_[1], m), m3 = dot(base_[2], m);
  const Interval b1 = dot(platform_[0], b), b2 = dot(platform_[1], b), b3 = dot(platform_[2], b);
  const Interval half(0.5), plus = half * (Interval(1.0) + cosine_), minus = half * (cosine_ - Interval(1.0));
  CosineSum sum;
  sum.constant = cosine_ * m3 * b3;
  sum.of_sum = {plus * (m1 * b1 + m2 * b2), plus * (m2 * b1 - m1 * b2)};
  sum.of_difference = {minus * (m1 * b1 - m2 * b2), -(minus * (m1 * b2 + m2 * b1))};
  sum.of_direction = {sine_ * b3 * m1, sine_ * b3 * m2};
  sum.of_phi = {-(sine_ * m3 * b1), sine_ * m3 * b2};
  return sum;
}

CosineSum HeldOrientations::held_entry() const noexcept {
  CosineSum entry = along(slope_, anchor_);
  entry.constant = entry.constant - along_slope_;
  return entry;
}

Pose HeldOrientations::pose(const std::array<double, 2>& at) const {
  const auto columns = [](const RotationRows<Interval>& axes) {
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        matrix(k, i) = middle_of(axes[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]);
    return matrix;
  };
  const auto turn = [](double angle, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  };
  const double gamma = std::atan2(middle_of(sine_), middle_of(cosine_));
  const Eigen::Matrix3d rotation =
      columns(base_) * turn(pi * at[0], Eigen::Vector3d::UnitZ()) * turn(gamma, Eigen::Vector3d::UnitY()) *
      turn(pi * at[1], Eigen::Vector3d::UnitZ()) * columns(platform_).transpose();
  Pose pose;
  pose.orientation = Eigen::Quaterniond(rotation).normalized();
  return pose;
}

}  // namespace parallel_aspects
