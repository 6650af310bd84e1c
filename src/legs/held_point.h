// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_LEGS_HELD_POINT_H
#define PARALLEL_ASPECTS_LEGS_HELD_POINT_H

#include "interval/interval.h"
#include "legs/spatial_leg.h"
#include "parallel_aspects/model/leg.h"

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

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_LEGS_HELD_POINT_H
