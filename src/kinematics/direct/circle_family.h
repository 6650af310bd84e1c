// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_CIRCLE_FAMILY_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_CIRCLE_FAMILY_H

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace parallel_aspects {

/// f(t) = cosine[0] + sum over k of cosine[k] cos(k t) + sine[k] sin(k t), for k up to 4.
struct TrigonometricPolynomial {
  static constexpr std::size_t degree = 4;
  std::array<double, degree + 1> cosine{};
  std::array<double, degree + 1> sine{};

  /// The polynomial of degree 4 or less that `function` of the angle [rad] is known to be.
  static TrigonometricPolynomial interpolated(const std::function<double(double)>& function);

  /// The k-th derivative at t [rad], for k up to 2 and 0 being the value.
  std::array<double, 3> derivatives(double t) const;

  /// No k-th derivative is larger than this in absolute value.
  double bound(int k) const;
};

/// Every real root in (-pi, pi] [rad], of which there are eight at most, by subdivision of the circle with
/// bounds from Taylor's theorem. Roots closer together than 1e-7 rad, or apart by rounding only, may come as
/// one or several of nearly the same value; no root is missed. The zero polynomial must not be given;
/// one that is not finite has no roots.
std::vector<double> real_roots(const TrigonometricPolynomial& polynomial);

/// Two linear equations in a point v of the plane: matrix v = right.
struct LinearPair {
  Eigen::Matrix2d matrix;
  Eigen::Vector2d right;
};

/// Find an angle t and a point v with  matrix(t) v = right(t)  and  |v|^2 = squared_radius, where matrix and
/// right are trigonometric polynomials of degree 1. Locking two of three legs to the linear equations leaves
/// the direct problem in SE2 (v: from a proximal point to its anchor) and in SO3 (v: cosine and sine of the
/// turn about an anchor) so.
struct CircleFamily {
  std::function<LinearPair(double)> equations;
  double squared_radius;
};

struct CircleFamilySolutions {
  struct Candidate {
    double angle;  ///< t [rad]
    Eigen::Vector2d v;
  };
  bool every_angle = false;  ///< the equations leave t free; `candidates` then holds samples
  std::vector<Candidate> candidates;
};

/// Every real solution, at least to the accuracy of half the digits, and possibly others that are none.
/// Cramer's rule gives v = adj(matrix) right / det, so that t is a root of |adj(matrix) right|^2 -
/// squared_radius det^2, of degree 4 (at most 8 roots). Where det vanishes too, v is sought where one of the
/// lines meets the circle.
CircleFamilySolutions circle_family_solutions(const CircleFamily& family);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_CIRCLE_FAMILY_H
