// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CUSPS_JET_H
#define PARALLEL_ASPECTS_ASPECTS_CUSPS_JET_H

#include "interval/interval.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// Enclosures, over a box, of a function of two coordinates and of its partial derivatives up to an order.
/// Needs a live `RoundingUpward`.
template <std::size_t Order>
class Jet {
 public:
  static constexpr std::size_t count = (Order + 1) * (Order + 2) / 2;

  /// The derivative taken i times along the first coordinate and k times along the second; i + k <= Order.
  const Interval& at(std::size_t i, std::size_t k) const noexcept { return values_[place(i, k)]; }
  Interval& at(std::size_t i, std::size_t k) noexcept { return values_[place(i, k)]; }
  const Interval& value() const noexcept { return values_[0]; }

  /// The derivative along a coordinate, 0 or 1, as a function.
  Jet<Order - 1> derivative(std::size_t axis) const noexcept {
    Jet<Order - 1> result;
    for (std::size_t i = 0; i < Order; ++i)
      for (std::size_t k = 0; i + k < Order; ++k) result.at(i, k) = axis == 0 ? at(i + 1, k) : at(i, k + 1);
    return result;
  }

  /// The same with fewer derivatives.
  template <std::size_t Lower>
  Jet<Lower> truncated() const noexcept {
    static_assert(Lower <= Order);
    Jet<Lower> result;
    for (std::size_t i = 0; i <= Lower; ++i)
      for (std::size_t k = 0; i + k <= Lower; ++k) result.at(i, k) = at(i, k);
    return result;
  }

  friend Jet operator+(const Jet& a, const Jet& b) noexcept {
    Jet result;
    for (std::size_t n = 0; n < count; ++n) result.values_[n] = a.values_[n] + b.values_[n];
    return result;
  }

  friend Jet operator*(const Interval& factor, const Jet& a) noexcept {
    Jet result;
    for (std::size_t n = 0; n < count; ++n) result.values_[n] = factor * a.values_[n];
    return result;
  }

  friend Jet operator-(const Jet& a, const Jet& b) noexcept {
    Jet result;
    for (std::size_t n = 0; n < count; ++n) result.values_[n] = a.values_[n] - b.values_[n];
    return result;
  }

  /// By Leibniz's rule.
  friend Jet operator*(const Jet& a, const Jet& b) noexcept {
    Jet result;
    for (std::size_t i = 0; i <= Order; ++i)
      for (std::size_t k = 0; i + k <= Order; ++k) result.at(i, k) = product_derivative(a, b, i, k);
    return result;
  }

 private:
  static constexpr double binomials[4][4]{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  static_assert(Order <= 3);

  static constexpr std::size_t place(std::size_t i, std::size_t k) { return (i + k) * (i + k + 1) / 2 + k; }

  static Interval product_derivative(const Jet& a, const Jet& b, std::size_t i, std::size_t k) noexcept {
    Interval sum;
    for (std::size_t p = 0; p <= i; ++p)
      for (std::size_t q = 0; q <= k; ++q) {
        const Interval term = a.at(p, q) * b.at(i - p, k - q);
        const double factor = binomials[i][p] * binomials[k][q];
        sum += factor == 1.0 ? term : Interval(factor) * term;
      }
    return sum;
  }

  std::array<Interval, count> values_;
};

/// f_1 g_2 - f_2 g_1, of the derivatives along both coordinates: the determinant of the Jacobian of (f, g).
template <std::size_t Order>
Jet<Order - 1> bracket(const Jet<Order>& f, const Jet<Order>& g) noexcept {
  return f.derivative(0) * g.derivative(1) - f.derivative(1) * g.derivative(0);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CUSPS_JET_H
