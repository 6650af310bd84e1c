// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_CUBIC_FORM_H
#define PARALLEL_ASPECTS_DISTANCE_CUBIC_FORM_H

#include "interval/interval.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace parallel_aspects {

/// Whether a symmetric matrix of up to 42 rows, of which the lower half is given, is proved to be positive
/// definite: where the factorization of it less c I ends, with c more than its rounding, 43 parts in 2^52 of
/// the trace (Rump 2006). Its entries may be off by a rounding of the trace. Overwrites the matrix; in every
/// rounding direction.
template <int N>
bool is_positive_definite(Eigen::Matrix<double, N, N>& a) noexcept {
  static_assert(N <= 42);
  constexpr double smallest = 0x1p-800;  // products that underflow are off by far less than a rounding of it
  const double trace = a.trace();
  if (!(trace > smallest) || !std::isfinite(trace)) return false;
  a.diagonal().array() -= 0x1p-45 * trace;
  for (Eigen::Index k = 0; k < N; ++k) {
    if (!(a(k, k) > 0.0)) return false;
    const double pivot = std::sqrt(a(k, k));
    double* const column = &a(0, k);
    for (Eigen::Index i = k; i < N; ++i) column[i] /= pivot;
    for (Eigen::Index j = k + 1; j < N; ++j) {
      double* const other = &a(0, j);
      const double factor = column[j];
      for (Eigen::Index i = j; i < N; ++i) other[i] -= factor * column[i];
    }
  }
  return true;
}

/// The products of up to three of N numbers e_i, in lexicographic order, a degree after the other.
template <std::size_t N>
struct Monomials {
  static constexpr std::size_t squares = N * (N + 1) / 2, cubes = N * (N + 1) * (N + 2) / 6;
  static constexpr std::size_t count = 1 + N + squares + cubes;
  static constexpr std::size_t first_square = 1 + N, first_cube = first_square + squares;

  /// The factors of the squares; which cube e_i times a square is; in how many orders the factors can stand.
  std::array<std::array<std::size_t, 2>, squares> factors{};
  std::array<std::array<std::uint8_t, squares>, N> cube{};
  std::array<double, count> orders{};

  constexpr Monomials() {
    for (std::size_t i = 0; i <= N; ++i) orders[i] = 1.0;
    std::array<std::array<std::size_t, N>, N> square{};
    std::size_t at = 0, above = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t k = i; k < N; ++k, ++at) {
        factors[at] = {i, k};
        square[i][k] = square[k][i] = at;
        orders[first_square + at] = i == k ? 1.0 : 2.0;
      }
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t k = i; k < N; ++k)
        for (std::size_t l = k; l < N; ++l, ++above) {
          cube[i][square[k][l]] = cube[k][square[i][l]] = cube[l][square[i][k]] =
              static_cast<std::uint8_t>(above);
          orders[first_cube + above] = i == k && k == l ? 1.0 : i == k || k == l ? 3.0 : 6.0;
        }
  }
};

/// Encloses a function over a ball by a cubic one: for every offset e from the center, in radii, |e| <= 1,
/// the value is within `error` of the sum of coefficients times monomials of e. What is left grows with the
/// fourth power of the ball. Each homogeneous part is at most its norm, the square root of the sum of c^2
/// over the number of orders of the factors: the orders times the squares of the monomials add up to a power
/// of |e|^2. A Taylor model of order three (Makino and Berz 2003). Needs a live `RoundingUpward`; rounding
/// goes into the error.
template <std::size_t N>
class CubicForm {
 public:
  using Of = Monomials<N>;
  static constexpr Of monomials{};

  CubicForm() noexcept = default;
  CubicForm(double constant) noexcept { of_[0] = constant; }  // NOLINT: numbers are exact constants
  CubicForm(const Interval& range) noexcept {                 // NOLINT: constants known to an interval
    of_[0] = middle(range);
    error_ = half_width(range, of_[0]);
  }

  /// The i-th coordinate in a ball of this radius.
  static CubicForm coordinate(double center, double radius, std::size_t i) noexcept {
    CubicForm result(center);
    result.of_[1 + i] = radius;
    return result;
  }

  double center() const noexcept { return of_[0]; }
  double coefficient(std::size_t i) const noexcept { return of_[i]; }
  double error() const noexcept { return error_; }

  /// The sum of the magnitudes of the coefficients.
  double size() const noexcept {
    std::array<double, 4> sums{};
    for (std::size_t i = 0; i < Of::count; i += 4)
      for (std::size_t k = 0; k < 4; ++k) sums[k] += std::abs(of_[i + k]);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }

  /// The polynomial itself.
  CubicForm without_error() const noexcept {
    CubicForm result = *this;
    result.error_ = 0.0;
    return result;
  }

  Interval range() const noexcept {
    const Norms n = norms();
    const double spread = n[1] + n[3] + error_;
    return Interval(of_[0]) + square_range() + Interval(-spread, spread);
  }

  friend CubicForm operator-(const CubicForm& a) noexcept {
    CubicForm result;
    for (std::size_t i = 0; i < Of::count; ++i) result.of_[i] = -a.of_[i];
    result.error_ = a.error_;
    return result;
  }

  friend CubicForm operator+(const CubicForm& a, const CubicForm& b) noexcept {
    CubicForm result;
    for (std::size_t i = 0; i < Of::count; ++i) result.of_[i] = a.of_[i] + b.of_[i];
    result.error_ = a.error_ + b.error_ + result.size_of_rounding();
    return result;
  }

  friend CubicForm operator-(const CubicForm& a, const CubicForm& b) noexcept {
    CubicForm result;
    for (std::size_t i = 0; i < Of::count; ++i) result.of_[i] = a.of_[i] - b.of_[i];
    result.error_ = a.error_ + b.error_ + result.size_of_rounding();
    return result;
  }

  friend CubicForm operator*(const CubicForm& a, const CubicForm& b) noexcept {
    CubicForm result;
    for (std::size_t i = 1; i < Of::count; ++i) result.of_[i] = a.of_[0] * b.of_[i] + b.of_[0] * a.of_[i];
    result.of_[0] = a.of_[0] * b.of_[0];
    double *const squares = &result.of_[Of::first_square], *const cubes = &result.of_[Of::first_cube];
    for (std::size_t at = 0; at < Of::squares; ++at) {
      const auto [i, k] = monomials.factors[at];
      const double product = a.of_[1 + i] * b.of_[1 + k];
      squares[at] += i == k ? product : product + a.of_[1 + k] * b.of_[1 + i];
    }
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t at = 0; at < Of::squares; ++at)
        cubes[monomials.cube[i][at]] +=
            a.of_[1 + i] * b.of_[Of::first_square + at] + b.of_[1 + i] * a.of_[Of::first_square + at];
    const Norms m = a.norms(), n = b.norms();
    const double size_a = m[0] + m[1] + m[2] + m[3], size_b = n[0] + n[1] + n[2] + n[3];
    result.error_ = m[1] * n[3] + m[2] * (n[2] + n[3]) + m[3] * (n[1] + n[2] + n[3]) + size_a * b.error_ +
                    size_b * a.error_ + a.error_ * b.error_ + many_roundings * (size_a * size_b + smallest);
    return result;
  }

  friend CubicForm operator*(const Interval& factor, const CubicForm& a) noexcept {
    const double by = middle(factor);
    CubicForm result;
    for (std::size_t i = 0; i < Of::count; ++i) result.of_[i] = by * a.of_[i];
    const double largest = a.size() + a.error_;
    result.error_ = std::abs(by) * a.error_ + half_width(factor, by) * largest +
                    many_roundings * (std::abs(by) * largest + smallest);
    return result;
  }

  CubicForm& operator+=(const CubicForm& other) noexcept { return *this = *this + other; }

  friend CubicForm square(const CubicForm& a) noexcept { return a * a; }

  /// sqrt(a) at those points of the ball where a is at least `least` > 0.
  friend CubicForm square_root(const CubicForm& a, double least) noexcept {
    const double c = a.of_[0];
    if (!(c > least && least > 0.0)) return CubicForm(square_root(not_negative_part(a.range())));
    // sqrt(c + x) = s + x / (2 s) - x^2 / (8 s^3) + x^3 / (16 s^5) - 5 x^4 / (128 z^(7/2)) with s = sqrt(c)
    // and z between c and c + x.
    CubicForm x = a;
    x.of_[0] = 0.0;
    const Norms n = x.norms();
    const double farthest = n[1] + n[2] + n[3] + x.error_, squared = farthest * farthest;
    const Interval s = square_root(Interval(c)), inverse = reciprocal(s), lowest(least);
    const Interval half = Interval(0.5) * inverse, by = square(inverse);
    const Interval seventh = square(lowest) * (lowest * square_root(lowest));
    const double rest = (Interval(5.0 * squared * squared) * reciprocal(Interval(128.0) * seventh)).upper();
    const CubicForm curved = CubicForm(half) - (Interval(0.25) * (half * by)) * x;
    const CubicForm bent = (Interval(0.125) * (half * square(by))) * (x * x);
    return CubicForm(s + Interval(-rest, 0.0)) + x * (curved + bent);
  }

 private:
  static constexpr double rounding = 0x1p-51;
  static constexpr double many_roundings = 0x1p-46;
  static constexpr double smallest =
      0x1p-900;  // products that underflow are off by less than its square root
  using Norms = std::array<double, 4>;

  static double middle(const Interval& a) noexcept { return 0.5 * (a.lower() + a.upper()); }
  static double half_width(const Interval& a, double from) noexcept {
    return std::max(a.upper() - from, from - a.lower());
  }

  // Of the homogeneous parts, degree by degree.
  Norms norms() const noexcept {
    Norms result{std::abs(of_[0]), 0.0, 0.0, 0.0};
    for (std::size_t i = 1; i < Of::first_square; ++i) result[1] += of_[i] * of_[i];
    for (std::size_t i = Of::first_square; i < Of::first_cube; ++i)
      result[2] += shares[i] * (of_[i] * of_[i]);
    for (std::size_t i = Of::first_cube; i < Of::count; ++i) result[3] += shares[i] * (of_[i] * of_[i]);
    for (std::size_t k = 1; k < 4; ++k) result[k] = std::sqrt(result[k]);
    return result;
  }

  // What a sum of this result is off by at most.
  double size_of_rounding() const noexcept { return rounding * size(); }

  // Between the least and the largest eigenvalue of the matrix, or zero. With the trace t and the norm f they
  // are within sqrt((N - 1) / N) sqrt(f^2 - t^2 / N) of t / N (Wolkowicz and Styan 1980); nearer bounds are
  // tried by halves.
  Interval square_range() const noexcept {
    const Interval count(static_cast<double>(N)), share = reciprocal(count);
    Interval trace;
    double squares = 0.0;
    for (std::size_t at = 0; at < Of::squares; ++at) {
      const double each = of_[Of::first_square + at];
      squares += shares[Of::first_square + at] * (each * each);
      if (monomials.factors[at][0] == monomials.factors[at][1]) trace += Interval(each);
    }
    const Interval mean = share * trace;
    const Interval spread =
        square_root(not_negative_part(Interval(squares) - share * square(trace)) * (Interval(1.0) - share));
    return {-largest_eigenvalue(-1.0, -mean.lower(), spread.upper() - mean.lower()),
            largest_eigenvalue(1.0, mean.upper(), mean.upper() + spread.upper())};
  }

  // At least that of `sign` times the matrix, or zero; it is between these.
  double largest_eigenvalue(double sign, double least, double proved) const noexcept {
    constexpr int halvings = 5;
    double failed = std::max(0.0, least);
    if (!(proved > failed)) return failed;
    for (int i = 0; i < halvings; ++i) {
      const double tried = 0.5 * (failed + proved);
      (is_above(sign, tried) ? proved : failed) = tried;
    }
    return proved;
  }

  bool is_above(double sign, double value) const noexcept {
    Eigen::Matrix<double, N, N> rest;
    for (std::size_t at = 0; at < Of::squares; ++at) {
      const auto i = static_cast<Eigen::Index>(monomials.factors[at][0]),
                 k = static_cast<Eigen::Index>(monomials.factors[at][1]);
      const double entry = -sign * of_[Of::first_square + at];
      rest(k, i) = i == k ? value + entry : 0.5 * entry;
    }
    return is_positive_definite(rest);
  }

  // Not less than one over the orders.
  static constexpr std::array<double, Of::count> find_shares() {
    std::array<double, Of::count> result{};
    for (std::size_t i = 0; i < Of::count; ++i) result[i] = (1.0 + 0x1p-50) / monomials.orders[i];
    return result;
  }
  static constexpr std::array<double, Of::count> shares = find_shares();

  std::array<double, Of::count> of_{};
  double error_ = 0.0;
};

template <std::size_t N>
CubicForm<N> root(const CubicForm<N>& a) noexcept {
  return a.range().positive() ? square_root(a, a.range().lower()) : CubicForm<N>(root(a.range()));
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_CUBIC_FORM_H
