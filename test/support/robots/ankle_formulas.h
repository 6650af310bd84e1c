// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_ANKLE_FORMULAS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_ANKLE_FORMULAS_H

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <optional>

/// The ankle of `robots.h` by its drawing, in the frame of the shank, and nothing of the package: pitch about
/// y, roll about x 0.016 m below, cranks whose angles grow from x towards z.
namespace parallel_aspects::test::ankle_formulas {

using Eigen::Vector2d;
using Eigen::Vector3d;

inline constexpr double crank = 0.024, below = 0.016;

struct Rod {
  Vector3d pivot, anchor;
  double length;
};

inline const std::array<Rod, 2>& rods() {
  static const std::array<Rod, 2> all{Rod{{-0.005, 0.032, 0.205}, {-0.048, 0.026, 0.010}, 0.2119},
                                      Rod{{-0.005, -0.032, 0.135}, {-0.048, -0.026, 0.010}, 0.1424}};
  return all;
}

/// Ry(pitch) ((0, 0, -0.016) + Rx(roll) a).
inline Vector3d anchor_at(const Rod& rod, const Vector2d& angles) {
  const double c1 = std::cos(angles[0]), s1 = std::sin(angles[0]);
  const double c2 = std::cos(angles[1]), s2 = std::sin(angles[1]);
  const Vector3d& a = rod.anchor;
  const Vector3d rolled(a.x(), c2 * a.y() - s2 * a.z(), s2 * a.y() + c2 * a.z() - below);
  return {c1 * rolled.x() + s1 * rolled.z(), rolled.y(), -s1 * rolled.x() + c1 * rolled.z()};
}

/// Of the angle between the crank and the direction to the anchor; the leg reaches where it is within -1 to
/// 1, and is stretched or folded at the ends.
inline double crank_cosine(const Rod& rod, const Vector2d& angles) {
  const Vector3d d = anchor_at(rod, angles) - rod.pivot;
  return (d.squaredNorm() + crank * crank - rod.length * rod.length) /
         (2.0 * crank * std::hypot(d.x(), d.z()));
}

/// Angles of the cranks on the branches with these signs of u . c'; nothing where a leg does not reach.
inline std::optional<Vector2d> cranks(const Vector2d& angles, const std::array<int, 2>& signs) {
  Vector2d q;
  for (std::size_t j = 0; j < 2; ++j) {
    const Rod& rod = rods()[j];
    const double cosine = crank_cosine(rod, angles);
    if (!(std::abs(cosine) < 1.0)) return std::nullopt;
    const Vector3d d = anchor_at(rod, angles) - rod.pivot;
    q[static_cast<Eigen::Index>(j)] = std::atan2(d.z(), d.x()) - signs[j] * std::acos(cosine);
  }
  return q;
}

/// Squared distances of the ends less those of the rods [m^2].
inline Vector2d misfit(const Vector2d& angles, const Vector2d& q) {
  Vector2d result;
  for (Eigen::Index j = 0; j < 2; ++j) {
    const Rod& rod = rods()[static_cast<std::size_t>(j)];
    const Vector3d pin = rod.pivot + crank * Vector3d(std::cos(q[j]), 0.0, std::sin(q[j]));
    result[j] = (anchor_at(rod, angles) - pin).squaredNorm() - rod.length * rod.length;
  }
  return result;
}

/// Pitch and roll at these cranks, by Newton's method from angles near by, with differences for derivatives.
inline Vector2d angles_at(Vector2d angles, const Vector2d& q) {
  constexpr double step = 1e-6;
  for (int k = 0; k < 8; ++k) {
    Eigen::Matrix2d slopes;
    for (Eigen::Index i = 0; i < 2; ++i) {
      const Vector2d change = step * Vector2d::Unit(i);
      slopes.col(i) = (misfit(angles + change, q) - misfit(angles - change, q)) / (2.0 * step);
    }
    angles -= slopes.inverse() * misfit(angles, q);
  }
  return angles;
}

/// Root mean square of how far the anchors are apart [m].
inline double distance(const Vector2d& one, const Vector2d& other) {
  double sum = 0.0;
  for (const Rod& rod : rods()) sum += (anchor_at(rod, one) - anchor_at(rod, other)).squaredNorm();
  return std::sqrt(0.5 * sum);
}

}  // namespace parallel_aspects::test::ankle_formulas

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_ROBOTS_ANKLE_FORMULAS_H
