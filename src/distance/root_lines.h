// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_ROOT_LINES_H
#define PARALLEL_ASPECTS_DISTANCE_ROOT_LINES_H

#include "interval/interval.h"

#include <algorithm>

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_ROOT_LINES_H
