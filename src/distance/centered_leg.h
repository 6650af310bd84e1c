// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_DISTANCE_CENTERED_LEG_H
#define PARALLEL_ASPECTS_DISTANCE_CENTERED_LEG_H

#include "interval/interval.h"
#include "legs/determinant.h"
#include "legs/leg_rows.h"
#include "parallel_aspects/model/manipulator.h"

#include <array>

namespace parallel_aspects {

/// The rows of `SpatialLeg::form` where the anchor turns about a point from which it is seen at b, and the
/// base point at -e. |b|^2 is constant and b x b is zero: where enclosures are polynomials cut off at an
/// order, nothing is cut off of these products. Of the exact dimensions; must be made under a live
/// `RoundingUpward`.
class CenteredLeg {
 public:
  template <class Scalar>
  using Vector = std::array<Scalar, 3>;

  explicit CenteredLeg(const Leg& leg);

  /// B_jj^2 and the row of A, moments about that point.
  template <class Scalar>
  LegRows<Scalar, 6> rows(const Vector<Scalar>& b, const Vector<Scalar>& e, const Interval& squared_b,
                          const Scalar& squared_e) const noexcept;

 private:
  template <class Scalar>
  struct View {
    Vector<Scalar> b, d, moment;          // b + e, b x e
    Scalar squared_distance, lengthwise;  // |d|^2, b . d
  };

  void set(const RevoluteActuation& actuation, double rod);
  void set(const PrismaticActuation& actuation, double rod);
  void set(const StrutActuation&, double) {}
  void set(const ElbowActuation& actuation, double rod);

  template <class Scalar>
  LegRows<Scalar, 6> rows_of_crank(const View<Scalar>& view) const noexcept;
  template <class Scalar>
  LegRows<Scalar, 6> rows_of_slide(const View<Scalar>& view) const noexcept;

  template <class Scalar>
  Scalar along_axis(const Vector<Scalar>& v) const noexcept {
    return axis_[0] * v[0] + axis_[1] * v[1] + axis_[2] * v[2];
  }
  template <class Scalar>
  Vector<Scalar> axis_cross(const Vector<Scalar>& v) const noexcept {
    return {axis_[1] * v[2] - axis_[2] * v[1], axis_[2] * v[0] - axis_[0] * v[2],
            axis_[0] * v[1] - axis_[1] * v[0]};
  }
  // Zero where two links are stretched or folded.
  template <class Scalar>
  Scalar quarter_of_reach(const Scalar& w) const noexcept {
    return Interval(0.25) * ((squared_longest_ - w) * (w - squared_shortest_));
  }

  LegType type_;
  Vector<Interval> axis_;
  Interval squared_rod_, squared_crank_, half_difference_;  // (rod^2 - crank^2) / 2
  Interval axial_share_;  // 2 - |axis|^2 of an actuated prismatic joint: 1, but for the rounding of the axis
  Interval squared_longest_, squared_shortest_;  // two links stretched, folded
};

template <class Scalar>
LegRows<Scalar, 6> CenteredLeg::rows(const Vector<Scalar>& b, const Vector<Scalar>& e,
                                     const Interval& squared_b, const Scalar& squared_e) const noexcept {
  const Scalar product = b[0] * e[0] + b[1] * e[1] + b[2] * e[2], lengthwise = product + Scalar(squared_b);
  const View<Scalar> view{
      b, {b[0] + e[0], b[1] + e[1], b[2] + e[2]}, cross(b, e), squared_e + product + lengthwise, lengthwise};
  if (type_ == LegType::revolute) return rows_of_crank(view);
  if (type_ == LegType::prismatic) return rows_of_slide(view);
  const Scalar& w = view.squared_distance;
  LegRows<Scalar, 6> result;
  result.squared_b_entry = type_ == LegType::strut ? w : quarter_of_reach(w);
  for (std::size_t i = 0; i < 3; ++i) {
    result.fixed[i] = view.moment[i];
    result.fixed[3 + i] = view.d[i];
  }
  return result;
}

// With D = |d|^2 - along^2 and a = (|d|^2 + crank^2 - rod^2) / 2:  D u = (D - a) d + a along axis + B (axis x
// d), and  b x (axis x d) = (b . d) axis - (axis . b) d.
template <class Scalar>
LegRows<Scalar, 6> CenteredLeg::rows_of_crank(const View<Scalar>& view) const noexcept {
  const Scalar &w = view.squared_distance, along = along_axis(view.d), squared_along = square(along);
  const Scalar a = Interval(0.5) * w - half_difference_, k = (w - squared_along) - a, lift = a * along;
  const Vector<Scalar> around = axis_cross(view.b), turned = axis_cross(view.d);
  const Scalar axial = along_axis(view.b);
  LegRows<Scalar, 6> result;
  result.squared_b_entry = quarter_of_reach(w) - squared_crank_ * squared_along;
  for (std::size_t i = 0; i < 3; ++i) {
    result.fixed[i] = k * view.moment[i] - lift * around[i];
    result.fixed[3 + i] = k * view.d[i] + axis_[i] * lift;
    result.turned[i] = axis_[i] * view.lengthwise - axial * view.d[i];
    result.turned[3 + i] = turned[i];
  }
  return result;
}

// u is d less its part along the axis, and B times the axis.
template <class Scalar>
LegRows<Scalar, 6> CenteredLeg::rows_of_slide(const View<Scalar>& view) const noexcept {
  const Scalar along = along_axis(view.d);
  const Vector<Scalar> around = axis_cross(view.b);
  LegRows<Scalar, 6> result;
  result.squared_b_entry = squared_rod_ - (view.squared_distance - axial_share_ * square(along));
  for (std::size_t i = 0; i < 3; ++i) {
    result.fixed[i] = view.moment[i] + along * around[i];
    result.fixed[3 + i] = view.d[i] - axis_[i] * along;
    result.turned[i] = -around[i];
    result.turned[3 + i] = axis_[i];
  }
  return result;
}

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_DISTANCE_CENTERED_LEG_H
