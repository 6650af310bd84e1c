// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_LINK_POINTS_H
#define PARALLEL_ASPECTS_LEGS_LINK_POINTS_H

#include "interval/interval.h"

#include <array>
#include <cstddef>

namespace parallel_aspects {

/// A point of the plane or of space over some kind of enclosures [m].
template <class Scalar, std::size_t D>
using Point = std::array<Scalar, D>;

/// Of a point in space; what is out of the plane is left out where D is 2.
template <std::size_t D, class Scalar>
Point<Scalar, D> reduced(const std::array<Scalar, 3>& point) {
  Point<Scalar, D> result;
  for (std::size_t i = 0; i < D; ++i) result[i] = point[i];
  return result;
}

/// A point that is known to an interval and does not move.
template <class Scalar, std::size_t D>
Point<Scalar, D> constant(const Point<Interval, D>& point) {
  Point<Scalar, D> result;
  for (std::size_t i = 0; i < D; ++i) result[i] = Scalar(point[i]);
  return result;
}

/// A straight link between two points.
template <class Scalar, std::size_t D>
struct Segment {
  Point<Scalar, D> from, to;
};

/// The ends of the links of one leg, on one branch: the crank runs from `base` to `joint`, the rod from there
/// to `anchor`. Without a crank, `joint` is where the rod starts. Unused where the elbow is actuated:
/// `length`.
template <class Scalar, std::size_t D>
struct LinkPoints {
  Point<Scalar, D> base, joint, anchor;
  Scalar length;  ///< of the rod, in space [m]

  Segment<Scalar, D> crank() const { return {base, joint}; }
  Segment<Scalar, D> rod() const { return {joint, anchor}; }
};

template <class Scalar, std::size_t D>
Point<Scalar, D> operator-(const Point<Scalar, D>& a, const Point<Scalar, D>& b) {
  Point<Scalar, D> result;
  for (std::size_t i = 0; i < D; ++i) result[i] = a[i] - b[i];
  return result;
}

/// The point that divides a segment in this share of its length.
template <class Scalar, std::size_t D, class Number>
Point<Scalar, D> point_at(const Segment<Scalar, D>& segment, const Number& share) {
  Point<Scalar, D> result;
  for (std::size_t i = 0; i < D; ++i) result[i] = segment.from[i] + share * (segment.to[i] - segment.from[i]);
  return result;
}

/// u of a leg whose crank is on an arc, as a form of the leg that is fixed.
template <template <class> class Form>
struct RodOnArc {
  Form<Interval> form;
  Interval squared_length;  ///< of u, closer than that of the form
};

inline bool are_apart(const Interval& a, const Interval& b) noexcept {
  return a.upper() < b.lower() || b.upper() < a.lower();
}

inline bool has_sign(const Interval& value, int sign) noexcept {
  return sign > 0 ? value.positive() : value.negative();
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_LINK_POINTS_H
