// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_PLANAR_LEG_H
#define PARALLEL_ASPECTS_LEGS_PLANAR_LEG_H

#include "interval/dual.h"
#include "interval/half_turns.h"
#include "interval/interval.h"
#include "interval/scalar_range.h"
#include "legs/limit_verdict.h"
#include "legs/link_points.h"
#include "parallel_aspects/model/manipulator.h"

#include <optional>

namespace parallel_aspects {

/// A vector of the x-y plane over numbers, intervals or duals.
template <class Scalar>
struct Planar {
  Scalar x, y;

  const Scalar& operator[](std::size_t i) const { return i == 0 ? x : y; }
};

template <class Scalar>
Scalar squared_norm(const Planar<Scalar>& d) {
  return square(d.x) + square(d.y);
}

/// A leg seen from the displacement d = p - base point of its anchor. For both signs s of B_jj,
/// |B_jj| = sqrt(squared_b_entry), and u = p - c has the direction of `fixed + s sqrt(squared_b_entry)
/// turned`.
template <class Scalar>
struct PlanarLegForm {
  Scalar squared_b_entry;
  Planar<Scalar> fixed, turned;
};

/// A distance leg whose actuated joint and anchor move in parallels of the x-y plane, with its constants
/// enclosed for every robot within `Leg::tolerance`. Must be made under a live `RoundingUpward`.
///
/// `SpatialLeg` would do, in more time: with it, through `SliceChart`, maps take 1.4 times the processor time
/// (five_bar), 1.13 (three_rpr), 1.29 (three_prr) and 1.55 (three_rrr). In the plane fewer products enclose
/// the same numbers, and often more tightly.
class PlanarLeg {
 public:
  explicit PlanarLeg(const Leg& leg);

  /// The base point in the plane [m].
  const Planar<Interval>& base() const noexcept { return base_; }

  /// No anchor within reach is farther from the base point than this, seen in the plane [m]; may be infinite.
  double reach() const noexcept { return reach_; }

  /// The length of the crank where the rod is as long, so that B_jj^2 vanishes at d = 0 as a sum of two
  /// squares [m].
  std::optional<double> crank_that_folds() const noexcept;

  template <class Scalar>
  PlanarLegForm<Scalar> form(const Planar<Scalar>& d) const;

  /// The positive factor k by which the direction of `form` is longer than u: it is k u.
  template <class Scalar>
  Scalar scale(const Planar<Scalar>& d) const {
    return type_ == LegType::revolute ? squared_norm(d) : Scalar(1.0);
  }

  /// The square of the length of the direction of `form`, in the plane.
  template <class Scalar>
  Scalar squared_rod(const Planar<Scalar>& d) const;

  /// See SpatialLeg; angles are from x here.
  std::optional<RodOnArc<PlanarLegForm>> rod_on_arc(const Planar<Interval>& d, const Turn<Interval>& turn,
                                                    int sign) const;

  /// Limits of the joint value of branch `sign`, where |B_jj| is `entry`.
  template <class Scalar>
  LimitFunctions<Scalar> limits(const Planar<Scalar>& d, const Scalar& entry, int sign) const;

  /// Where the links of branch `sign` end, where |B_jj| is `entry`. Nothing where the box is too large to
  /// tell.
  template <class Scalar>
  std::optional<LinkPoints<Scalar, 2>> link_points(const Planar<Scalar>& d, const Scalar& entry,
                                                   int sign) const;

 private:
  void set(const RevoluteActuation& actuation, const Leg& leg);
  void set(const PrismaticActuation& actuation, const Leg& leg);
  void set(const StrutActuation& actuation, const Leg& leg);
  void set(const ElbowActuation& actuation, const Leg& leg);
  void set_base(const Leg& leg);
  void set_two_links(const Interval& squared_first, const Interval& squared_second);

  /// Parts of `form`, `limits` and `link_points` for a crank.
  template <class Scalar>
  PlanarLegForm<Scalar> form_with_crank(const Planar<Scalar>& d) const;
  template <class Scalar>
  LimitFunctions<Scalar> limits_of_crank(const Planar<Scalar>& d, const Scalar& signed_entry) const;
  template <class Scalar>
  bool find_tip(const Planar<Scalar>& d, const Scalar& signed_entry, LinkPoints<Scalar, 2>& points) const;

  /// The joint value of an actuated prismatic joint.
  template <class Scalar>
  Scalar slide(const Planar<Scalar>& d, const Scalar& signed_entry) const {
    return direction_.x * d.x + direction_.y * d.y - signed_entry;
  }

  LegType type_;
  double reach_ = 0.0;
  Planar<Interval> base_;
  Interval squared_height_;                         // of the anchor over the base point, out of the plane
  Interval squared_longest_, squared_shortest_;     // two links stretched, folded
  Interval rod_;                                    // in space
  Interval crank_, squared_rod_, half_difference_;  // rod in the plane; (rod^2 - crank^2) / 2
  Interval half_sum_;                               // (inner^2 + outer^2) / 2 of an elbow
  Planar<Interval> direction_;                      // of an actuated prismatic joint
  double sense_ = 1.0;                              // of turning about z, or of a strut or elbow
  AngleLimits angle_limits_;
  LengthLimits length_limits_;
};

template <class Scalar>
PlanarLegForm<Scalar> PlanarLeg::form(const Planar<Scalar>& d) const {
  switch (type_) {
    case LegType::revolute:
      break;
    case LegType::prismatic: {
      const Scalar across = direction_.x * d.y - direction_.y * d.x;
      return {squared_rod_ - square(across),
              {-(direction_.y * across), direction_.x * across},
              {direction_.x, direction_.y}};
    }
    case LegType::strut:
      return {squared_norm(d) + Scalar(squared_height_), d, {0.0, 0.0}};
    case LegType::elbow: {
      const Scalar spatial = squared_norm(d) + Scalar(squared_height_);
      return {Interval(0.25) * ((squared_longest_ - spatial) * (spatial - squared_shortest_)), d, {0.0, 0.0}};
    }
  }
  return form_with_crank(d);
}

template <class Scalar>
PlanarLegForm<Scalar> PlanarLeg::form_with_crank(const Planar<Scalar>& d) const {
  const Scalar squared_distance = squared_norm(d);
  const Scalar along = Interval(0.5) * squared_distance + Scalar(half_difference_);
  const Planar<Scalar> turned = sense_ > 0.0 ? Planar<Scalar>{-d.y, d.x} : Planar<Scalar>{d.y, -d.x};
  return {Interval(0.25) * ((squared_longest_ - squared_distance) * (squared_distance - squared_shortest_)),
          {along * d.x, along * d.y},
          turned};
}

template <class Scalar>
Scalar PlanarLeg::squared_rod(const Planar<Scalar>& d) const {
  switch (type_) {
    case LegType::revolute:
      return squared_rod_ * square(squared_norm(d));
    case LegType::prismatic:
      return Scalar(squared_rod_);
    case LegType::strut:
    case LegType::elbow:
      break;
  }
  return squared_norm(d);
}

template <class Scalar>
LimitFunctions<Scalar> PlanarLeg::limits(const Planar<Scalar>& d, const Scalar& entry, int sign) const {
  if (!angle_limits_.limited() && !length_limits_.limited()) return {};
  const Scalar signed_entry = sign > 0 ? entry : -entry;
  switch (type_) {
    case LegType::revolute:
      break;
    case LegType::prismatic:
      return length_limits_.functions<Scalar>(slide(d, signed_entry));
    case LegType::strut:
      return length_limits_.functions_of_square<Scalar>(squared_norm(d) + Scalar(squared_height_));
    case LegType::elbow:
      return angle_limits_.functions<Scalar>(
          Interval(0.5) * (squared_norm(d) + Scalar(squared_height_)) - Scalar(half_sum_),
          Interval(-sense_) * signed_entry);
  }
  return limits_of_crank(d, signed_entry);
}

// The crank points along a d - B_jj (axis x d), mirrored where the axis points down so that angles grow with
// q.
template <class Scalar>
LimitFunctions<Scalar> PlanarLeg::limits_of_crank(const Planar<Scalar>& d, const Scalar& signed_entry) const {
  const Planar<Scalar> mirrored{d.x, Interval(sense_) * d.y};
  const Scalar along = Interval(0.5) * squared_norm(d) - Scalar(half_difference_);
  return angle_limits_.functions<Scalar>(along * mirrored.x + signed_entry * mirrored.y,
                                         along * mirrored.y - signed_entry * mirrored.x);
}

template <class Scalar>
std::optional<LinkPoints<Scalar, 2>> PlanarLeg::link_points(const Planar<Scalar>& d, const Scalar& entry,
                                                            int sign) const {
  const Scalar x(base_.x), y(base_.y), signed_entry = sign > 0 ? entry : -entry;
  LinkPoints<Scalar, 2> points{{x, y}, {x, y}, {x + d.x, y + d.y}, Scalar(rod_)};
  switch (type_) {
    case LegType::revolute:
      if (!find_tip(d, signed_entry, points)) return std::nullopt;
      break;
    case LegType::prismatic: {
      const Scalar value = slide(d, signed_entry);
      points.joint = {x + direction_.x * value, y + direction_.y * value};
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
bool PlanarLeg::find_tip(const Planar<Scalar>& d, const Scalar& signed_entry,
                         LinkPoints<Scalar, 2>& points) const {
  const Scalar squared_distance = squared_norm(d);
  const double least = std::max(range_of(squared_distance).lower(), squared_shortest_.lower());
  if (!(least > 0.0)) return false;
  const Scalar scale = reciprocal(squared_distance, least);
  const Scalar along = Interval(0.5) * squared_distance - Scalar(half_difference_);
  const Scalar across = Interval(sense_) * signed_entry;
  points.joint = {points.base[0] + scale * (along * d.x + across * d.y),
                  points.base[1] + scale * (along * d.y - across * d.x)};
  return true;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_PLANAR_LEG_H
