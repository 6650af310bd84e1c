// SPDX-License-Identifier: BSD-3-Clause
#include "distance/anchor_metric.h"

#include "model/linear_algebra.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>

namespace parallel_aspects {
namespace {

// Least share of the largest moment of the anchors that a rotation must be seen with.
constexpr double least_spread = 1e-10;

using Moments = std::array<std::array<Interval, 3>, 3>;
using Arm = std::array<Interval, 3>;

Arm arm_of(const Leg& leg, const Eigen::Vector3d& center) {
  return {Interval(leg.anchor.x()) - Interval(center.x()), Interval(leg.anchor.y()) - Interval(center.y()),
          Interval(leg.anchor.z()) - Interval(center.z())};
}

Interval share_of(const Manipulator& manipulator) {
  return reciprocal(Interval(static_cast<double>(manipulator.leg_count())));
}

Moments moments(const Manipulator& manipulator, const Eigen::Vector3d& center) {
  Moments sum{};
  for (const Leg& leg : manipulator.legs()) {
    const Arm b = arm_of(leg, center);
    const Interval squared = square(b[0]) + square(b[1]) + square(b[2]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) sum[i][k] += i == k ? squared - square(b[i]) : -(b[i] * b[k]);
  }
  for (auto& row : sum)
    for (Interval& each : row) each = share_of(manipulator) * each;
  return sum;
}

Eigen::Matrix3d middle_of(const Moments& moments) {
  Eigen::Matrix3d result;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Interval& each = moments[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
      result(i, k) = 0.5 * (each.lower() + each.upper());
    }
  return result;
}

double largest_magnitude(const Interval& a) { return std::max(-a.lower(), a.upper()); }

// An upper bound of |W^T J W - I| in the Frobenius norm.
double factor_error(const Moments& j, const Eigen::Matrix3d& w, Eigen::Index first) {
  double squares = 0.0;
  for (Eigen::Index i = first; i < 3; ++i)
    for (Eigen::Index k = first; k < 3; ++k) {
      Interval entry(i == k ? -1.0 : 0.0);
      for (Eigen::Index a = first; a < 3; ++a)
        for (Eigen::Index b = first; b < 3; ++b)
          entry += Interval(w(a, i)) * j[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] *
                   Interval(w(b, k));
      squares += largest_magnitude(entry) * largest_magnitude(entry);
    }
  return std::sqrt(squares);
}

// An upper bound of the length of the mean of the b_j, which is zero but for rounding.
double center_error(const Manipulator& manipulator, const Eigen::Vector3d& center) {
  Arm sum{};
  for (const Leg& leg : manipulator.legs()) {
    const Arm b = arm_of(leg, center);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += b[i];
  }
  double length = 0.0;
  for (const Interval& each : sum) length += largest_magnitude(share_of(manipulator) * each);
  return length;
}

}  // namespace

double AnchorMetric::turning(const Eigen::Vector3d& point) const {
  const RoundingUpward rounding;
  std::array<Interval, 3> b;
  for (std::size_t i = 0; i < 3; ++i)
    b[i] = Interval(point[static_cast<Eigen::Index>(i)]) - Interval(center[static_cast<Eigen::Index>(i)]);
  std::array<std::array<Interval, 3>, 3> columns, products;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i)
      columns[k][i] = Interval(half_turns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)));
    products[k] = {columns[k][1] * b[2] - columns[k][2] * b[1], columns[k][2] * b[0] - columns[k][0] * b[2],
                   columns[k][0] * b[1] - columns[k][1] * b[0]};
  }
  // The largest eigenvalue of the Gram matrix is at most the largest sum of magnitudes in a row of it.
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0.0;
    for (std::size_t l = 0; l < 3; ++l) {
      Interval entry;
      for (std::size_t i = 0; i < 3; ++i) entry += products[k][i] * products[l][i];
      sum += largest_magnitude(entry);
    }
    largest = std::max(largest, sum);
  }
  return std::sqrt(largest);
}

AnchorMetric::AnchorMetric(const Manipulator& manipulator)
    : center(Eigen::Vector3d::Zero()), half_turns(Eigen::Matrix3d::Zero()) {
  const RoundingUpward rounding;
  const TaskSpace space = manipulator.task_space();
  if (space != TaskSpace::SO3) {
    for (const Leg& leg : manipulator.legs()) center += leg.anchor;
    center /= static_cast<double>(manipulator.leg_count());
  }
  for (const Leg& leg : manipulator.legs())
    longest_arm = std::max(longest_arm, (leg.anchor - center).cwiseAbs().sum());
  usable = !has_rotation(space);
  if (usable) return;
  const Moments j = moments(manipulator, center);
  const Eigen::Matrix3d about = middle_of(j);
  const Eigen::Index first = space == TaskSpace::SE2 ? 2 : 0;
  const Eigen::Vector3d values = symmetric_eigenvalues(about);
  const double least = space == TaskSpace::SE2 ? about(2, 2) : values[0];
  usable = least > least_spread * about.trace() && std::isfinite(about.trace()) && about.trace() > 0.0;
  if (!usable) return;
  // With v the vector part of the unit quaternion of Q, |Q b - b| = 2 |v x b|: the mean of the squares is
  // 4 v^T J v, at most 4 trace J as |v| <= 1.
  widest_turn = 2.0 * std::sqrt(about.trace());
  if (space == TaskSpace::SE2)
    half_turns(2, 2) = 1.0 / std::sqrt(about(2, 2));
  else  // J = L L^T, and W = L^-T makes W^T J W = I
    half_turns = about.llt().matrixL().solve(Eigen::Matrix3d::Identity()).transpose();
  error = factor_error(j, half_turns, first);
  // The term 2 (c' - c) . mean (Q - I) b of D^2, at most 4 |c' - c| |v| |mean b|.
  if (space != TaskSpace::SO3) error += 2.0 * half_turns.norm() * center_error(manipulator, center);
}

}  // namespace parallel_aspects
