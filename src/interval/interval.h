// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_INTERVAL_H
#define PARALLEL_ASPECTS_INTERVAL_INTERVAL_H

#include <algorithm>
#include <cassert>
#include <cfenv>
#include <cmath>

// What proofs rest on of floating-point arithmetic.

namespace parallel_aspects {

/// While one lives, floating-point operations of its thread round upward. Intervals are enclosures only
/// meanwhile. Hold one for a whole batch: switching costs more than many operations.
class RoundingUpward {
 public:
  RoundingUpward() noexcept : before_(std::fegetround()) { std::fesetround(FE_UPWARD); }
  ~RoundingUpward() { std::fesetround(before_); }
  RoundingUpward(const RoundingUpward&) = delete;
  RoundingUpward& operator=(const RoundingUpward&) = delete;

 private:
  int before_;
};

/// Whether this thread rounds upward, found by arithmetic. `fegetround` of glibc reads the control word of
/// the x87 unit only, while the proofs are computed by SSE.
inline bool rounds_upward() noexcept {
  const volatile double one = 1.0, tiny = 0x1p-60;
  return one + tiny > 1.0;
}

/// First in whatever needs a live `RoundingUpward`. Checked where assertions are: in debug and sanitized
/// builds.
inline void assert_rounding_upward() noexcept { assert(rounds_upward()); }

/// A member whose constructor needs a live `RoundingUpward`.
template <class Made, class... Arguments>
Made made_under_upward_rounding(const Arguments&... arguments) {
  const RoundingUpward rounding;
  return Made(arguments...);
}

/// More than a few units in the last place of numbers up to 1: what sine, cosine and sums of some rounded
/// numbers are off by at most, in every rounding direction.
inline constexpr double few_units = 0x1p-48;

/// A lower bound of sqrt(-a), for an upper bound `a` of what is not positive. The root and the product are
/// rounded up, by one part in 2^52 each; the factor takes two.
inline double lower_root_of_negated(double a) noexcept { return std::sqrt(-a) * (1.0 - 0x1p-51); }

/// A closed interval of real numbers [lower, upper] with outward rounding.
///
/// Stored as (-lower, upper), so that both ends round upward and one rounding direction serves all
/// operations; the two lanes share vector instructions. Needs a live `RoundingUpward`, -frounding-math, and
/// finite operands.
class Interval {
 public:
  Interval() noexcept : lanes_{0.0, 0.0} {}
  Interval(double value) noexcept : lanes_{-value, value} {}  // NOLINT: numbers are exact intervals
  Interval(double lower, double upper) noexcept : lanes_{-lower, upper} {}

  double lower() const noexcept { return -lanes_[0]; }
  double upper() const noexcept { return lanes_[1]; }

  bool positive() const noexcept { return lanes_[0] < 0.0; }
  bool negative() const noexcept { return lanes_[1] < 0.0; }

  friend Interval operator-(const Interval& a) noexcept { return Interval(swapped(a.lanes_)); }

  friend Interval operator+(const Interval& a, const Interval& b) noexcept {
    return Interval(a.lanes_ + b.lanes_);
  }

  friend Interval operator-(const Interval& a, const Interval& b) noexcept {
    return Interval(a.lanes_ + swapped(b.lanes_));
  }

  friend Interval operator*(const Interval& a, const Interval& b) noexcept {
    const double na = a.lanes_[0], ua = a.lanes_[1];
    const double nb = b.lanes_[0], ub = b.lanes_[1];
    const Lanes lower_lower = Lanes{na, na} * Lanes{-nb, nb};
    const Lanes lower_upper = Lanes{na, -na} * Lanes{ub, ub};
    const Lanes upper_lower = Lanes{ua, ua} * Lanes{nb, -nb};
    const Lanes upper_upper = Lanes{-ua, ua} * Lanes{ub, ub};
    return Interval(larger(larger(lower_lower, lower_upper), larger(upper_lower, upper_upper)));
  }

  Interval& operator+=(const Interval& other) noexcept { return *this = *this + other; }

  /// { x^2 : x in a }, tighter than a * a where a holds zero.
  friend Interval square(const Interval& a) noexcept {
    const double smallest = std::max({0.0, a.lower(), -a.upper()});
    const double largest = std::max(a.lanes_[0], a.lanes_[1]);
    return Interval(Lanes{-smallest * smallest, largest * largest});
  }

  /// { sqrt(x) : x in a, x >= 0 }; a must not be negative altogether.
  friend Interval square_root(const Interval& a) noexcept {
    // The root comes rounded up; one part in 2^52 less is at least one unit in the last place below it.
    constexpr double down = 1.0 - 0x1p-52;
    const double root_of_lower = std::sqrt(std::max(0.0, a.lower()));
    return Interval(Lanes{-root_of_lower * down, std::sqrt(std::max(0.0, a.upper()))});
  }

  /// { 1/x : x in a }; a must be positive.
  friend Interval reciprocal(const Interval& a) noexcept {
    return Interval(Lanes{-1.0 / a.upper(), 1.0 / a.lower()});
  }

 private:
  using Lanes = double __attribute__((vector_size(16)));

  explicit Interval(Lanes lanes) noexcept : lanes_(lanes) {}

  static Lanes swapped(Lanes lanes) noexcept { return Lanes{lanes[1], lanes[0]}; }
  static Lanes larger(Lanes a, Lanes b) noexcept { return a > b ? a : b; }

  Lanes lanes_;
};

/// The same where a is known to be at least `least` > 0.
inline Interval reciprocal(const Interval& a, double least) noexcept {
  return reciprocal(Interval(std::max(a.lower(), least), a.upper()));
}

/// What two enclosures of one value leave of it; they must meet.
inline Interval intersection(const Interval& a, const Interval& b) noexcept {
  return {std::max(a.lower(), b.lower()), std::min(a.upper(), b.upper())};
}

/// { |x| : x in a }.
inline Interval absolute(const Interval& a) noexcept {
  return {std::max({0.0, a.lower(), -a.upper()}), std::max(-a.lower(), a.upper())};
}

/// The part of `a` that is not negative; `a` must have one.
inline Interval not_negative_part(const Interval& a) noexcept {
  return {std::max(0.0, a.lower()), std::max(0.0, a.upper())};
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_INTERVAL_H
