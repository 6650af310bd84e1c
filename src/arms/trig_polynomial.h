// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_TRIG_POLYNOMIAL_H
#define PARALLEL_ASPECTS_ARMS_TRIG_POLYNOMIAL_H

// GCC 12 takes the storage that small integers of Boost do not use for a value, wherever it is inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace parallel_aspects {

using Rational = boost::multiprecision::cpp_rational;

inline constexpr std::size_t max_arm_joints = 6;

/// Of each joint: powers of the cosine and of the sine of its angle, the latter 0 or 1; or the power of its
/// length, and 0.
using Exponents = std::array<std::uint8_t, 2 * max_arm_joints>;

/// A polynomial in cosines and sines of joint angles, and in joint lengths, with rational coefficients. With
/// sin^2 = 1 - cos^2 it is written in one way only, so that it vanishes where it has no terms.
class TrigPolynomial {
 public:
  TrigPolynomial() = default;
  TrigPolynomial(const Rational& constant) { add(Exponents{}, constant); }  // NOLINT: constants are numbers
  TrigPolynomial(int constant) : TrigPolynomial(Rational(constant)) {}      // NOLINT

  static TrigPolynomial cosine(std::size_t joint) { return power(2 * joint); }
  static TrigPolynomial sine(std::size_t joint) { return power(2 * joint + 1); }
  static TrigPolynomial length(std::size_t joint) { return power(2 * joint); }

  const std::map<Exponents, Rational>& terms() const noexcept { return terms_; }
  bool is_zero() const noexcept { return terms_.empty(); }
  bool depends_on(std::size_t joint) const noexcept;
  std::vector<std::size_t> joints() const;  ///< that it depends on

  void add(const Exponents& exponents, const Rational& coefficient);

  friend TrigPolynomial operator+(TrigPolynomial a, const TrigPolynomial& b) {
    for (const auto& [exponents, coefficient] : b.terms_) a.add(exponents, coefficient);
    return a;
  }
  friend TrigPolynomial operator-(TrigPolynomial a, const TrigPolynomial& b) {
    for (const auto& [exponents, coefficient] : b.terms_) a.add(exponents, -coefficient);
    return a;
  }
  friend TrigPolynomial operator*(const TrigPolynomial& a, const TrigPolynomial& b);
  friend bool operator==(const TrigPolynomial& a, const TrigPolynomial& b) { return a.terms_ == b.terms_; }

  /// By the angle, or the length, of a joint.
  TrigPolynomial derivative(std::size_t joint, bool turns) const;

 private:
  static TrigPolynomial power(std::size_t place) {
    Exponents exponents{};
    exponents[place] = 1;
    TrigPolynomial result;
    result.add(exponents, 1);
    return result;
  }
  void add_product(const Exponents& a, const Exponents& b, const Rational& coefficient);

  std::map<Exponents, Rational> terms_;
};

/// What a polynomial is in one joint, the other exponents held: a polynomial for each monomial of these.
std::map<Exponents, TrigPolynomial> by_other_joints(const TrigPolynomial& a, std::size_t joint);

/// f and g with a = f g, where f depends on one turning joint alone and has every such factor of `a`; f is 1
/// where there is none. Of polynomials in half angles: a factor that changes its sign in a full turn is left
/// in `a`.
struct Content {
  TrigPolynomial factor, rest;
};
Content content_in(const TrigPolynomial& a, std::size_t joint);

/// f and g with a = f g, of which no joint is in both; f has some of `joints` alone. Nothing where there are
/// none.
std::vector<TrigPolynomial> split(const TrigPolynomial& a, const std::vector<std::size_t>& joints);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_TRIG_POLYNOMIAL_H
