// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_AFFINE_H
#define PARALLEL_ASPECTS_INTERVAL_AFFINE_H

#include "interval/half_turns.h"
#include "interval/interval_lanes.h"
#include "interval/lanes.h"

#include <array>
#include <cstddef>
#include <type_traits>

namespace parallel_aspects {

/// Encloses a function over a box by a linear one: for every point of the box, with its offset from the
/// center in half widths e_i in [-1, 1], the value is within `error` of  center + sum slope_i e_i.  Linear
/// parts cancel exactly where intervals would add their widths; what is left grows with the square of the
/// box.
///
/// Affine arithmetic after Comba and Stolfi, SIBGRAPI 1993, with the N coordinates as its only noise symbols.
/// Needs a live `RoundingUpward`: then every operation is too large by at most one part in 2^52, which goes
/// into the error together with what is not linear.
///
/// `Number`: double, or several at once in lanes, each of which is the same to the last digit as it is alone.
/// Lanes need -ffp-contract=off.
template <std::size_t N, class Number = double>
class Affine {
// A product of one number is otherwise two calls.
#define PARALLEL_ASPECTS_INLINE __attribute__((always_inline))
 public:
  using Range = RangeOf<Number>;

  Affine() noexcept = default;
  Affine(double constant) noexcept : center_(in_lanes<Number>(constant)) {}  // NOLINT: exact constants
  Affine(const Range& range) noexcept  // NOLINT: constants that are known to intervals
      : center_(middle(range)), error_(half_width(range, center_)) {}

  template <class Constant,
            class = std::enable_if_t<std::is_same_v<Constant, Interval> && !std::is_same_v<Range, Interval>>>
  Affine(const Constant& range) noexcept  // NOLINT: the same constant in every lane
      : Affine(Range(range)) {}

  /// The i-th coordinate of a box that has this range there.
  static Affine coordinate(const Range& range, std::size_t i) noexcept {
    const Number center = middle(range);
    return coordinate(center, half_width(range, center), i);
  }

  /// The i-th coordinate of the box of this center and half width.
  static Affine coordinate(const Number& center, const Number& half_width, std::size_t i) noexcept {
    Affine result;
    result.center_ = center;
    result.slope_[i] = half_width;
    return result;
  }

  const Number& center() const noexcept { return center_; }
  const Number& slope(std::size_t i) const noexcept { return slope_[i]; }
  const Number& error() const noexcept { return error_; }

  Range range() const noexcept { return around(deviation()); }

  /// Encloses the value at the center of the box.
  Range at_center() const noexcept { return around(error_); }

  friend Affine operator-(const Affine& a) noexcept {
    Affine result;
    result.center_ = -a.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = -a.slope_[i];
    result.error_ = a.error_;
    return result;
  }

  friend Affine operator+(const Affine& a, const Affine& b) noexcept {
    Affine result;
    result.center_ = a.center_ + b.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = a.slope_[i] + b.slope_[i];
    result.error_ = a.error_ + b.error_ + rounding * (modulus(result.center_) + result.spread());
    return result;
  }

  friend Affine operator-(const Affine& a, const Affine& b) noexcept { return a + (-b); }

  friend Affine operator*(const Affine& a, const Affine& b) noexcept {
    return outlined<Number>([&a, &b]() PARALLEL_ASPECTS_INLINE { return product(a, b); });
  }

  friend Affine operator*(const Interval& factor, const Affine& a) noexcept {
    return outlined<Number>([&factor, &a]() PARALLEL_ASPECTS_INLINE { return multiplied(factor, a); });
  }

  Affine& operator+=(const Affine& other) noexcept { return *this = *this + other; }

  friend Affine square(const Affine& a) noexcept { return a * a; }

  /// 1/a where a is known to be at least `least` > 0 on the box.
  template <class Least>
  friend Affine reciprocal(const Affine& a, const Least& least) noexcept {
    return outlined<Number>(
        [&a, &least]() PARALLEL_ASPECTS_INLINE { return reciprocal_of(a, in_lanes<Number>(least)); });
  }

  /// sqrt(a) where a is known to be at least `least` > 0 on the box.
  friend Affine square_root(const Affine& a, const Number& least) noexcept {
    return outlined<Number>([&a, &least]() PARALLEL_ASPECTS_INLINE { return square_root_of(a, least); });
  }

  /// The one form in lanes where the condition holds, the other elsewhere.
  template <class Mask>
  friend Affine where(const Mask& condition, const Affine& a, const Affine& b) noexcept {
    Affine result;
    result.center_ = where(condition, a.center_, b.center_);
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = where(condition, a.slope_[i], b.slope_[i]);
    result.error_ = where(condition, a.error_, b.error_);
    return result;
  }

  /// { cos(pi a), sin(pi a) } for a within [-1, 1].
  friend Turn<Affine> turn_of_half_turns(const Affine& a) noexcept {
    return outlined<Number>([&a]() PARALLEL_ASPECTS_INLINE { return turn_of(a); });
  }

#undef PARALLEL_ASPECTS_INLINE

 private:
  static constexpr double rounding = 0x1p-52;
  static constexpr double many_roundings = 0x1p-48;
  static constexpr double smallest =
      0x1p-900;  // products that underflow are off by less than its square root

  template <class Ends>
  static auto middle(const Ends& a) noexcept {
    return 0.5 * (a.lower() + a.upper());
  }
  template <class Ends, class From>
  static From half_width(const Ends& a, const From& from) noexcept {
    return larger_of(From(a.upper() - from), From(from - a.lower()));
  }
  static Number lower_bound(const Number& a) noexcept { return a * (1.0 - 0x1p-50); }

  static Affine product(const Affine& a, const Affine& b) noexcept {
    const Number spread_a = a.spread(), spread_b = b.spread();
    const Number size_a = modulus(a.center_), size_b = modulus(b.center_);
    Affine result;
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
  static Affine multiplied(const Factor& factor, const Affine& a) noexcept {
    const auto middle_factor = middle(factor), size = modulus(middle_factor);
    Affine result;
    result.center_ = middle_factor * a.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = middle_factor * a.slope_[i];
    const Number largest = modulus(a.center_) + a.deviation();
    result.error_ = size * a.error_ + half_width(factor, middle_factor) * largest +
                    many_roundings * (size * largest + smallest);
    return result;
  }

  static Affine reciprocal_of(const Affine& a, const Number& least) noexcept {
    const Range range = a.range();
    const Number lower = larger_of(least, range.lower());
    const MaskOf<Number> is_linear = (a.center_ > lower) & (lower > 0.0);
    if (in_none(is_linear)) return Affine(reciprocal(Range(lower, range.upper())));
    const Affine result = linear_reciprocal(a, where(is_linear, lower, in_lanes<Number>(1.0)),
                                            where(is_linear, a.center_, in_lanes<Number>(1.0)));
    if (in_all(is_linear)) return result;
    return where(is_linear, result, Affine(reciprocal(Range(lower, range.upper()))));
  }

  static Affine square_root_of(const Affine& a, const Number& least) noexcept {
    const Range range = a.range();
    const Number lower = larger_of(least, range.lower());
    const MaskOf<Number> is_linear = (a.center_ > lower) & (lower > 0.0);
    if (in_none(is_linear)) return Affine(square_root(Range(lower, range.upper())));
    const Affine result = linear_root(a, where(is_linear, lower, in_lanes<Number>(1.0)),
                                      where(is_linear, a.center_, in_lanes<Number>(1.0)));
    if (in_all(is_linear)) return result;
    return where(is_linear, result, Affine(square_root(Range(lower, range.upper()))));
  }

  static Turn<Affine> turn_of(const Affine& a) noexcept {
    const Range range = intersection(a.range(), Range(Interval(-1.0, 1.0))), center(a.center_, a.center_);
    const Turn<Range> at = turn_of_half_turns(center), over = turn_of_half_turns(range);
    const Range pi = pi_enclosure();
    const Range bend = Range(0.5) * square(pi * Range(Number{}, a.deviation()));
    return {linear(a, at.cosine, -(pi * at.sine), -(bend * over.cosine)),
            linear(a, at.sine, pi * at.cosine, -(bend * over.sine))};
  }

  // 1/a = 1/c - x/c^2 + x^2/(c^2 a) with a = c + x >= lower > 0.
  static Affine linear_reciprocal(const Affine& a, const Number& lower, const Number& c) noexcept {
    const Range over(c, c), bend = Range(Number{}, a.deviation());
    const Range slope = reciprocal(square(over));
    return linear(a, reciprocal(over), -slope, square(bend) * slope * reciprocal(Range(lower, lower)));
  }

  // sqrt(a) = s + x/(2 s) - x^2 / (2 s (s + sqrt(a))^2) with s = sqrt(c), a = c + x >= lower > 0.
  static Affine linear_root(const Affine& a, const Number& lower, const Number& c) noexcept {
    const Range root = square_root(Range(c, c)), bend = Range(Number{}, a.deviation());
    const Range slope = reciprocal(Range(2.0) * root);
    const Range farthest = square(root + square_root(Range(lower, lower)));
    return linear(a, root, slope, -(square(bend) * slope * reciprocal(farthest)));
  }

  /// f(c) + slope x + curvature, with a = c + x.
  static Affine linear(const Affine& a, const Range& at_center, const Range& slope,
                       const Range& curvature) noexcept {
    Affine offset = a;
    offset.center_ = Number{};
    return multiplied(slope, offset) + Affine(at_center + curvature);
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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_AFFINE_H
