// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_DIRECT_TRIGONOMETRIC_ROOTS_H
#define PARALLEL_ASPECTS_KINEMATICS_DIRECT_TRIGONOMETRIC_ROOTS_H

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_KINEMATICS_DIRECT_TRIGONOMETRIC_ROOTS_H
