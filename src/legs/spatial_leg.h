// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_SPATIAL_LEG_H
#define PARALLEL_ASPECTS_LEGS_SPATIAL_LEG_H

#include "interval/dual.h"
#include "interval/half_turns.h"
#include "interval/interval.h"
#include "interval/scalar_range.h"
#include "legs/limit_verdict.h"
#include "legs/link_points.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>
#include <cstddef>
#include <optional>

namespace parallel_aspects {

/// A vector of space over intervals or duals.
template <class Scalar>
using Spatial = std::array<Scalar, 3>;

inline Spatial<Interval> enclosed(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

template <class Scalar>
Scalar squared_norm(const Spatial<Scalar>& d) {
  return square(d[0]) + square(d[1]) + square(d[2]);
}

template <class Scalar>
Scalar dot(const Spatial<Interval>& a, const Spatial<Scalar>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A leg seen from the displacement d = p - base point of its anchor. For both signs s of B_jj,
/// |B_jj| = sqrt(squared_b_entry), and u = p - c has the direction of `fixed + s sqrt(squared_b_entry)
/// turned`.
template <class Scalar>
struct SpatialLegForm {
  Scalar squared_b_entry;
  Spatial<Scalar> fixed, turned;
};

/// A distance leg in space, with its constants enclosed for every robot within `Leg::tolerance`.
/// Must be made under a live `RoundingUpward`.
class SpatialLeg {
 public:
  explicit SpatialLeg(const Leg& leg);

  /// The base point [m].
  const Spatial<Interval>& base() const noexcept { return base_; }

  /// No anchor within reach is farther from the base point than this [m]; may be infinite.
  double reach() const noexcept { return reach_; }

  template <class Scalar>
  SpatialLegForm<Scalar> form(const Spatial<Scalar>& d) const;

  /// The positive factor k by which the direction of `form` is longer than u: it is k u.
  template <class Scalar>
  Scalar scale(const Spatial<Scalar>& d) const {
    return type_ == LegType::revolute ? squared_norm(d) - square(dot(axis_, d)) : Scalar(1.0);
  }

  /// The square of the length of the direction of `form`.
  template <class Scalar>
  Scalar squared_rod(const Spatial<Scalar>& d) const;

  /// u of a crank at these angles. Nothing where the rod has another length there, or
  /// B_jj another sign.
  std::optional<RodOnArc<SpatialLegForm>> rod_on_arc(const Spatial<Interval>& d, const Turn<Interval>& turn,
                                                     int sign) const;

  /// Limits of the joint value of branch `sign`, where |B_jj| is `entry`.
  template <class Scalar>
  LimitFunctions<Scalar> limits(const Spatial<Scalar>& d, const Scalar& entry, int sign) const;

  /// Where the links of branch `sign` end, where |B_jj| is `entry`. Nothing where the box is too large to
  /// tell.
  template <class Scalar>
  std::optional<LinkPoints<Scalar, 3>> link_points(const Spatial<Scalar>& d, const Scalar& entry,
                                                   int sign) const;

 private:
  void set(const RevoluteActuation& actuation, const Leg& leg);
  void set(const PrismaticActuation& actuation, const Leg& leg);
  void set(const StrutActuation& actuation, const Leg& leg);
  void set(const ElbowActuation& actuation, const Leg& leg);

  /// Parts of `form`, `limits` and `link_points` for a crank.
  template <class Scalar>
  SpatialLegForm<Scalar> form_with_crank(const Spatial<Scalar>& d) const;
  template <class Scalar>
  LimitFunctions<Scalar> limits_of_crank(const Spatial<Scalar>& d, const Scalar& signed_entry) const;
  template <class Scalar>
  bool find_tip(const Spatial<Scalar>& d, const Scalar& signed_entry, LinkPoints<Scalar, 3>& points) const;

  LegType type_;
  double reach_ = 0.0;
  Spatial<Interval> base_;
  Spatial<Interval> axis_, zero_direction_,
      side_direction_;                           // axis is the direction of an actuated prismatic joint
  Interval squared_longest_, squared_shortest_;  // two links stretched, folded
  Interval crank_;
  Interval squared_crank_, half_difference_;  // (rod^2 - crank^2) / 2
  Interval rod_, squared_rod_;
  Interval half_sum_;   // (inner^2 + outer^2) / 2 of an elbow
  double sense_ = 1.0;  // of a strut or elbow
  AngleLimits angle_limits_;
  LengthLimits length_limits_;
};

template <class Scalar>
SpatialLegForm<Scalar> SpatialLeg::form(const Spatial<Scalar>& d) const {
  switch (type_) {
    case LegType::revolute:
      break;
    case LegType::prismatic: {
      const Scalar along = dot(axis_, d);
      const Spatial<Scalar> across{d[0] - axis_[0] * along, d[1] - axis_[1] * along, d[2] - axis_[2] * along};
      return {squared_rod_ - squared_norm(across), across, {axis_[0], axis_[1], axis_[2]}};
    }
    case LegType::strut:
      return {squared_norm(d), d, {}};
    case LegType::elbow: {
      const Scalar w = squared_norm(d);
      return {Interval(0.25) * ((squared_longest_ - w) * (w - squared_shortest_)), d, {}};
    }
  }
  return form_with_crank(d);
}

// With D = |d|^2 - along^2 and a = (|d|^2 + crank^2 - rod^2) / 2:  D u = (D - a) d + a along axis + B (axis
// x d).
template <class Scalar>
SpatialLegForm<Scalar> SpatialLeg::form_with_crank(const Spatial<Scalar>& d) const {
  const Scalar w = squared_norm(d), along = dot(axis_, d);
  const Scalar a = Interval(0.5) * w - half_difference_;
  const Scalar k = (w - square(along)) - a;
  const Scalar lift = a * along;
  const Scalar spread = squared_crank_ * square(along);
  return {Interval(0.25) * ((squared_longest_ - w) * (w - squared_shortest_)) - spread,
          {k * d[0] + axis_[0] * lift, k * d[1] + axis_[1] * lift, k * d[2] + axis_[2] * lift},
          {axis_[1] * d[2] - axis_[2] * d[1], axis_[2] * d[0] - axis_[0] * d[2],
           axis_[0] * d[1] - axis_[1] * d[0]}};
}

template <class Scalar>
Scalar SpatialLeg::squared_rod(const Spatial<Scalar>& d) const {
  switch (type_) {
    case LegType::revolute:
      return squared_rod_ * square(scale(d));
    case LegType::prismatic:
      return Scalar(squared_rod_);
    case LegType::strut:
    case LegType::elbow:
      break;
  }
  return squared_norm(d);
}

template <class Scalar>
LimitFunctions<Scalar> SpatialLeg::limits(const Spatial<Scalar>& d, const Scalar& entry, int sign) const {
  if (!angle_limits_.limited() && !length_limits_.limited()) return {};
  const Scalar signed_entry = sign > 0 ? entry : -entry;
  switch (type_) {
    case LegType::revolute:
      break;
    case LegType::prismatic:
      return length_limits_.functions<Scalar>(dot(axis_, d) - signed_entry);
    case LegType::strut:
      return length_limits_.functions_of_square<Scalar>(squared_norm(d));
    case LegType::elbow:
      return angle_limits_.functions<Scalar>(Interval(0.5) * squared_norm(d) - Scalar(half_sum_),
                                             Interval(-sense_) * signed_entry);
  }
  return limits_of_crank(d, signed_entry);
}

template <class Scalar>
LimitFunctions<Scalar> SpatialLeg::limits_of_crank(const Spatial<Scalar>& d,
                                                   const Scalar& signed_entry) const {
  const Scalar d1 = dot(zero_direction_, d), d2 = dot(side_direction_, d);
  const Scalar a = Interval(0.5) * squared_norm(d) - Scalar(half_difference_);
  return angle_limits_.functions<Scalar>(a * d1 + signed_entry * d2, a * d2 - signed_entry * d1);
}

template <class Scalar>
std::optional<LinkPoints<Scalar, 3>> SpatialLeg::link_points(const Spatial<Scalar>& d, const Scalar& entry,
                                                             int sign) const {
  LinkPoints<Scalar, 3> points;
  points.length = Scalar(rod_);
  for (std::size_t i = 0; i < 3; ++i) {
    points.base[i] = points.joint[i] = Scalar(base_[i]);
    points.anchor[i] = points.base[i] + d[i];
  }
  const Scalar signed_entry = sign > 0 ? entry : -entry;
  switch (type_) {
    case LegType::revolute:
      if (!find_tip(d, signed_entry, points)) return std::nullopt;
      break;
    case LegType::prismatic: {
      const Scalar slide = dot(axis_, d) - signed_entry;
      for (std::size_t i = 0; i < 3; ++i) points.joint[i] = points.base[i] + axis_[i] * slide;
      break;
    }
    case LegType::strut:
      points.length = entry;
      break;
    case LegType::elbow:
      break;
  }
  return points;
}

template <class Scalar>
bool SpatialLeg::find_tip(const Spatial<Scalar>& d, const Scalar& signed_entry,
                          LinkPoints<Scalar, 3>& points) const {
  const Scalar d1 = dot(zero_direction_, d), d2 = dot(side_direction_, d);
  const Scalar in_plane = square(d1) + square(d2);
  const double least = range_of(in_plane).lower();
  if (!(least > 0.0)) return false;
  const Scalar scale = reciprocal(in_plane, least);
  const Scalar a = Interval(0.5) * squared_norm(d) - Scalar(half_difference_);
  const Scalar first = scale * (a * d1 + signed_entry * d2), second = scale * (a * d2 - signed_entry * d1);
  for (std::size_t i = 0; i < 3; ++i)
    points.joint[i] = points.base[i] + zero_direction_[i] * first + side_direction_[i] * second;
  return true;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_SPATIAL_LEG_H
