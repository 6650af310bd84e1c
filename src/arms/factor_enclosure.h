// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ARMS_FACTOR_ENCLOSURE_H
#define PARALLEL_ASPECTS_ARMS_FACTOR_ENCLOSURE_H

#include "interval/affine.h"
#include "interval/half_turns.h"
#include "interval/interval.h"

#include "arms/trig_polynomial.h"
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace parallel_aspects {

/// An enclosure of a rational number.
Interval enclosure_of(const Rational& value);

/// { cos(pi a), sin(pi a) } for any a. Needs a live `RoundingUpward`.
template <std::size_t N>
Turn<Affine<N>> turn_of_any_half_turns(const Affine<N>& a) noexcept {
  const double quarters = std::nearbyint(2.0 * a.center());  // exact multiples of a quarter turn
  const Affine<N> rest = a - Affine<N>(0.5 * quarters);
  const Interval range = rest.range();
  if (!(range.lower() >= -1.0 && range.upper() <= 1.0)) return {Interval(-1.0, 1.0), Interval(-1.0, 1.0)};
  Turn<Affine<N>> turn = turn_of_half_turns(rest);
  for (int k = static_cast<int>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0)); k > 0; --k)
    turn = {-turn.sine, turn.cosine};
  return turn;
}

inline Turn<Interval> turn_of_any_half_turns(const Interval& a) noexcept {
  const Turn<Affine<1>> turn = turn_of_any_half_turns(Affine<1>::coordinate(a, 0));
  return {turn.cosine.range(), turn.sine.range()};
}

/// Cosine and sine of each joint's angle, or its length and 0.
template <class Number>
using JointNumbers = std::array<Turn<Number>, max_arm_joints>;

/// A polynomial to be enclosed over boxes of joint values.
class EnclosedPolynomial {
 public:
  EnclosedPolynomial() = default;
  explicit EnclosedPolynomial(const TrigPolynomial& polynomial);

  /// Needs a live `RoundingUpward`.
  template <class Number>
  Number over(const JointNumbers<Number>& joints) const {
    Number sum(0.0);
    for (const Term& term : terms_) {
      Number product(1.0);
      bool is_one = true;
      for (const std::uint8_t place : term.factors) {
        const Turn<Number>& turn = joints[place / 2];
        const Number& factor = place % 2 == 0 ? turn.cosine : turn.sine;
        product = is_one ? factor : product * factor;
        is_one = false;
      }
      sum = sum + term.coefficient * product;
    }
    return sum;
  }

 private:
  struct Term {
    Interval coefficient;
    std::vector<std::uint8_t> factors;  // places in `Exponents`, each as often as its power
  };
  std::vector<Term> terms_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ARMS_FACTOR_ENCLOSURE_H
