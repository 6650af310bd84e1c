// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_SEPARATION_H
#define PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_SEPARATION_H

#include "interval/interval.h"
#include "interval/scalar_range.h"
#include "legs/limit_verdict.h"
#include "legs/link_points.h"
#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace parallel_aspects {

/// Of the size of the robot: points that are closer are one joint.
inline constexpr double joint_tolerance = 1e-9;

/// Whether these links are tested for collision: they are not of one leg, not joined to each other, and not
/// ignored. The robot must have the constraint of self-collision.
bool can_collide(const Manipulator& manipulator, const LinkName& one, const LinkName& other) noexcept;

/// Points of two bodies that are closest to each other, in double precision: what is proved starts from
/// there. Along a segment a share of 0 is its first end, 1 its second.
struct ClosestPoints {
  double first_share = 0.0, second_share = 0.0;  ///< the second is unused for a box
  Eigen::Vector3d second_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d difference = Eigen::Vector3d::Zero();  ///< first point minus second [m]
};

/// Of two segments, which may be points. (Ericson, Real-Time Collision Detection, 2005, section 5.1.9.)
ClosestPoints closest_points(const Eigen::Vector3d& a_from, const Eigen::Vector3d& a_to,
                             const Eigen::Vector3d& b_from, const Eigen::Vector3d& b_to) noexcept;

/// Of a segment and the box of all |x_i| <= half_size_i. Where they meet, the point of the segment is in the
/// middle of what the box holds of it, and the difference is zero.
ClosestPoints closest_point_to_box(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                   const Eigen::Vector3d& half_size) noexcept;

// Whether two straight bodies, whose ends are enclosed over a box of poses, stay apart by more than some
// distance in all of it, or in none. A guess is made in the middle of the box in double precision; what is
// proved from it is a plane between the two, or two points that are too close, which holds for any guess.

template <class Scalar, std::size_t D>
Eigen::Vector3d middle_of(const Point<Scalar, D>& point) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < D; ++i) middle[static_cast<Eigen::Index>(i)] = middle_of(center_of(point[i]));
  return middle;
}

template <class Scalar, std::size_t D>
Scalar length_along(const Eigen::Vector3d& direction, const Point<Scalar, D>& point) {
  Scalar sum = Interval(direction[0]) * point[0];
  for (std::size_t i = 1; i < D; ++i)
    sum = sum + Interval(direction[static_cast<Eigen::Index>(i)]) * point[i];
  return sum;
}

template <class Scalar, std::size_t D>
Interval along(const Eigen::Vector3d& direction, const Point<Scalar, D>& point) {
  return range_of(length_along(direction, point));
}

/// An upper bound of the length of a vector. Needs a live `RoundingUpward`.
inline Interval length_of(const Eigen::Vector3d& vector) {
  assert_rounding_upward();
  return square_root(square(Interval(vector[0])) + square(Interval(vector[1])) + square(Interval(vector[2])));
}

/// Whether every part of `a` is farther along `direction` than every part of `b`, by more than `distance`
/// times its length.
template <class Scalar, std::size_t D>
bool is_beyond(const Segment<Scalar, D>& a, const Segment<Scalar, D>& b, const Eigen::Vector3d& direction,
               const Interval& distance) {
  const Interval margin = distance * length_of(direction);
  for (const Point<Scalar, D>* end : {&a.from, &a.to})
    for (const Point<Scalar, D>* other : {&b.from, &b.to})
      if (!(along(direction, *end - *other) - margin).positive()) return false;
  return true;
}

template <class Scalar, std::size_t D>
bool is_closer(const Point<Scalar, D>& a, const Point<Scalar, D>& b, const Interval& distance) {
  const Point<Scalar, D> difference = a - b;
  Scalar sum = square(difference[0]);
  for (std::size_t i = 1; i < D; ++i) sum = sum + square(difference[i]);
  return (square(distance) - range_of(sum)).positive();
}

template <class Scalar>
Interval area(const Point<Scalar, 2>& a, const Point<Scalar, 2>& b, const Point<Scalar, 2>& c) {
  return range_of((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

inline bool have_other_signs(const Interval& a, const Interval& b) {
  return (a.positive() && b.negative()) || (a.negative() && b.positive());
}

/// Whether the two cross each other all over the box; in the plane only.
template <class Scalar>
bool cross_each_other(const Segment<Scalar, 2>& a, const Segment<Scalar, 2>& b) {
  return have_other_signs(area(a.from, a.to, b.from), area(a.from, a.to, b.to)) &&
         have_other_signs(area(b.from, b.to, a.from), area(b.from, b.to, a.to));
}

template <class Scalar>
bool cross_each_other(const Segment<Scalar, 3>&, const Segment<Scalar, 3>&) {
  return false;
}

/// Whether two segments are farther from each other than `distance` (at least 0) [m].
template <class Scalar, std::size_t D>
Verdict are_apart(const Segment<Scalar, D>& a, const Segment<Scalar, D>& b, const Interval& distance) {
  const ClosestPoints closest =
      closest_points(middle_of(a.from), middle_of(a.to), middle_of(b.from), middle_of(b.to));
  const double apart = closest.difference.norm();
  if (apart > distance.lower() && is_beyond(a, b, closest.difference, distance)) return Verdict::holds;
  if (cross_each_other(a, b)) return Verdict::fails;
  if (!(apart < distance.upper())) return Verdict::unknown;
  const Interval share(closest.first_share), other_share(closest.second_share);
  return is_closer(point_at(a, share), point_at(b, other_share), distance) ? Verdict::fails
                                                                           : Verdict::unknown;
}

/// The distance of two segments less `distance`, as a function whose slope at the middle is that of the
/// distance there; proves nothing.
template <class Scalar, std::size_t D>
Scalar clearance(const Segment<Scalar, D>& a, const Segment<Scalar, D>& b, const Interval& distance) {
  const ClosestPoints closest =
      closest_points(middle_of(a.from), middle_of(a.to), middle_of(b.from), middle_of(b.to));
  const Point<Scalar, D> difference =
      point_at(a, Interval(closest.first_share)) - point_at(b, Interval(closest.second_share));
  return length_along(closest.difference.normalized(), difference) - Scalar(distance);
}

/// A box in its own frame: all |x_i| <= half_size_i [m].
template <std::size_t D>
struct CenteredBox {
  std::array<double, D> half_size;

  /// Its extent along a direction.
  Interval reach(const Eigen::Vector3d& direction) const {
    Interval sum(0.0);
    for (std::size_t i = 0; i < D; ++i)
      sum += Interval(half_size[i]) * Interval(std::abs(direction[static_cast<Eigen::Index>(i)]));
    return sum;
  }

  /// How far a coordinate is beyond the box; zero in it. It never falls as the coordinate grows.
  Interval beyond(const Interval& range, std::size_t i) const {
    const auto from_nearest = [this, i](double x) {
      return Interval(x) - Interval(std::clamp(x, -half_size[i], half_size[i]));
    };
    return {from_nearest(range.lower()).lower(), from_nearest(range.upper()).upper()};
  }

  Eigen::Vector3d corner() const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < D; ++i) result[static_cast<Eigen::Index>(i)] = half_size[i];
    return result;
  }

  template <class Scalar>
  bool holds(const Point<Scalar, D>& point) const {
    for (std::size_t i = 0; i < D; ++i) {
      const Interval range = range_of(point[i]);
      if (!(range.upper() < half_size[i] && -half_size[i] < range.lower())) return false;
    }
    return true;
  }
};

/// Whether a segment, seen in the frame of a box, is farther from it than `distance` (at least 0) [m].
template <class Scalar, std::size_t D>
Verdict is_apart_from_box(const Segment<Scalar, D>& a, const CenteredBox<D>& box, const Interval& distance) {
  const ClosestPoints closest = closest_point_to_box(middle_of(a.from), middle_of(a.to), box.corner());
  const Eigen::Vector3d& direction = closest.difference;
  const double apart = direction.norm();
  if (apart > distance.lower()) {
    const Interval margin = box.reach(direction) + distance * length_of(direction);
    if ((along(direction, a.from) - margin).positive() && (along(direction, a.to) - margin).positive())
      return Verdict::holds;
  }
  if (!(apart < distance.upper()) && apart > 0.0) return Verdict::unknown;
  const Point<Scalar, D> point = point_at(a, Interval(closest.first_share));
  if (box.holds(point)) return Verdict::fails;
  Point<Scalar, D> nearest;
  for (std::size_t i = 0; i < D; ++i) nearest[i] = Scalar(closest.second_point[static_cast<Eigen::Index>(i)]);
  return is_closer(point, nearest, distance) ? Verdict::fails : Verdict::unknown;
}

/// See `clearance` of two segments.
template <class Scalar, std::size_t D>
Scalar clearance(const Segment<Scalar, D>& a, const CenteredBox<D>& box, const Interval& distance) {
  const ClosestPoints closest = closest_point_to_box(middle_of(a.from), middle_of(a.to), box.corner());
  const Point<Scalar, D> point = point_at(a, Interval(closest.first_share));
  const Eigen::Vector3d direction = closest.difference.normalized();
  const double at_box = direction.dot(closest.second_point);
  return length_along(direction, point) - Scalar(at_box) - Scalar(distance);
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_CONSTRAINTS_SEPARATION_H
