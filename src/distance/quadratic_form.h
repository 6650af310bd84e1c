// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_QUADRATIC_FORM_H
#define PARALLEL_ASPECTS_DISTANCE_QUADRATIC_FORM_H

#include "distance/point_dual.h"
#include "interval/affine.h"
#include "interval/interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {

/// Encloses sqrt(a) where a is from `least` >= 0 to `most`, by slope a + offset: with the slope 1 / (l + m)
/// of the chord between l and m, the roots of these, sqrt(a) - slope a is the same at both ends, l m / (l +
/// m), and at most 1 / (4 slope). All of this file needs a live `RoundingUpward`.
struct Chord {
  Interval slope, offset;

  Chord(double least, double most) noexcept {
    const Interval l = square_root(Interval(least)), m = square_root(Interval(most)), sum = l + m;
    if (!sum.positive()) {
      offset = Interval(0.0, m.upper());
      return;
    }
    slope = Interval(reciprocal(sum).upper());
    const double at_ends = std::min((l - slope * square(l)).lower(), (m - slope * square(m)).lower());
    offset = Interval(at_ends, (Interval(0.25) * reciprocal(slope)).upper());
  }
};

/// sqrt(a) where a is from `least` >= 0 to `most`.
template <class Form>
Form root_between(const Form& a, double least, double most) noexcept {
  const Chord chord(least, most);
  return chord.slope * a + Form(chord.offset);
}

/// sqrt(a) is within `gap` of `middle`, a polynomial, wherever a is not negative.
template <class Form>
struct RootInBall {
  Form middle;
  double gap = 0.0;

  /// By a chord where a falls far below the middle of its range, where Taylor's series are long.
  explicit RootInBall(const Form& a) noexcept {
    constexpr double least_share = 0.3;
    const Interval range = a.range();
    const Form enclosure = range.lower() > least_share * range.upper()
                               ? square_root(a, range.lower())
                               : root_between(a, std::max(0.0, range.lower()), std::max(0.0, range.upper()));
    middle = enclosure.without_error();
    gap = enclosure.error();
  }
};

/// Where a quadratic form is an enclosure: offsets e from the center, in half widths, with all |e_i| <= 1, or
/// with |e| <= 1.
enum class FormDomain { box, ball };

/// Encloses a function over a box by a quadratic one: for every point of the box, with its offset from the
/// center in half widths e_i in [-1, 1], the value is within `error` of
///
///     center + sum slope_i e_i + sum_{i <= k} bend_ik e_i e_k.
///
/// So linear and quadratic parts cancel exactly where `Affine` adds up the sizes of the latter, which is what
/// limits it for determinants; what is left grows with the cube of the box. Over the ball in the box sums of
/// magnitudes become lengths, which are less the more coordinates there are. A Taylor model of order two
/// (Makino and Berz 2003). Needs a live `RoundingUpward`; rounding goes into the error.
template <std::size_t N, FormDomain domain = FormDomain::box>
class QuadraticForm {
 public:
  QuadraticForm() noexcept = default;
  QuadraticForm(double constant) noexcept : center_(constant) {}  // NOLINT: numbers are exact constants
  QuadraticForm(const Interval& range) noexcept                   // NOLINT: constants known to an interval
      : center_(middle(range)), error_(half_width(range, center_)) {}

  /// The i-th coordinate of the box of this center and half width.
  static QuadraticForm coordinate(double center, double half_width, std::size_t i) noexcept {
    QuadraticForm result(center);
    result.slope_[i] = half_width;
    return result;
  }

  /// The value at the center, but for `error`.
  double center() const noexcept { return center_; }

  /// The linear part, with the rest enclosed.
  Affine<N> linear() const noexcept {
    const Interval bend = bend_range();
    Affine<N> result = Affine<N>(Interval(center_) + bend + Interval(-error_, error_));
    for (std::size_t i = 0; i < N; ++i) result += Affine<N>::coordinate(0.0, slope_[i], i);
    return result;
  }

  Interval range() const noexcept {
    const double spread = slopes() + error_;
    return Interval(center_) + bend_range() + Interval(-spread, spread);
  }

  friend QuadraticForm operator-(const QuadraticForm& a) noexcept {
    QuadraticForm result;
    result.center_ = -a.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = -a.slope_[i];
    for (std::size_t i = 0; i < bends; ++i) result.bend_[i] = -a.bend_[i];
    result.error_ = a.error_;
    return result;
  }

  friend QuadraticForm operator+(const QuadraticForm& a, const QuadraticForm& b) noexcept {
    QuadraticForm result;
    result.center_ = a.center_ + b.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = a.slope_[i] + b.slope_[i];
    for (std::size_t i = 0; i < bends; ++i) result.bend_[i] = a.bend_[i] + b.bend_[i];
    result.error_ = a.error_ + b.error_ + result.size_of_rounding();
    return result;
  }

  friend QuadraticForm operator-(const QuadraticForm& a, const QuadraticForm& b) noexcept {
    QuadraticForm result;
    result.center_ = a.center_ - b.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = a.slope_[i] - b.slope_[i];
    for (std::size_t i = 0; i < bends; ++i) result.bend_[i] = a.bend_[i] - b.bend_[i];
    result.error_ = a.error_ + b.error_ + result.size_of_rounding();
    return result;
  }

  friend QuadraticForm operator*(const QuadraticForm& a, const QuadraticForm& b) noexcept {
    QuadraticForm result;
    result.center_ = a.center_ * b.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = a.center_ * b.slope_[i] + b.center_ * a.slope_[i];
    for (std::size_t i = 0, at = 0; i < N; ++i) {
      result.bend_[at] = a.slope_[i] * b.slope_[i] + a.center_ * b.bend_[at] + b.center_ * a.bend_[at];
      ++at;
      for (std::size_t k = i + 1; k < N; ++k, ++at)
        result.bend_[at] = a.slope_[i] * b.slope_[k] + a.slope_[k] * b.slope_[i] + a.center_ * b.bend_[at] +
                           b.center_ * a.bend_[at];
    }
    const double slopes_a = a.slopes(), slopes_b = b.slopes(), bends_a = a.bendings(), bends_b = b.bendings();
    const double size_a = std::abs(a.center_) + slopes_a + bends_a;
    const double size_b = std::abs(b.center_) + slopes_b + bends_b;
    result.error_ = slopes_a * bends_b + bends_a * slopes_b + bends_a * bends_b + size_a * b.error_ +
                    size_b * a.error_ + a.error_ * b.error_ + many_roundings * (size_a * size_b + smallest);
    return result;
  }

  friend QuadraticForm operator*(const Interval& factor, const QuadraticForm& a) noexcept {
    const double by = middle(factor);
    QuadraticForm result;
    result.center_ = by * a.center_;
    for (std::size_t i = 0; i < N; ++i) result.slope_[i] = by * a.slope_[i];
    for (std::size_t i = 0; i < bends; ++i) result.bend_[i] = by * a.bend_[i];
    const double largest = std::abs(a.center_) + a.slopes() + a.bendings() + a.error_;
    result.error_ = std::abs(by) * a.error_ + half_width(factor, by) * largest +
                    many_roundings * (std::abs(by) * largest + smallest);
    return result;
  }

  QuadraticForm& operator+=(const QuadraticForm& other) noexcept { return *this = *this + other; }

  friend QuadraticForm square(const QuadraticForm& a) noexcept { return a * a; }

  /// sqrt(a) at those points of the box where a is at least `least` > 0.
  friend QuadraticForm square_root(const QuadraticForm& a, double least) noexcept {
    const double c = a.center_;
    if (!(c > least && least > 0.0)) return QuadraticForm(square_root(not_negative_part(a.range())));
    // sqrt(c + x) = s + x / (2 s) - x^2 / (8 s^3) + x^3 / (16 z^(5/2)) with s = sqrt(c), z between c and c +
    // x.
    QuadraticForm x = a;
    x.center_ = 0.0;
    const double farthest = x.slopes() + x.bendings() + x.error_;
    const Interval s = square_root(Interval(c)), inverse = reciprocal(s), lowest(least);
    const Interval half = Interval(0.5) * inverse, eighth = Interval(0.125) * (square(inverse) * inverse);
    const double cubed = farthest * farthest * farthest;
    const double rest =
        (Interval(cubed) * reciprocal(Interval(16.0) * (square(lowest) * square_root(lowest)))).upper();
    return QuadraticForm(s + Interval(-rest, rest)) + half * x - eighth * (x * x);
  }

 private:
  static constexpr std::size_t bends = N * (N + 1) / 2;
  static constexpr double rounding = 0x1p-51;
  static constexpr double many_roundings = 0x1p-47;
  static constexpr double smallest =
      0x1p-900;  // products that underflow are off by less than its square root

  static double middle(const Interval& a) noexcept { return 0.5 * (a.lower() + a.upper()); }
  static double half_width(const Interval& a, double from) noexcept {
    return std::max(a.upper() - from, from - a.lower());
  }

  // At most these for all points of the domain.
  double slopes() const noexcept {
    double sum = 0.0;
    if constexpr (domain == FormDomain::box) {
      for (const double each : slope_) sum += std::abs(each);
      return sum;
    } else {
      for (const double each : slope_) sum += each * each;
      return std::sqrt(sum);
    }
  }
  double bendings() const noexcept {
    double sum = 0.0;
    if constexpr (domain == FormDomain::box) {
      for (const double each : bend_) sum += std::abs(each);
      return sum;
    } else {
      return std::sqrt(squared_bends());
    }
  }

  // What a sum of this result is off by at most.
  double size_of_rounding() const noexcept {
    double sum = std::abs(center_);
    for (const double each : slope_) sum += std::abs(each);
    for (const double each : bend_) sum += std::abs(each);
    return rounding * sum;
  }

  // Squared Frobenius norm of the symmetric matrix.
  double squared_bends() const noexcept {
    double squares = 0.0;
    for (std::size_t i = 0, at = 0; i < N; ++i) {
      squares += bend_[at] * bend_[at];
      ++at;
      for (std::size_t k = i + 1; k < N; ++k, ++at) squares += 0.5 * bend_[at] * bend_[at];
    }
    return squares;
  }

  // In a box squares e_i^2 are in [0, 1].
  Interval bend_range() const noexcept {
    if constexpr (domain == FormDomain::ball) return bend_range_in_ball();
    double above = 0.0, below = 0.0;
    for (std::size_t i = 0, at = 0; i < N; ++i) {
      above += std::max(0.0, bend_[at]);
      below += std::max(0.0, -bend_[at]);
      ++at;
      for (std::size_t k = i + 1; k < N; ++k, ++at) {
        above += std::abs(bend_[at]);
        below += std::abs(bend_[at]);
      }
    }
    return {-below, above};
  }

  // With the trace t and the norm f of the matrix, its eigenvalues are within
  // sqrt((N - 1) / N) sqrt(f^2 - t^2 / N) of t / N (Wolkowicz and Styan 1980).
  Interval bend_range_in_ball() const noexcept {
    const Interval count(static_cast<double>(N)), share = reciprocal(count);
    Interval trace;
    for (std::size_t i = 0, at = 0; i < N; at += N - i, ++i) trace += Interval(bend_[at]);
    const Interval spread = square_root(not_negative_part(Interval(squared_bends()) - share * square(trace)) *
                                        (Interval(1.0) - share));
    const Interval values = share * trace + Interval(-spread.upper(), spread.upper());
    return {std::min(0.0, values.lower()), std::max(0.0, values.upper())};
  }

  double center_ = 0.0;
  std::array<double, N> slope_{};
  std::array<double, bends> bend_{};  // of e_0 e_0, e_0 e_1, ..., e_1 e_1, ...
  double error_ = 0.0;
};

template <std::size_t N, FormDomain domain>
QuadraticForm<N, domain> root(const QuadraticForm<N, domain>& a) noexcept {
  return a.range().positive() ? square_root(a, a.range().lower()) : QuadraticForm<N, domain>(root(a.range()));
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_QUADRATIC_FORM_H
