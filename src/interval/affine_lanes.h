// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_AFFINE_LANES_H
#define PARALLEL_ASPECTS_INTERVAL_AFFINE_LANES_H

#include "interval/half_turns.h"
#include "interval/interval_lanes.h"
#include "interval/lanes.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// Several affine forms at once, with the operations of `Affine` in their order, which says what they are:
/// each lane is the same to the last digit. Needs a live `RoundingUpward`, -frounding-math and
/// -ffp-contract=off.
template <std::size_t N, class Number>
class AffineLanes {
 public:
  using Range = IntervalLanes<Number>;

  AffineLanes() noexcept = default;
  AffineLanes(double constant) noexcept : center_(in_lanes<Number>(constant)) {}  // NOLINT: exact constants
  AffineLanes(const Range& range) noexcept  // NOLINT: constants that are known to intervals
      : center_(middle(range)), error_(half_width(range, center_)) {}

  AffineLanes(const Interval& range) noexcept  // NOLINT: the same constant in every lane
      : AffineLanes(Range(range)) {}

  /// The i-th coordinate of a box that has this range there.
  static AffineLanes coordinate(const Range& range, std::size_t i) noexcept {
    AffineLanes result;
    result.center_ = middle(range);
    result.slope_[i] = half_width(range, result.center_);
    return result;
  }

  Range range() const noexcept { return around(deviation()); }

  /// Encloses the value at the center of the box.
  Range at_center() const noexcept { return around(error_); }

  friend AffineLanes operator-(const AffineLanes& a) noexcept {
    AffineLanes result;
    result.center_ = -a.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = -a.slope_[i];
    result.error_ = a.error_;
    return result;
  }

  friend AffineLanes operator+(const AffineLanes& a, const AffineLanes& b) noexcept {
    AffineLanes result;
    result.center_ = a.center_ + b.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = a.slope_[i] + b.slope_[i];
    result.error_ = a.error_ + b.error_ + rounding * (modulus(result.center_) + result.spread());
    return result;
  }

  friend AffineLanes operator-(const AffineLanes& a, const AffineLanes& b) noexcept { return a + (-b); }

  friend AffineLanes operator*(const AffineLanes& a, const AffineLanes& b) noexcept {
    return outlined<Number>([&a, &b] { return product(a, b); });
  }

  friend AffineLanes operator*(const Interval& factor, const AffineLanes& a) noexcept {
    return outlined<Number>([&factor, &a] { return multiplied(factor, a); });
  }

  AffineLanes& operator+=(const AffineLanes& other) noexcept { return *this = *this + other; }

  friend AffineLanes square(const AffineLanes& a) noexcept { return a * a; }

  /// 1/a where a is known to be at least `least` > 0 on the box.
  friend AffineLanes reciprocal(const AffineLanes& a, double least) noexcept {
    return reciprocal(a, in_lanes<Number>(least));
  }
  friend AffineLanes reciprocal(const AffineLanes& a, const Number& least) noexcept {
    return outlined<Number>([&a, &least] { return reciprocal_of(a, least); });
  }

  /// sqrt(a) where a is known to be at least `least` > 0 on the box.
  friend AffineLanes square_root(const AffineLanes& a, const Number& least) noexcept {
    return outlined<Number>([&a, &least] { return square_root_of(a, least); });
  }

  /// The one form in lanes where the condition holds, the other elsewhere.
  template <class Mask>
  friend AffineLanes where(const Mask& condition, const AffineLanes& a, const AffineLanes& b) noexcept {
    AffineLanes result;
    result.center_ = where(condition, a.center_, b.center_);
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = where(condition, a.slope_[i], b.slope_[i]);
    result.error_ = where(condition, a.error_, b.error_);
    return result;
  }

  /// { cos(pi a), sin(pi a) } for a within [-1, 1].
  friend Turn<AffineLanes> turn_of_half_turns(const AffineLanes& a) noexcept {
    return outlined<Number>([&a] { return turn_of(a); });
  }

 private:
  static constexpr double rounding = 0x1p-52;
  static constexpr double many_roundings = 0x1p-48;
  static constexpr double smallest =
      0x1p-900;  // products that underflow are off by less than its square root

  static double middle(const Interval& a) noexcept { return 0.5 * (a.lower() + a.upper()); }
  static double half_width(const Interval& a, double from) noexcept {
    return larger_of(a.upper() - from, from - a.lower());
  }
  static Number middle(const Range& a) noexcept { return 0.5 * (a.lower() + a.upper()); }
  static Number half_width(const Range& a, const Number& from) noexcept {
    return larger_of(Number(a.upper() - from), Number(from - a.lower()));
  }
  static Number lower_bound(const Number& a) noexcept { return a * (1.0 - 0x1p-50); }

  static AffineLanes product(const AffineLanes& a, const AffineLanes& b) noexcept {
    const Number spread_a = a.spread(), spread_b = b.spread();
    const Number size_a = modulus(a.center_), size_b = modulus(b.center_);
    AffineLanes result;
    Number squares{}, size_of_squares{};  // of e_i^2, which is in [0, 1]
    for (std::size_t i = 0; i < N; ++i) {
      result.slope_[i] = a.center_ * b.slope_[i] + b.center_ * a.slope_[i];
      const Number product = a.slope_[i] * b.slope_[i];
      squares += product;
      size_of_squares += modulus(product);
    }
    result.center_ = a.center_ * b.center_ + 0.5 * squares;
    // (l_a + r_a) (l_b + r_b) for the linear parts l and the errors r, with half of the squares in the
    // center.
    const Number mixed = spread_a * spread_b + 0.5 * size_of_squares - lower_bound(size_of_squares);
    result.error_ = mixed + size_a * b.error_ + size_b * a.error_ + spread_a * b.error_ +
                    spread_b * a.error_ + a.error_ * b.error_ +
                    many_roundings * (size_a * size_b + size_a * spread_b + size_b * spread_a +
                                      spread_a * spread_b + smallest);
    return result;
  }

  /// Factor: an interval for all lanes, or one for each.
  template <class Factor>
  static AffineLanes multiplied(const Factor& factor, const AffineLanes& a) noexcept {
    const auto middle_factor = middle(factor), size = modulus(middle_factor);
    AffineLanes result;
    result.center_ = middle_factor * a.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = middle_factor * a.slope_[i];
    const Number largest = modulus(a.center_) + a.deviation();
    result.error_ = size * a.error_ + half_width(factor, middle_factor) * largest +
                    many_roundings * (size * largest + smallest);
    return result;
  }

  static AffineLanes reciprocal_of(const AffineLanes& a, const Number& least) noexcept {
    const Range range = a.range();
    const Number lower = larger_of(least, range.lower());
    const auto is_linear = (a.center_ > lower) & (lower > 0.0);
    if (in_none(is_linear)) return AffineLanes(reciprocal(Range(lower, range.upper())));
    const AffineLanes result = linear_reciprocal(a, where(is_linear, lower, in_lanes<Number>(1.0)),
                                                 where(is_linear, a.center_, in_lanes<Number>(1.0)));
    if (in_all(is_linear)) return result;
    return where(is_linear, result, AffineLanes(reciprocal(Range(lower, range.upper()))));
  }

  static AffineLanes square_root_of(const AffineLanes& a, const Number& least) noexcept {
    const Range range = a.range();
    const Number lower = larger_of(least, range.lower());
    const auto is_linear = (a.center_ > lower) & (lower > 0.0);
    if (in_none(is_linear)) return AffineLanes(square_root(Range(lower, range.upper())));
    const AffineLanes result = linear_root(a, where(is_linear, lower, in_lanes<Number>(1.0)),
                                           where(is_linear, a.center_, in_lanes<Number>(1.0)));
    if (in_all(is_linear)) return result;
    return where(is_linear, result, AffineLanes(square_root(Range(lower, range.upper()))));
  }

  static Turn<AffineLanes> turn_of(const AffineLanes& a) noexcept {
    const Range range = intersection(a.range(), Range(Interval(-1.0, 1.0))), center(a.center_, a.center_);
    const Turn<Range> at = turn_of_half_turns(center), over = turn_of_half_turns(range);
    const Range pi = pi_enclosure();
    const Range bend = Range(0.5) * square(pi * Range(Number{}, a.deviation()));
    return {linear(a, at.cosine, -(pi * at.sine), -(bend * over.cosine)),
            linear(a, at.sine, pi * at.cosine, -(bend * over.sine))};
  }

  // 1/a = 1/c - x/c^2 + x^2/(c^2 a) with a = c + x >= lower > 0.
  static AffineLanes linear_reciprocal(const AffineLanes& a, const Number& lower, const Number& c) noexcept {
    const Range over(c, c), bend = Range(Number{}, a.deviation());
    const Range slope = reciprocal(square(over));
    return linear(a, reciprocal(over), -slope, square(bend) * slope * reciprocal(Range(lower, lower)));
  }

  // sqrt(a) = s + x/(2 s) - x^2 / (2 s (s + sqrt(a))^2) with s = sqrt(c), a = c + x >= lower > 0.
  static AffineLanes linear_root(const AffineLanes& a, const Number& lower, const Number& c) noexcept {
    const Range root = square_root(Range(c, c)), bend = Range(Number{}, a.deviation());
    const Range slope = reciprocal(Range(2.0) * root);
    const Range farthest = square(root + square_root(Range(lower, lower)));
    return linear(a, root, slope, -(square(bend) * slope * reciprocal(farthest)));
  }

  /// f(c) + slope x + curvature, with a = c + x.
  static AffineLanes linear(const AffineLanes& a, const Range& at_center, const Range& slope,
                            const Range& curvature) noexcept {
    AffineLanes offset = a;
    offset.center_ = Number{};
    return multiplied(slope, offset) + AffineLanes(at_center + curvature);
  }

  Number spread() const noexcept {
    Number sum{};
    for (const Number& each : slope_) sum += modulus(each);
    return sum;
  }

  Number deviation() const noexcept { return spread() + error_; }

  Range around(const Number& radius) const noexcept { return {-(radius - center_), center_ + radius}; }

  Number center_{};
  std::array<Number, N> slope_{};
  Number error_{};
};

template <std::size_t N, class Number>
auto range_of(const AffineLanes<N, Number>& a) noexcept {
  return a.range();
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_AFFINE_LANES_H
