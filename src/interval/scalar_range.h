// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_SCALAR_RANGE_H
#define PARALLEL_ASPECTS_INTERVAL_SCALAR_RANGE_H

#include "interval/affine.h"
#include "interval/dual.h"
#include "interval/half_turns.h"
#include "interval/interval.h"
#include "interval/path_form.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

// What every kind of enclosure can tell of itself: `range_of` encloses its values, `center_of` the value in
// the middle of the box or of the part of a path.

namespace parallel_aspects {

inline double middle_of(const Interval& a) noexcept { return 0.5 * (a.lower() + a.upper()); }

inline Interval range_of(const Interval& a) noexcept { return a; }
inline Interval center_of(const Interval& a) noexcept { return a; }

template <std::size_t N, class Number>
auto range_of(const Affine<N, Number>& a) noexcept {
  return a.range();
}
template <std::size_t N, class Number>
auto center_of(const Affine<N, Number>& a) noexcept {
  return a.at_center();
}

template <std::size_t N, class Value>
auto range_of(const Dual<N, Value>& a) noexcept {
  return range_of(a.value);
}
template <std::size_t N, class Value>
auto center_of(const Dual<N, Value>& a) noexcept {
  return center_of(a.value);
}

inline Interval range_of(const PathForm& a) noexcept { return a.range; }
inline Interval center_of(const PathForm& a) noexcept { return a.center; }

/// A number that proves nothing, where templates ask for an enclosure: what they work out at one pose, in
/// double precision.
struct PointNumber {
  double value = 0.0;

  PointNumber() noexcept = default;
  PointNumber(double number) noexcept : value(number) {}                    // NOLINT: as of enclosures
  PointNumber(const Interval& range) noexcept : value(middle_of(range)) {}  // NOLINT

  friend PointNumber operator-(const PointNumber& a) noexcept { return -a.value; }
  friend PointNumber operator+(const PointNumber& a, const PointNumber& b) noexcept {
    return a.value + b.value;
  }
  friend PointNumber operator-(const PointNumber& a, const PointNumber& b) noexcept {
    return a.value - b.value;
  }
  friend PointNumber operator*(const PointNumber& a, const PointNumber& b) noexcept {
    return a.value * b.value;
  }
  friend PointNumber operator*(const Interval& a, const PointNumber& b) noexcept {
    return middle_of(a) * b.value;
  }
  PointNumber& operator+=(const PointNumber& other) noexcept { return *this = *this + other; }

  friend PointNumber square(const PointNumber& a) noexcept { return a.value * a.value; }
  friend PointNumber reciprocal(const PointNumber& a, double least) noexcept {
    return 1.0 / std::max(a.value, least);
  }
  friend PointNumber square_root(const PointNumber& a, double least) noexcept {
    return std::sqrt(std::max(a.value, least));
  }
  friend Turn<PointNumber> turn_of_half_turns(const PointNumber& a) noexcept {
    const double angle = middle_of(pi_enclosure()) * a.value;
    return {std::cos(angle), std::sin(angle)};
  }

  friend Interval range_of(const PointNumber& a) noexcept { return a.value; }
  friend Interval center_of(const PointNumber& a) noexcept { return a.value; }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_SCALAR_RANGE_H
