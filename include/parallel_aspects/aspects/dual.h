// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_DUAL_H
#define PARALLEL_ASPECTS_ASPECTS_DUAL_H

#include "parallel_aspects/aspects/interval.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// Enclosures of a function and of its partial derivatives over a box, for mean-value forms (forward
/// automatic differentiation). N is the number of pose coordinates.
template <std::size_t N>
struct Dual {
  Interval value;
  std::array<Interval, N> gradient{};

  Dual() = default;
  Dual(const Interval& constant) : value(constant) {}  // NOLINT: constants have no gradient
  Dual(double constant) : value(constant) {}           // NOLINT

  /// The i-th pose coordinate itself.
  static Dual coordinate(const Interval& range, std::size_t i) {
    Dual result(range);
    result.gradient[i] = Interval(1.0);
    return result;
  }

  friend Dual operator-(const Dual& a) {
    return a.mapped(-a.value, [](const Interval& g) { return -g; });
  }
  friend Dual operator+(const Dual& a, const Dual& b) {
    return a.combined(b, a.value + b.value, [](const Interval& x, const Interval& y) { return x + y; });
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return a.combined(b, a.value - b.value, [](const Interval& x, const Interval& y) { return x - y; });
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return a.combined(b, a.value * b.value,
                      [&a, &b](const Interval& x, const Interval& y) { return x * b.value + a.value * y; });
  }
  friend Dual operator*(const Interval& factor, const Dual& a) {
    return a.mapped(factor * a.value, [&factor](const Interval& g) { return factor * g; });
  }
  friend Dual square(const Dual& a) {
    const Interval slope = Interval(2.0) * a.value;
    return a.mapped(square(a.value), [&slope](const Interval& g) { return slope * g; });
  }

  /// The value must be positive on the whole box.
  friend Dual reciprocal(const Dual& a) {
    const Interval value = reciprocal(a.value);
    const Interval slope = -square(value);
    return a.mapped(value, [&slope](const Interval& g) { return slope * g; });
  }

  /// The value must be positive on the whole box.
  friend Dual square_root(const Dual& a) {
    const Interval root = square_root(a.value);
    const Interval slope = reciprocal(Interval(2.0) * root);
    return a.mapped(root, [&slope](const Interval& g) { return slope * g; });
  }

 private:
  template <class Function>
  Dual mapped(const Interval& new_value, const Function& on_gradient) const {
    Dual result(new_value);
    for (std::size_t i = 0; i < N; ++i) result.gradient[i] = on_gradient(gradient[i]);
    return result;
  }

  template <class Function>
  Dual combined(const Dual& other, const Interval& new_value, const Function& on_gradients) const {
    Dual result(new_value);
    for (std::size_t i = 0; i < N; ++i) result.gradient[i] = on_gradients(gradient[i], other.gradient[i]);
    return result;
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_DUAL_H
