// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_AFFINE_H
#define PARALLEL_ASPECTS_INTERVAL_AFFINE_H

#include "interval/half_turns.h"
#include "interval/interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {

/// Encloses a function over a box by a linear one: for every point of the box, with its offset from the
/// center in half widths e_i in [-1, 1], the value is within `error` of  center + sum slope_i e_i.  Linear
/// parts cancel exactly where intervals would add their widths; what is left grows with the square of the
/// box.
///
/// Affine arithmetic after Comba and Stolfi, SIBGRAPI 1993, with the N coordinates as its only noise symbols.
/// Needs a live `RoundingUpward`: then every operation is too large by at most one part in 2^52, which goes
/// into the error together with what is not linear.
template <std::size_t N>
class Affine {
 public:
  Affine() noexcept = default;
  Affine(double constant) noexcept : center_(constant) {}  // NOLINT: numbers are exact constants
  Affine(const Interval& range) noexcept                   // NOLINT: constants that are known to an interval
      : center_(middle(range)), error_(half_width(range, center_)) {}

  /// The i-th coordinate of a box that has this range there.
  static Affine coordinate(const Interval& range, std::size_t i) noexcept {
    Affine result(middle(range));
    result.slope_[i] = half_width(range, result.center_);
    return result;
  }

  /// The i-th coordinate of the box of this center and half width.
  static Affine coordinate(double center, double half_width, std::size_t i) noexcept {
    Affine result(center);
    result.slope_[i] = half_width;
    return result;
  }

  double center() const noexcept { return center_; }
  double slope(std::size_t i) const noexcept { return slope_[i]; }
  double error() const noexcept { return error_; }

  Interval range() const noexcept { return around(deviation()); }

  /// Encloses the value at the center of the box.
  Interval at_center() const noexcept { return around(error_); }

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
    result.error_ = a.error_ + b.error_ + rounding * (std::abs(result.center_) + result.spread());
    return result;
  }

  friend Affine operator-(const Affine& a, const Affine& b) noexcept { return a + (-b); }

  friend Affine operator*(const Affine& a, const Affine& b) noexcept {
    const double spread_a = a.spread(), spread_b = b.spread();
    const double size_a = std::abs(a.center_), size_b = std::abs(b.center_);
    Affine result;
    double squares = 0.0, size_of_squares = 0.0;  // of e_i^2, which is in [0, 1]
    for (std::size_t i = 0; i < N; ++i) {
      result.slope_[i] = a.center_ * b.slope_[i] + b.center_ * a.slope_[i];
      const double product = a.slope_[i] * b.slope_[i];
      squares += product;
      size_of_squares += std::abs(product);
    }
    result.center_ = a.center_ * b.center_ + 0.5 * squares;
    // (l_a + r_a) (l_b + r_b) for the linear parts l and the errors r, with half of the squares in the
    // center.
    const double mixed = spread_a * spread_b + 0.5 * size_of_squares - lower_bound(size_of_squares);
    result.error_ = mixed + size_a * b.error_ + size_b * a.error_ + spread_a * b.error_ +
                    spread_b * a.error_ + a.error_ * b.error_ +
                    many_roundings * (size_a * size_b + size_a * spread_b + size_b * spread_a +
                                      spread_a * spread_b + smallest);
    return result;
  }

  friend Affine operator*(const Interval& factor, const Affine& a) noexcept {
    const double middle_factor = middle(factor), size = std::abs(middle_factor);
    Affine result;
    result.center_ = middle_factor * a.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = middle_factor * a.slope_[i];
    const double largest = std::abs(a.center_) + a.deviation();
    result.error_ = size * a.error_ + half_width(factor, middle_factor) * largest +
                    many_roundings * (size * largest + smallest);
    return result;
  }

  Affine& operator+=(const Affine& other) noexcept { return *this = *this + other; }

  friend Affine square(const Affine& a) noexcept { return a * a; }

  /// 1/a where a is known to be at least `least` > 0 on the box.
  friend Affine reciprocal(const Affine& a, double least) noexcept {
    const Interval range = a.range();
    const double lower = std::max(least, range.lower()), c = a.center_;
    if (!(c > lower && lower > 0.0)) return Affine(reciprocal(Interval(lower, range.upper())));
    // 1/a = 1/c - x/c^2 + x^2/(c^2 a) with a = c + x.
    const Interval over(c), bend = Interval(0.0, a.deviation());
    const Interval slope = reciprocal(square(over));
    return linear(a, reciprocal(over), -slope, square(bend) * slope * reciprocal(Interval(lower)));
  }

  /// sqrt(a) where a is known to be at least `least` > 0 on the box.
  friend Affine square_root(const Affine& a, double least) noexcept {
    const Interval range = a.range();
    const double lower = std::max(least, range.lower()), c = a.center_;
    if (!(c > lower && lower > 0.0)) return Affine(square_root(Interval(lower, range.upper())));
    // sqrt(a) = s + x/(2 s) - x^2 / (2 s (s + sqrt(a))^2) with s = sqrt(c).
    const Interval root = square_root(Interval(c)), bend = Interval(0.0, a.deviation());
    const Interval slope = reciprocal(Interval(2.0) * root);
    const Interval farthest = square(root + square_root(Interval(lower)));
    return linear(a, root, slope, -(square(bend) * slope * reciprocal(farthest)));
  }

  /// { cos(pi a), sin(pi a) } for a within [-1, 1].
  friend Turn<Affine> turn_of_half_turns(const Affine& a) noexcept {
    const Interval range = intersection(a.range(), Interval(-1.0, 1.0)), center(a.center_);
    const Turn<Interval> at = turn_of_half_turns(center), over = turn_of_half_turns(range);
    const Interval pi = pi_enclosure();
    const Interval bend = Interval(0.5) * square(pi * Interval(0.0, a.deviation()));
    return {linear(a, at.cosine, -(pi * at.sine), -(bend * over.cosine)),
            linear(a, at.sine, pi * at.cosine, -(bend * over.sine))};
  }

 private:
  static constexpr double rounding = 0x1p-52;
  static constexpr double many_roundings = 0x1p-48;
  static constexpr double smallest =
      0x1p-900;  // products that underflow are off by less than its square root

  static double middle(const Interval& a) noexcept { return 0.5 * (a.lower() + a.upper()); }
  static double half_width(const Interval& a, double from) noexcept {
    return std::max(a.upper() - from, from - a.lower());
  }
  static double lower_bound(double a) noexcept { return a * (1.0 - 0x1p-50); }

  /// f(c) + slope x + curvature, with a = c + x.
  static Affine linear(const Affine& a, const Interval& at_center, const Interval& slope,
                       const Interval& curvature) noexcept {
    Affine offset = a;
    offset.center_ = 0.0;
    return slope * offset + Affine(at_center + curvature);
  }

  double spread() const noexcept {
    double sum = 0.0;
    for (const double each : slope_) sum += std::abs(each);
    return sum;
  }

  double deviation() const noexcept { return spread() + error_; }

  Interval around(double radius) const noexcept { return {-(radius - center_), center_ + radius}; }

  double center_ = 0.0;
  std::array<double, N> slope_{};
  double error_ = 0.0;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_AFFINE_H
