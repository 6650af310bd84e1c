// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_POINT_NUMBER_H
#define PARALLEL_ASPECTS_INTERVAL_POINT_NUMBER_H

#include "interval/half_turns.h"
#include "interval/interval.h"
#include "interval/scalar_range.h"

#include <algorithm>
#include <cmath>

namespace parallel_aspects {

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

#endif  // PARALLEL_ASPECTS_INTERVAL_POINT_NUMBER_H
