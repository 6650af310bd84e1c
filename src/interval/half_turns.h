// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_HALF_TURNS_H
#define PARALLEL_ASPECTS_INTERVAL_HALF_TURNS_H

#include "interval/dual.h"
#include "interval/interval.h"

namespace parallel_aspects {

/// Enclosure of pi.
Interval pi_enclosure() noexcept;

/// { cos(pi t) : t in a }, for a within [-1, 1]. Wider than the range by less than 1e-14.
Interval cosine_of_half_turns(const Interval& a) noexcept;

/// { sin(pi t) : t in a }, for a within [-1, 1]. Wider than the range by less than 1e-14.
Interval sine_of_half_turns(const Interval& a) noexcept;

/// Cosine and sine at once.
template <class Scalar>
struct Turn {
  Scalar cosine, sine;
};

inline Turn<Interval> turn_of_half_turns(const Interval& a) noexcept {
  return {cosine_of_half_turns(a), sine_of_half_turns(a)};
}

/// Of an angle [rad] that is itself a rounded sum or arc tangent: its error and that of cosine and sine are a
/// few units in the last place each, in every rounding direction.
Turn<Interval> enclosed_turn(double angle) noexcept;

/// Of `zero` + `sense` q for all q of a range [rad].
Turn<Interval> enclosed_turn(double zero, double sense, const Interval& q) noexcept;

template <std::size_t N, class Value>
Turn<Dual<N, Value>> turn_of_half_turns(const Dual<N, Value>& a) noexcept {
  const Turn<Value> value = turn_of_half_turns(a.value);
  Turn<Dual<N, Value>> result{value.cosine, value.sine};
  for (std::size_t i = 0; i < N; ++i) {
    const Value angle_gradient = pi_enclosure() * a.gradient[i];
    result.cosine.gradient[i] = -(value.sine * angle_gradient);
    result.sine.gradient[i] = value.cosine * angle_gradient;
  }
  return result;
}

/// `turn_of_half_turns`, which each thread remembers for some hundred of the last angles: sines cost more
/// than many other operations. The result is valid until the next call.
const Turn<Interval>& remembered_turn(const Interval& a) noexcept;

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_HALF_TURNS_H
