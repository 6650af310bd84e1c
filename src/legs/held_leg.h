// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_HELD_LEG_H
#define PARALLEL_ASPECTS_LEGS_HELD_LEG_H

#include "interval/half_turns.h"
#include "interval/interval.h"
#include "legs/limit_verdict.h"
#include "legs/link_points.h"
#include "legs/planar_leg.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/model/manipulator.h"

namespace parallel_aspects {

Spatial<Interval> scaled(const Interval& factor, const Spatial<Interval>& v) noexcept;
Spatial<Interval> sum_of(const Spatial<Interval>& a, const Spatial<Interval>& b) noexcept;

/// c and rho of a leg whose actuated joint is held at q, or somewhere in q. Must be made under a live
/// `RoundingUpward`; not of an actuated elbow.
class HeldPoint {
 public:
  HeldPoint(const Leg& leg, const Interval& q);

  Spatial<Interval> c;                     ///< [m]
  Spatial<Interval> slope{0.0, 0.0, 0.0};  ///< c', by q
  Interval squared_rod;                    ///< rho^2 [m^2]
  Interval rod_slope{0.0};                 ///< rho rho', half the derivative of rho^2

 private:
  void set(const RevoluteActuation& crank);
  void set(const PrismaticActuation& rail);
  void set(const StrutActuation& strut);
  void set(const ElbowActuation& elbow);

  Interval q_;
};

/// A leg of the x-y plane whose actuated joint is held at q: c(q) and rho(q) are constants, so that the
/// anchor runs on a circle about c. Of a range of q everything is enclosed for each value of it. Must be made
/// under a live `RoundingUpward`; not of an actuated elbow.
///
/// B_jj = lever . u depends on the direction of u = p - c alone. It crosses zero with a slope that is not
/// zero; B_jj^2 does not. So the condition that B_jj has the sign of a branch is tested like a joint limit,
/// and B_jj^2 is only said to be positive.
class HeldLeg {
 public:
  /// `serial_margin`: the least |B_jj| over its largest value; 0 for none.
  HeldLeg(const Leg& leg, const Interval& q, double serial_margin);

  /// c in the plane [m].
  const Planar<Interval>& center() const noexcept { return center_; }

  /// The derivative of c by q, and the second one.
  const Planar<Interval>& center_slope() const noexcept { return lever_; }
  Planar<Interval> center_bend() const noexcept {
    return turns_ ? Planar<Interval>{base_.x - center_.x, base_.y - center_.y} : Planar<Interval>{0.0, 0.0};
  }

  /// Derivatives by q of the length of the rod in the plane, which must not vanish.
  Interval length_slope() const noexcept { return half_square_slope() * reciprocal(length_); }

  /// Of half the square of that length.
  Interval half_square_slope() const noexcept { return rod_slope_ * rod_; }

  /// u, of this direction.
  template <class Scalar>
  Planar<Scalar> rod(const Turn<Scalar>& direction) const {
    return {length_ * direction.cosine, length_ * direction.sine};
  }

  /// With u, and a bound of B_jj^2 that does not vanish.
  template <class Scalar>
  PlanarLegForm<Scalar> form(const Planar<Scalar>& u) const {
    return {Scalar(largest_square_), u, {Scalar(0.0), Scalar(0.0)}};
  }

  /// Positive where B_jj has this sign and keeps its margin. None for a strut, which has one branch.
  template <class Scalar>
  LimitFunctions<Scalar> branch(const Planar<Scalar>& u, int sign) const {
    LimitFunctions<Scalar> result;
    if (!has_lever_) return result;
    const Scalar entry = lever_.x * u.x + lever_.y * u.y;
    result.add((sign > 0 ? entry : -entry) - Scalar(least_entry_));
    return result;
  }

  /// Where the links end.
  template <class Scalar>
  LinkPoints<Scalar, 2> link_points(const Planar<Scalar>& u) const {
    const Scalar x(center_.x), y(center_.y);
    return {{Scalar(base_.x), Scalar(base_.y)}, {x, y}, {x + u.x, y + u.y}, Scalar(rod_)};
  }

 private:
  void set(const RevoluteActuation& crank, const Leg& leg, const Interval& q);
  void set(const PrismaticActuation& rail, const Leg& leg, const Interval& q);
  void set(const StrutActuation& strut, const Leg& leg, const Interval& q);
  void set(const ElbowActuation& elbow, const Leg& leg, const Interval& q);
  void set_rod(const Interval& rod, const Interval& height);

  bool has_lever_ = true, turns_ = false;
  Planar<Interval> base_, center_, lever_{0.0, 0.0};
  Interval rod_slope_{0.0};            // of the rod in space, by q
  Interval rod_, length_;              // of the rod in space, in the plane
  Interval largest_, largest_square_;  // |B_jj| at right angles; its square
  Interval least_entry_;
};

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_HELD_LEG_H
