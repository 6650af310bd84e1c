// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_DUAL_H
#define PARALLEL_ASPECTS_INTERVAL_DUAL_H

#include "interval/interval.h"

#include <array>
#include <cstddef>
#include <type_traits>

namespace parallel_aspects {

/// Enclosures of a function and of its partial derivatives over a box (forward automatic differentiation). N
/// is the number of pose coordinates, Value encloses numbers.
template <std::size_t N, class Value>
struct Dual {
  Value value;
  std::array<Value, N> gradient{};

  Dual() = default;
  Dual(const Value& constant) : value(constant) {}  // NOLINT: constants have no gradient
  Dual(double constant) : value(constant) {}        // NOLINT

  template <class Constant,
            class = std::enable_if_t<std::is_same_v<Constant, Interval> && !std::is_same_v<Value, Interval>>>
  Dual(const Constant& constant) : value(constant) {}  // NOLINT

  /// The i-th pose coordinate itself.
  static Dual coordinate(const Value& range, std::size_t i) {
    Dual result(range);
    result.gradient[i] = Value(1.0);
    return result;
  }

  friend Dual operator-(const Dual& a) {
    return a.mapped(-a.value, [](const Value& g) { return -g; });
  }
  friend Dual operator+(const Dual& a, const Dual& b) {
    return a.combined(b, a.value + b.value, [](const Value& x, const Value& y) { return x + y; });
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return a.combined(b, a.value - b.value, [](const Value& x, const Value& y) { return x - y; });
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return a.combined(b, a.value * b.value,
                      [&a, &b](const Value& x, const Value& y) { return x * b.value + a.value * y; });
  }
  friend Dual operator*(const Interval& factor, const Dual& a) {
    return a.mapped(factor * a.value, [&factor](const Value& g) { return factor * g; });
  }
  friend Dual square(const Dual& a) {
    const Value slope = Interval(2.0) * a.value;
    return a.mapped(square(a.value), [&slope](const Value& g) { return slope * g; });
  }

  /// The value must be at least `least` > 0 on the whole box.
  friend Dual reciprocal(const Dual& a, double least) {
    const Value value = reciprocal(a.value, least);
    const Value slope = -square(value);
    return a.mapped(value, [&slope](const Value& g) { return slope * g; });
  }

 private:
  template <class Function>
  Dual mapped(const Value& new_value, const Function& on_gradient) const {
    Dual result(new_value);
    for (std::size_t i = 0; i < N; ++i) result.gradient[i] = on_gradient(gradient[i]);
    return result;
  }

  template <class Function>
  Dual combined(const Dual& other, const Value& new_value, const Function& on_gradients) const {
    Dual result(new_value);
    for (std::size_t i = 0; i < N; ++i) result.gradient[i] = on_gradients(gradient[i], other.gradient[i]);
    return result;
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_DUAL_H
