// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_INTERVAL_PATH_FORM_H
#define PARALLEL_ASPECTS_INTERVAL_PATH_FORM_H

#include "interval/interval.h"

#include <algorithm>

namespace parallel_aspects {

/// The largest magnitude in an interval.
inline double magnitude(const Interval& a) noexcept { return std::max(-a.lower(), a.upper()); }

/// Enclosures of a function of one parameter s in [-1, 1]: its value at s = 0, its values over the whole
/// range, and its derivative over the whole range. Every operation also takes the mean-value form
/// center + slope [-1, 1] into the range, so that ranges are tight to the second order. Needs a live
/// `RoundingUpward`.
struct PathForm {
  Interval center, range, slope;

  PathForm() = default;
  PathForm(const Interval& constant)
      : center(constant), range(constant) {}                   // NOLINT: constants have no slope
  PathForm(double constant) : PathForm(Interval(constant)) {}  // NOLINT

  /// The parameter t itself where it runs from `begin` to `end`; s = 0 is at `middle` between them.
  static PathForm parameter(double begin, double middle, double end) {
    PathForm result;
    result.center = Interval(middle);
    result.range = Interval(begin, end);
    result.slope = Interval(std::max(end - middle, middle - begin));
    return result;
  }

  friend PathForm operator-(const PathForm& a) { return {-a.center, -a.range, -a.slope}; }
  friend PathForm operator+(const PathForm& a, const PathForm& b) {
    return tightened(a.center + b.center, a.range + b.range, a.slope + b.slope);
  }
  friend PathForm operator-(const PathForm& a, const PathForm& b) {
    return tightened(a.center - b.center, a.range - b.range, a.slope - b.slope);
  }
  friend PathForm operator*(const PathForm& a, const PathForm& b) {
    return tightened(a.center * b.center, a.range * b.range, a.slope * b.range + a.range * b.slope);
  }
  friend PathForm operator*(const Interval& factor, const PathForm& a) {
    return {factor * a.center, factor * a.range, factor * a.slope};
  }
  friend PathForm square(const PathForm& a) {
    return tightened(square(a.center), square(a.range), Interval(2.0) * (a.range * a.slope));
  }

  /// The range must be positive.
  friend PathForm reciprocal(const PathForm& a) {
    const Interval range = reciprocal(a.range);
    return tightened(reciprocal(a.center), range, -(square(range) * a.slope));
  }

  /// The same where a is known to be at least `least` > 0.
  friend PathForm reciprocal(const PathForm& a, double least) {
    const Interval range = reciprocal(a.range, least);
    return tightened(reciprocal(a.center, least), range, -(square(range) * a.slope));
  }

  /// The range must be positive.
  friend PathForm square_root(const PathForm& a) {
    const Interval range = square_root(a.range);
    return tightened(square_root(a.center), range, a.slope * reciprocal(Interval(2.0) * range));
  }

  /// f(a) for a function f whose values at a.center, over a.range and whose derivative over a.range are
  /// these.
  friend PathForm composed(const PathForm& a, const Interval& at_center, const Interval& over_range,
                           const Interval& derivative) {
    return tightened(at_center, over_range, derivative * a.slope);
  }

 private:
  PathForm(const Interval& at_center, const Interval& over_range, const Interval& derivative)
      : center(at_center), range(over_range), slope(derivative) {}

  static PathForm tightened(const Interval& center, const Interval& range, const Interval& slope) {
    const double spread = magnitude(slope);
    return {center, intersection(range, center + Interval(-spread, spread)), slope};
  }
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_INTERVAL_PATH_FORM_H
