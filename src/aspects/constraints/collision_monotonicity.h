// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_COLLISION_MONOTONICITY_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_COLLISION_MONOTONICITY_H

#include "aspects/constraints/separation.h"
#include "aspects/tree/monotonicity.h"
#include "interval/dual.h"
#include "interval/interval.h"
#include "interval/scalar_range.h"
#include "legs/link_points.h"

#include <algorithm>
#include <array>
#include <cstddef>

// In which directions the poses grow where two bodies are farther apart than some distance.
//
// D^2, the squared distance of two segments, is the least |v|^2 of the vectors v from a point of one to a
// point of the other. Its derivative to either side along a coordinate is the least of 2 v.dv over the pairs
// of points that are closest (Danskin's theorem). So D does not fall along a coordinate where v.dv >= 0 for
// all pairs that can be closest, and then the poses with D > distance grow along it.

namespace parallel_aspects {

inline constexpr std::size_t collision_cells = 8;  // that the points of a segment are divided into

/// The part of a segment that a cell holds, as one point.
template <class Scalar, std::size_t D>
Point<Scalar, D> point_of_cell(const Segment<Scalar, D>& segment, std::size_t cell) {
  constexpr double width = 1.0 / static_cast<double>(collision_cells);  // exact
  const double begin = width * static_cast<double>(cell);
  return point_at(segment, Interval(begin, begin + width));
}

template <std::size_t N, class Value, std::size_t D>
Interval squared_length(const Point<Dual<N, Value>, D>& v) {
  Interval sum(0.0);
  for (const Dual<N, Value>& each : v) sum += square(range_of(each));
  return sum;
}

/// Requires of `monotonicity` that |v| does not fall, for every v in the enclosures.
template <std::size_t N, class Value, std::size_t D>
void require_farther(const Point<Dual<N, Value>, D>& v, Monotonicity& monotonicity) {
  std::array<Interval, N> slope;
  for (std::size_t i = 0; i < N; ++i) {
    Value sum = v[0].value * v[0].gradient[i];
    for (std::size_t k = 1; k < D; ++k) sum = sum + v[k].value * v[k].gradient[i];
    slope[i] = range_of(sum);
  }
  monotonicity.require(slope);
}

/// Requires of `monotonicity` that the segments do not come closer to each other.
template <std::size_t N, class Value, std::size_t D>
void require_distance(const Segment<Dual<N, Value>, D>& a, const Segment<Dual<N, Value>, D>& b,
                      Monotonicity& monotonicity) {
  const ClosestPoints closest =
      closest_points(middle_of(a.from), middle_of(a.to), middle_of(b.from), middle_of(b.to));
  const double farthest = squared_length<N, Value, D>(point_at(a, Interval(closest.first_share)) -
                                                      point_at(b, Interval(closest.second_share)))
                              .upper();
  std::array<Point<Dual<N, Value>, D>, collision_cells> points_of_b;
  for (std::size_t t = 0; t < collision_cells; ++t) points_of_b[t] = point_of_cell(b, t);
  for (std::size_t s = 0; s < collision_cells; ++s) {
    const Point<Dual<N, Value>, D> point = point_of_cell(a, s);
    for (std::size_t t = 0; t < collision_cells; ++t) {
      const Point<Dual<N, Value>, D> v = point - points_of_b[t];
      if (squared_length<N, Value, D>(v).lower() <= farthest) require_farther<N, Value, D>(v, monotonicity);
    }
  }
}

template <std::size_t N, class Value>
using PlanarSegment = Segment<Dual<N, Value>, 2>;

template <std::size_t N, class Value>
Dual<N, Value> oriented_area(const PlanarSegment<N, Value>& line, const Point<Dual<N, Value>, 2>& c) {
  const Point<Dual<N, Value>, 2>&a = line.from, &b = line.to;
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

inline int sign_of(const Interval& a) { return a.positive() ? 1 : a.negative() ? -1 : 0; }

/// Requires of `monotonicity` that poses where both ends of `a` are on one side of the line of `b` stay such;
/// one end must be proved to stay on its side. Whether all poses are such.
template <std::size_t N, class Value>
bool require_one_side(const PlanarSegment<N, Value>& a, const PlanarSegment<N, Value>& b,
                      Monotonicity& monotonicity) {
  const Dual<N, Value> from = oriented_area<N, Value>(b, a.from), to = oriented_area<N, Value>(b, a.to);
  const int from_sign = sign_of(range_of(from)), to_sign = sign_of(range_of(to));
  if (from_sign * to_sign != 0) return from_sign == to_sign;  // or there are no such poses
  if (from_sign == to_sign) {
    monotonicity = Monotonicity::unknown();
    return false;
  }
  const Dual<N, Value>& unknown = from_sign == 0 ? from : to;
  std::array<Interval, N> slope;
  for (std::size_t i = 0; i < N; ++i)
    slope[i] = range_of(Interval(from_sign != 0 ? from_sign : to_sign) * unknown.gradient[i]);
  monotonicity.require(slope);
  return false;
}

/// Requires of `monotonicity` that segments of the plane that do not cross stay such: those do not where the
/// ends of one are on one side of the other, and the poses of either kind grow.
template <std::size_t N, class Value>
void require_no_crossing(const PlanarSegment<N, Value>& a, const PlanarSegment<N, Value>& b,
                         Monotonicity& monotonicity) {
  Monotonicity both = monotonicity;
  if (require_one_side<N, Value>(a, b, both) || require_one_side<N, Value>(b, a, both)) return;
  monotonicity = both;
}

template <std::size_t N, class Value>
void require_no_crossing(const Segment<Dual<N, Value>, 3>&, const Segment<Dual<N, Value>, 3>&,
                         Monotonicity& monotonicity) {
  monotonicity = Monotonicity::unknown();
}

/// Leaves the directions in which the poses grow where the segments are farther apart than `distance` >= 0.
template <std::size_t N, class Value, std::size_t D>
void require_apart(const Segment<Dual<N, Value>, D>& a, const Segment<Dual<N, Value>, D>& b,
                   const Interval& distance, Monotonicity& monotonicity) {
  if (are_apart(a, b, distance) == Verdict::holds) return;
  if (distance.lower() > 0.0)
    require_distance<N, Value, D>(a, b, monotonicity);
  else
    require_no_crossing<N, Value>(a, b, monotonicity);
}

/// The squared distance of a point from a box.
template <std::size_t N, class Value, std::size_t D>
Interval square_beyond(const Point<Dual<N, Value>, D>& point, const CenteredBox<D>& box) {
  Interval sum(0.0);
  for (std::size_t k = 0; k < D; ++k) sum += square(box.beyond(range_of(point[k]), k));
  return sum;
}

/// The same for a box and a segment in its frame: the vectors from the nearest point of the box.
template <std::size_t N, class Value, std::size_t D>
void require_apart_from_box(const Segment<Dual<N, Value>, D>& a, const CenteredBox<D>& box,
                            const Interval& distance, Monotonicity& monotonicity) {
  if (is_apart_from_box(a, box, distance) == Verdict::holds) return;
  const ClosestPoints closest = closest_point_to_box(middle_of(a.from), middle_of(a.to), box.corner());
  const double farthest = square_beyond<N, Value, D>(point_at(a, Interval(closest.first_share)), box).upper();
  for (std::size_t s = 0; s < collision_cells; ++s) {
    Point<Dual<N, Value>, D> v = point_of_cell(a, s);
    if (square_beyond<N, Value, D>(v, box).lower() > farthest) continue;
    for (std::size_t k = 0; k < D; ++k) v[k].value = Value(box.beyond(range_of(v[k]), k));
    require_farther<N, Value, D>(v, monotonicity);
  }
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_COLLISION_MONOTONICITY_H
