// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_POINT_DUAL_H
#define PARALLEL_ASPECTS_DISTANCE_POINT_DUAL_H

#include "interval/affine.h"
#include "interval/interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {

/// Coordinates of a local_chart, see there [m].
template <std::size_t N>
using Coordinates = std::array<double, N>;

template <std::size_t N>
double dot(const Coordinates<N>& a, const Coordinates<N>& b) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

/// A value and its gradient at one point, in floating point: it proves nothing. Of intervals it takes the
/// middle.
template <std::size_t N>
struct PointDual {
  double value = 0.0;
  Coordinates<N> gradient{};

  PointDual() noexcept = default;
  PointDual(double constant) noexcept : value(constant) {}                         // NOLINT
  PointDual(const Interval& a) noexcept : value(0.5 * (a.lower() + a.upper())) {}  // NOLINT

  static PointDual coordinate(double at, std::size_t i) noexcept {
    PointDual result(at);
    result.gradient[i] = 1.0;
    return result;
  }

  friend PointDual operator-(const PointDual& a) noexcept { return a.mapped(-a.value, -1.0); }
  friend PointDual operator+(const PointDual& a, const PointDual& b) noexcept {
    return combined(a.value + b.value, 1.0, a, 1.0, b);
  }
  friend PointDual operator-(const PointDual& a, const PointDual& b) noexcept {
    return combined(a.value - b.value, 1.0, a, -1.0, b);
  }
  friend PointDual operator*(const PointDual& a, const PointDual& b) noexcept {
    return combined(a.value * b.value, b.value, a, a.value, b);
  }
  friend PointDual operator*(const Interval& factor, const PointDual& a) noexcept {
    const double middle = 0.5 * (factor.lower() + factor.upper());
    return a.mapped(middle * a.value, middle);
  }
  PointDual& operator+=(const PointDual& other) noexcept { return *this = *this + other; }
  friend PointDual square(const PointDual& a) noexcept { return a.mapped(a.value * a.value, 2.0 * a.value); }
  friend PointDual root(const PointDual& a) noexcept {
    const double value = std::sqrt(std::max(0.0, a.value));
    return a.mapped(value, value > 0.0 ? 0.5 / value : 0.0);
  }

 private:
  PointDual mapped(double new_value, double slope) const noexcept {
    PointDual result(new_value);
    for (std::size_t i = 0; i < N; ++i) result.gradient[i] = slope * gradient[i];
    return result;
  }
  static PointDual combined(double value, double along_a, const PointDual& a, double along_b,
                            const PointDual& b) noexcept {
    PointDual result(value);
    for (std::size_t i = 0; i < N; ++i)
      result.gradient[i] = along_a * a.gradient[i] + along_b * b.gradient[i];
    return result;
  }
};

/// sqrt(max(0, a)) for each kind of numbers; that of `PointDual` is beside it.
inline Interval root(const Interval& a) noexcept { return square_root(not_negative_part(a)); }

template <std::size_t N>
Affine<N> root(const Affine<N>& a) noexcept {
  return a.range().positive() ? square_root(a, a.range().lower()) : Affine<N>(root(a.range()));
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_POINT_DUAL_H
